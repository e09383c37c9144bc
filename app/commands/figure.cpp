#include "commands/figure.h"

#include "commands/outputfile.h"
#include "commands/streams.h"
#include "document/evaluateddocument.h"
#include "figures/deviationfigure.h"
#include "ui/figures/exportfigure.h"

#include <QFileInfo>
#include <array>

namespace palmer {

namespace {

constexpr std::array options{
    Option{"o", "OUT.svg|png|pdf", REPORT_TEXT("report", "the picture to write; its ending says what it is")},
    Option{"test", "N", REPORT_TEXT("report", "which test of the file, from 1; without it the first")},
    Option{"figure", "deviation", REPORT_TEXT("report", "which figure; without it that of the test")},
};

/// Index of the test asked for.
std::size_t testIndex(const Invocation &invocation, std::size_t count) {
    const QString word = invocation.value(QLatin1StringView("test")).value_or(QStringLiteral("1"));
    bool isNumber = false;
    const uint number = word.toUInt(&isNumber);
    if (!isNumber || number < 1 || number > count)
        throw UsageError({REPORT_TEXT("report", "there is no test %1; the file has %2"),
                          {word.toStdString(), Number{static_cast<double>(count), Quantity::count}}});
    return number - 1;
}

QByteArray picture(const Figure &figure, const QString &title, const QString &ending) {
    if (ending == QLatin1StringView("svg"))
        return ui::figureAsSvg(figure, title);
    if (ending == QLatin1StringView("png"))
        return ui::figureAsPng(figure);
    return ui::figureAsPdf(figure, title);
}

int run(const Invocation &invocation) {
    const auto output = invocation.value(QLatin1StringView("o"));
    const QString ending = QFileInfo(output.value_or(QString())).suffix().toLower();
    if (ending != QLatin1StringView("svg") && ending != QLatin1StringView("png") &&
        ending != QLatin1StringView("pdf"))
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file to write (%2)"),
                          {std::string("figure"), std::string("-o OUT.svg|png|pdf")}});
    if (invocation.arguments.size() != 1)
        throw UsageError({REPORT_TEXT("report", "the command %1 takes one file"), {std::string("figure")}});
    const QString wanted =
        invocation.value(QLatin1StringView("figure")).value_or(QStringLiteral("deviation"));
    if (wanted != QLatin1StringView("deviation"))
        throw UsageError(
            {REPORT_TEXT("report", "unknown figure %1; known: %2"), {wanted.toStdString(), "deviation"}});
    const QString file = invocation.arguments.front();
    try {
        const EvaluatedDocument evaluated =
            evaluate(std::make_shared<const Document>(documentFrom(file, invocation.language)), nullptr, {});
        const std::size_t index = testIndex(invocation, evaluated.tests.size());
        const Test &test = *evaluated.document->tests[index];
        if (!std::holds_alternative<PositioningMeasurement>(test.measurement))
            throw UsageError({REPORT_TEXT("report", "the test %1 has no figure %2"),
                              {Number{static_cast<double>(index + 1), Quantity::count}, "deviation"}});
        const CurveFigure figure = deviationFigure(test, *evaluated.tests[index], invocation.language);
        try {
            writeOutput(picture(figure, figure.title, ending), *output);
        } catch (const Error &error) {
            printError(*output, error, invocation.language);
            return cannotRead;
        }
        return done;
    } catch (const Error &error) {
        printError(file, error, invocation.language);
        return cannotRead;
    }
}

} // namespace

Command figureCommand() {
    return {"figure", "FILE", REPORT_TEXT("report", "one figure as a picture"), options, run, true};
}

} // namespace palmer
