#include "commands/export.h"

#include "commands/outputfile.h"
#include "commands/streams.h"
#include "export/compensation.h"
#include "export/readingscsv.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/surroundings.h"

#include <array>

namespace palmer {

namespace {

constexpr std::array options{
    Option{"as", "csv|json|linuxcnc|siemens|compensation-csv",
           REPORT_TEXT("report", "what to write: readings and results, or a compensation table")},
    Option{"o", "OUT", REPORT_TEXT("report", "the file to write")},
    Option{"test", "N", REPORT_TEXT("report", "which test of the file, from 1; without it the first")},
    Option{"decimal-mark", "point|comma", REPORT_TEXT("report", "of CSV; without it the point")},
    Option{"from", "P",
           REPORT_TEXT("report", "first position of the compensation; without it the first target")},
    Option{"to", "P", REPORT_TEXT("report", "last position of the compensation; without it the last target")},
    Option{"interval", "D", REPORT_TEXT("report", "interval of the compensation; without it the targets")},
    Option{"per-direction", "",
           REPORT_TEXT("report", "compensation of each direction; without it of their mean")},
    Option{"incremental", "",
           REPORT_TEXT("report", "compensation-csv: each value is the step from the one before")},
    Option{"deviations", "",
           REPORT_TEXT("report", "compensation-csv: values with the sign of the deviations; without it "
                                 "corrections, added to the command")},
    Option{"encoder", "N",
           REPORT_TEXT("report", "siemens: index of the measuring system; without it 0, the first")},
    foreignOptions[0],
    foreignOptions[1],
    foreignOptions[2],
};

std::optional<double> numberOption(const Invocation &invocation, QLatin1StringView name) {
    const auto word = invocation.value(name);
    if (!word)
        return {};
    bool isNumber = false;
    const double value = QString(*word).replace(u',', u'.').toDouble(&isNumber);
    if (!isNumber)
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; expected a number"),
                          {std::string(name.latin1()), word->toStdString()}});
    return value;
}

std::size_t testIndex(const Invocation &invocation, std::size_t count) {
    const QString word = invocation.value(QLatin1StringView("test")).value_or(QStringLiteral("1"));
    bool isNumber = false;
    const uint number = word.toUInt(&isNumber);
    if (!isNumber || number < 1 || number > count)
        throw UsageError({REPORT_TEXT("report", "there is no test %1; the file has %2"),
                          {word.toStdString(), Number{static_cast<double>(count), Quantity::count}}});
    return number - 1;
}

std::optional<CompensationFormat> compensationFormat(const QString &word) {
    if (word == QLatin1StringView("linuxcnc"))
        return CompensationFormat::linuxcnc;
    if (word == QLatin1StringView("siemens"))
        return CompensationFormat::siemens;
    if (word == QLatin1StringView("compensation-csv"))
        return CompensationFormat::csv;
    return {};
}

char decimalMark(const Invocation &invocation) {
    const QString word =
        invocation.value(QLatin1StringView("decimal-mark")).value_or(QStringLiteral("point"));
    if (word != QLatin1StringView("point") && word != QLatin1StringView("comma"))
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; known: %3"),
                          {std::string("decimal-mark"), word.toStdString(), std::string("point, comma")}});
    return word == QLatin1StringView("comma") ? ',' : '.';
}

CompensationOptions compensationOptions(const Invocation &invocation) {
    CompensationOptions result;
    result.from = numberOption(invocation, QLatin1StringView("from"));
    result.to = numberOption(invocation, QLatin1StringView("to"));
    result.interval = numberOption(invocation, QLatin1StringView("interval"));
    result.perDirection = invocation.has(QLatin1StringView("per-direction"));
    result.incremental = invocation.has(QLatin1StringView("incremental"));
    result.deviations = invocation.has(QLatin1StringView("deviations"));
    result.decimalMark = decimalMark(invocation);
    result.encoder = static_cast<int>(numberOption(invocation, QLatin1StringView("encoder")).value_or(0));
    return result;
}

/// E, M, B and what else the edition has, before and after: from the table as it was written.
void printPrediction(const Test &test, const TestEvaluation &before, const QByteArray &written,
                     const Document &document, const Language &language) {
    const Test after = compensated(test, readCompensation(written));
    Surroundings surroundings;
    surroundings.machine = &document.machine;
    const TestEvaluation predicted = evaluateTest(after, surroundings);
    printError(language.text(REPORT_TEXT("report", "predicted with the compensation applied:")));
    for (std::size_t i = 0; i < std::min(before.parameters.size(), predicted.parameters.size()); ++i) {
        const Parameter &parameter = before.parameters[i];
        const auto &value = predicted.parameters[i].value;
        if (parameter.value && value)
            printError(QString::fromStdString(plainSymbol(parameter)) + QStringLiteral(": ") +
                       language.quantity(*parameter.value, parameter.term.quantity, 2) +
                       QStringLiteral(" → ") + language.quantity(*value, parameter.term.quantity, 2));
    }
}

int run(const Invocation &invocation) {
    const auto output = invocation.value(QLatin1StringView("o"));
    const QString form = invocation.value(QLatin1StringView("as")).value_or(QString());
    const auto compensation = compensationFormat(form);
    if (!compensation && form != QLatin1StringView("csv") && form != QLatin1StringView("json"))
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; known: %3"),
                          {std::string("as"), form.toStdString(),
                           std::string("csv, json, linuxcnc, siemens, compensation-csv")}});
    if (!output)
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file to write (%2)"),
                          {std::string("export"), std::string("-o OUT")}});
    if (invocation.arguments.size() != 1)
        throw UsageError({REPORT_TEXT("report", "the command %1 takes one file"), {std::string("export")}});
    const CompensationOptions table = compensationOptions(invocation);
    const QString file = invocation.arguments.front();
    const Language names = invocation.languageChosen ? invocation.language : Language(Language::Id::english);
    try {
        std::optional<Document> document = documentFrom(file, invocation);
        if (!document)
            return cannotRead; // questions about it are open
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(std::move(*document)));
        QByteArray bytes;
        std::size_t index = 0;
        if (form == QLatin1StringView("json")) {
            bytes = readingsJson(evaluated, file, names);
        } else {
            index = testIndex(invocation, evaluated.tests.size());
            const Test &test = *evaluated.document->tests[index];
            const TestEvaluation &evaluation = *evaluated.tests[index];
            bytes = compensation
                        ? writeCompensation(compensationTable(test, evaluation, *compensation, table),
                                            *compensation, table)
                        : readingsCsv(test, evaluation, names, table.decimalMark);
        }
        try {
            writeOutput(bytes, *output);
        } catch (const Error &error) {
            printError(*output, error, invocation.language);
            return cannotRead;
        }
        if (compensation)
            printPrediction(*evaluated.document->tests[index], *evaluated.tests[index], bytes,
                            *evaluated.document, invocation.language);
        return done;
    } catch (const Error &error) {
        printError(file, error, invocation.language);
        return cannotRead;
    }
}

} // namespace

Command exportCommand() {
    return {"export", "FILE",
            REPORT_TEXT("report", "readings and results, or a compensation table with what it would bring"),
            options, run};
}

} // namespace palmer
