// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/preparation.h"
#include "commandline/streams.h"
#include "document/evaluateddocument.h"
#include "figures/circlefigure.h"
#include "figures/diagnosisfigure.h"
#include "figures/figuretexts.h"
#include "figures/testfigures.h"
#include "kernel/measurement/testfacts.h"
#include "print/figures/exportfigure.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace palmer {

namespace {

constexpr const char *asOption = "as";

constexpr auto figureOptions = optionList(
    Option{"o", "OUT.svg|png|pdf|csv",
           REPORT_TEXT("report",
                       "the picture to write, or its points; the ending says which; of several files "
                       "the folder they go into")},
    Option{asOption, "svg|png|pdf|csv",
           REPORT_TEXT("report", "the kind of picture; without it the ending of OUT says which")},
    Option{"test", "N", REPORT_TEXT("report", "which test of the file, from 1; without it the first")},
    Option{"figure", "deviation|circle|counterclockwise|clockwise|budget|diagnosis",
           REPORT_TEXT("report", "which figure; without it that of the test")},
    nameOption, jobsOption, preparationOptions[0], foreignOptions);

constexpr const char *deviationWord = "deviation";
constexpr const char *budgetWord = "budget";
constexpr const char *diagnosisWord = "diagnosis";

struct CircleWord {
    const char *word = nullptr;
    CircleOf of = CircleOf::both;
};

constexpr std::array circleWords{
    CircleWord{"circle", CircleOf::both},
    CircleWord{"counterclockwise", CircleOf::counterclockwise},
    CircleWord{"clockwise", CircleOf::clockwise},
};

struct NamedFigure {
    Figure figure;
    QString title;
};

[[noreturn]] void throwHasNoFigure(std::size_t index, const std::string &word) {
    throw UsageError({REPORT_TEXT("report", "the test %1 has no figure %2"),
                      {Number{static_cast<double>(index + 1), Quantity::count}, word}});
}

/// The requested figure; by default the main one of the kind of test.
NamedFigure figureOf(const EvaluatedDocument &evaluated, std::size_t index,
                     const std::optional<QString> &asked, const Language &language) {
    const Test &test = *evaluated.document->tests[index];
    const TestEvaluation &evaluation = *evaluated.tests[index];
    if (asked && *asked == QLatin1StringView(diagnosisWord)) {
        const auto diagnosed = diagnosedTest(evaluated, index);
        if (!diagnosed)
            throwHasNoFigure(index, diagnosisWord); // no circle, or too few points
        CircleFigure figure = diagnosisFigure(*diagnosed, language);
        return {figure, figure.title};
    }
    if (asked && *asked == QLatin1StringView(budgetWord)) {
        BarFigure figure = budgetFigure(test, evaluation, language);
        if (figure.bars.empty())
            throwHasNoFigure(index, budgetWord); // no budget required
        return {figure, figure.title};
    }
    if (!isCircle(test)) {
        const std::string word = asked.value_or(QLatin1StringView(deviationWord)).toStdString();
        const Figure figure = figureOfTest(test, evaluation, language);
        const auto &curves = std::get<CurveFigure>(figure);
        const bool isEmpty =
            curves.curves.empty() && !traitsOf(test).hasTargets; // only targets are drawn without
        if (word != deviationWord || isEmpty)
            throwHasNoFigure(index, word);
        return {figure, curves.title};
    }
    const std::string word = asked.value_or(QLatin1StringView(circleWords[0].word)).toStdString();
    const auto found =
        std::ranges::find_if(circleWords, [&](const CircleWord &one) { return one.word == word; });
    if (found == circleWords.end())
        throwHasNoFigure(index, word);
    CircleFigure figure = circleFigure(test, evaluation, language, {.of = found->of});
    if (figure.traces.empty())
        throwHasNoFigure(index, word); // the sense was not measured
    return {figure, figure.title};
}

QByteArray picture(const Figure &figure, const QString &title, const QString &ending,
                   const Language &language) {
    if (ending == QLatin1StringView("csv"))
        return figureCsv(figure, language, '.');
    if (ending == QLatin1StringView("svg"))
        return figureAsSvg(figure, title, language);
    if (ending == QLatin1StringView("png"))
        return figureAsPng(figure);
    return figureAsPdf(figure, title);
}

constexpr std::array endings{"svg", "png", "pdf", "csv"};

bool isEnding(const QString &ending) {
    return std::ranges::any_of(endings,
                               [&](const char *known) { return ending == QLatin1StringView(known); });
}

/// The picture format: --as, or the ending of the file, which must agree.
QString endingOf(const Invocation &invocation, const QString &output, bool several) {
    const auto asked = invocation.value(asOption);
    const QString ending = QFileInfo(output).suffix().toLower();
    if (output.isEmpty() || (!several && !asked && !isEnding(ending)))
        refuseWithoutOutput("figure", "-o " + std::string(figureOptions[0].value));
    if (several && !asked)
        throw UsageError(
            {REPORT_TEXT("report", "the pictures of several files go into a folder; choose their kind with "
                                   "--%1 svg, png, pdf or csv"),
             {std::string(asOption)}});
    if (!several && asked && ending != *asked && isEnding(ending))
        throw UsageError({REPORT_TEXT("report", "%1 says another kind of picture than --%2 %3"),
                          {output.toStdString(), std::string(asOption), asked->toStdString()}});
    return asked.value_or(ending);
}

int runFigure(const Invocation &invocation) {
    const Inputs inputs = inputsOf(invocation);
    const QString output = invocation.value("o").value_or(QString());
    const QString ending = endingOf(invocation, output, inputs.several);
    const auto wanted = invocation.value("figure");
    QStringList outputs{output};
    if (inputs.several) {
        outputs = outputsInFolder(invocation, output, inputs, u'.' + ending);
    } else {
        requireNoName(invocation);
        requireOutput(invocation, output, {"svg", "png", "pdf", "csv"});
    }
    return eachDocument(invocation, inputs, [&](const Input &input, Document document) -> JobResult {
        const EvaluatedDocument evaluated =
            evaluate(std::make_shared<const Document>(std::move(document)), nullptr, {});
        const std::size_t index = testIndex(invocation, evaluated.tests.size());
        const NamedFigure named = figureOf(evaluated, index, wanted, invocation.language);
        const QString &target = outputs.at(static_cast<qsizetype>(&input - inputs.list.data()));
        const auto write = [&]() -> int {
            if (inputs.several)
                makeFolderOf(target);
            writeOutput(picture(named.figure, named.title, ending, invocation.language), target);
            return done;
        };
        return {codeOf(target, invocation.language, write), {}};
    });
}

} // namespace

Command figureCommand() {
    return {"figure",      "FILE|FOLDER…", REPORT_TEXT("report", "one figure as a picture"),
            figureOptions, runFigure,      true};
}

} // namespace palmer
