// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/composereport.h"

#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "report/parts/comparedtests.h"
#include "report/parts/parts.h"
#include "report/parts/thermalparts.h"
#include "report/tables/findinglines.h"
#include "report/tables/resulttable.h"
#include "report/words/accordancetext.h"
#include "report/words/correctiontext.h"
#include "report/words/wording.h"

#include <QStringList>
#include <algorithm>
#include <iterator>

namespace palmer {

namespace {

/// Composes one test after the other in one language.
class Composer {
public:
    Composer(const EvaluatedDocument &evaluated, const Language &language)
        : m_evaluated(evaluated)
        , m_language(language)
        , m_write(language) {}

    void addResults(const Test &test, const TestEvaluation &evaluation) {
        addTitle(test, evaluation);
        withResults(test, evaluation, [&](const auto &measurement, const auto &results) {
            addOwn(test, evaluation, measurement, results);
        });
        if (evaluation.edition)
            m_report.blocks.emplace_back(verdictLine(test, evaluation));
        addFindings(evaluation);
    }

    void addFindingsOf(const Test &test, const TestEvaluation &evaluation) {
        addTitle(test, evaluation);
        if (evaluation.edition)
            m_report.blocks.emplace_back(Paragraph{accordanceText(test, evaluation, m_language, false)});
        addFindings(evaluation);
    }

    [[nodiscard]] Report take() { return std::move(m_report); }

private:
    [[nodiscard]] QString text(const Text &words) const { return m_write.text(words); }
    [[nodiscard]] QString say(const Text &words, std::vector<Argument> arguments) const {
        return m_write.say(words, std::move(arguments));
    }

    // ---- Head ------------------------------------------------------------------------------------------

    [[nodiscard]] QString title(const Test &test) const {
        if (!test.title.empty())
            return QString::fromStdString(test.title);
        return say(kindWords(test).listed, {nameOr(axesOf(test))});
    }

    [[nodiscard]] static std::string nameOr(const std::string &name) { return name.empty() ? "–" : name; }

    void addTitle(const Test &test, const TestEvaluation &evaluation) {
        QString heading = title(test);
        if (evaluation.edition)
            heading += QStringLiteral(" · ") + QString::fromUtf8(evaluation.edition->word);
        m_report.blocks.emplace_back(Heading{1, heading});
        if (partOr(false, evaluation.results, [](auto &results) -> decltype(results.stepCycleNotAgreed) {
                return results.stepCycleNotAgreed;
            }))
            m_report.blocks.emplace_back(
                Paragraph{text(REPORT_TEXT("report", "step cycle – not an ISO 230-2 acceptance result"))});
        if (evaluation.view)
            m_report.blocks.emplace_back(Paragraph{say(
                REPORT_TEXT("report", "Seen under another edition than that of the test (%1): no verdict."),
                {test.edition})});
    }

    [[nodiscard]] QString editionText(const Edition &edition) const {
        const QString word = QString::fromUtf8(edition.word);
        return edition.title.empty() ? word : word + u'\n' + text(edition.title);
    }

    [[nodiscard]] QString axisText(const PositioningMeasurement &m) const {
        const bool linear = m.axis.motion == Motion::linear;
        const Quantity along = linear ? Quantity::position : Quantity::angle;
        QString result = QString::fromStdString(nameOr(m.axis.name)) + QStringLiteral(", ") +
                         text(linear ? REPORT_TEXT("report", "linear") : REPORT_TEXT("report", "rotary"));
        if (m.axis.travel)
            result += QStringLiteral(", ") +
                      say(REPORT_TEXT("report", "axis travel %1"), {Number{*m.axis.travel, along, -1}});
        if (!m.targets.empty())
            result += QStringLiteral(", ") + say(REPORT_TEXT("report", "measurement travel %1"),
                                                 {Number{measurementTravel(m), along, positionDecimals(m)}});
        return result;
    }

    [[nodiscard]] QString countsText(const PositioningMeasurement &m,
                                     const PositioningResults &results) const {
        if (results.positiveRuns == results.negativeRuns)
            return say(REPORT_TEXT("report", "m = %1; n = %2 each way"),
                       {wholeNumber(m.targets.size()), wholeNumber(results.positiveRuns)});
        return say(REPORT_TEXT("report", "m = %1; n = %2 ↑, %3 ↓"),
                   {wholeNumber(m.targets.size()), wholeNumber(results.positiveRuns),
                    wholeNumber(results.negativeRuns)});
    }

    [[nodiscard]] QString ruleOf(const Test &test) const {
        return ruleWithBand(test.decisionRule, ruleWords(test.decisionRule.rule).condition, m_language);
    }

    [[nodiscard]] KeyValues positioningHead(const Test &test, const PositioningMeasurement &m,
                                            const TestEvaluation &evaluation,
                                            const PositioningResults &results) const {
        const Edition &edition = *evaluation.edition;
        LabelledRows head(m_write);
        head.add(REPORT_TEXT("report", "Edition"), editionText(edition));
        head.add(REPORT_TEXT("report", "Date of test"), m_language.date(test.date.value_or(std::string())));
        head.add(REPORT_TEXT("report", "Axis"), axisText(m));
        if (results.judgedAsZone)
            head.add(REPORT_TEXT("report", "Working zone"), zoneText(m));
        head.add(REPORT_TEXT("report", "Cycle"), text(cycleText(m.cycle, edition)));
        head.add(REPORT_TEXT("report", "Targets"), countsText(m, results));
        if (edition.rangeMethod)
            head.add(REPORT_TEXT("report", "Standard deviation"),
                     text(results.standardDeviation == DeviationMethod::range
                              ? REPORT_TEXT("report", "range method")
                              : REPORT_TEXT("report", "calculation method")));
        addCorrection(head, test, m.axis.motion == Motion::linear);
        return head.take();
    }

    /// Adds the correction to 20 °C if it counts for the results or is stated.
    void addCorrection(LabelledRows &head, const Test &test, bool counts) const {
        if (counts || conditionsOf(test)->correctionTo20 != CorrectionTo20::notStated)
            head.add(REPORT_TEXT("report", "Correction to 20 °C"), text(correctionText(test)));
    }

    [[nodiscard]] QString zoneText(const PositioningMeasurement &m) const {
        const Quantity along = positionQuantity(m.axis);
        return say(REPORT_TEXT("report", "%1 to %2"),
                   {Number{m.zone->from, along, -1}, Number{m.zone->to, along, -1}});
    }

    // ---- Results ---------------------------------------------------------------------------------------

    void addOwn(const Test &test, const TestEvaluation &evaluation, const PositioningMeasurement &m,
                const PositioningResults &results) {
        m_report.blocks.emplace_back(positioningHead(test, m, evaluation, results));
        addParameters(test, evaluation);
        if (!m.targets.empty() && (results.upward || results.downward)) {
            m_report.blocks.emplace_back(Heading{2, text(REPORT_TEXT("report", "Results per target"))});
            m_report.blocks.emplace_back(targetTable({{m_write, m_evaluated, test, evaluation}, m, results}));
        }
    }

    void addOwn(const Test &test, const TestEvaluation &evaluation, const CircularMeasurement &m,
                const CircularResults &results) {
        const auto length = [&](double value) { return m_language.quantity(value, Quantity::position); };
        LabelledRows head(m_write);
        if (evaluation.edition)
            head.add(REPORT_TEXT("report", "Edition"), editionText(*evaluation.edition));
        head.add(REPORT_TEXT("report", "Date of test"), m_language.date(test.date.value_or(std::string())));
        head.add(REPORT_TEXT("report", "Nominal radius"), length(m.nominalRadius));
        head.add(REPORT_TEXT("report", "Contouring feed"),
                 m.feed ? m_language.quantity(*m.feed, Quantity::feed) : QString());
        head.add(REPORT_TEXT("report", "Reference circle"),
                 text(m.referenceCircle == ReferenceCircle::minimumZone
                          ? REPORT_TEXT("report", "minimum zone circles (MZC)")
                          : REPORT_TEXT("report", "least squares circle (LSC)")));
        addCorrection(head, test, false);
        for (const EvaluatedPath &path : results.paths) {
            const QString sense = text(senseText(path.sense));
            head.add(REPORT_TEXT("report", "Path"),
                     m_language.sentence(REPORT_TEXT("report", "%1, %2: %3 points evaluated from %4 to %5"),
                                         {path.index, sense.toStdString(), wholeNumber(path.source.size()),
                                          Number{path.evaluated.from, Quantity::angle, 1},
                                          Number{path.evaluated.to, Quantity::angle, 1}}));
        }
        if (results.correction)
            head.add(REPORT_TEXT("report", "Correction of F and D to 20 °C"),
                     m_language.quantity(*results.correction, Quantity::deviation, 2));
        m_report.blocks.emplace_back(head.take());
        addParameters(test, evaluation);
        if (!results.paths.empty())
            std::ranges::move(diagnosisParts(diagnose(diagnosedCircle(m, results)), m_language),
                              std::back_inserter(m_report.blocks));
    }

    void addOwn(const Test &test, const TestEvaluation & /*evaluation*/, const DriftMeasurement &drift,
                const DriftResults &results) {
        if (hasThermalPage(test)) {
            const std::vector<ThermalChannel> channels = thermalChannels(drift);
            KeyValues ranges;
            for (const ThermalChannel &one : channels)
                ranges.rows.push_back(
                    {say(REPORT_TEXT("report", "E_VE of %1, whole record"), {shownName(one.channel)}),
                     one.whole ? m_language.quantity(one.whole->value,
                                                     one.channel.quantity == ChannelQuantity::deviation
                                                         ? Quantity::deviation
                                                         : Quantity::angularDeviation,
                                                     2)
                               : QString()});
            m_report.blocks.emplace_back(std::move(ranges));
            if (!drift.temperatures.empty())
                m_report.blocks.emplace_back(responseTable(drift, channels, m_language));
            for (const QString &note : thermalNotes(drift, channels, m_language))
                m_report.blocks.emplace_back(Paragraph{note, TextSize::small});
            return;
        }
        const Quantity quantity = deviationQuantity(drift);
        m_report.blocks.emplace_back(
            KeyValues{{{text(REPORT_TEXT("report", "Environmental variation error (max − min)")),
                        results.range ? m_language.quantity(*results.range, quantity, 2) : QString()}}});
    }

    [[nodiscard]] QString nameOf(const Parameter &parameter, bool isNotCorrected) const {
        QString name = text(parameter.term.name);
        if (const QString of = limitNote(parameter, m_language); !of.isEmpty())
            name += QStringLiteral(" (") + of + u')';
        if (isNotCorrected && parameter.dependsOnTemperature)
            name += QStringLiteral(" (") + text(REPORT_TEXT("report", "not corrected to 20 °C")) + u')';
        return name;
    }

    void addParameters(const Test &test, const TestEvaluation &evaluation) {
        const auto results = printedResults(*m_evaluated.document, test, evaluation, m_language);
        if (results.empty())
            return;
        const CoverageOfResults coverage = coverageOf(evaluation, m_evaluated.document->report);
        const QString unit = m_language.unit(results.front().parameter->term.quantity);
        auto columns = resultColumns(onTerminal);
        std::erase_if(columns, [&](const ResultColumn *column) { return column->axesOnly && !axisOf(test); });
        Table table;
        for (const ResultColumn *column : columns) {
            const bool isNumber = column->look == ResultLook::number;
            table.columns.push_back(
                {column->look == ResultLook::symbol ? QString()
                 : column->key == std::string_view("expandedUncertainty")
                     ? uncertaintyHead(coverage, m_language)
                 : column->axesOnly ? text(column->title) + u' ' + letterOfTargets(*evaluation.edition)
                                    : text(column->title),
                 isNumber ? unit : QString(), isNumber ? Alignment::decimal : Alignment::left,
                 column->look == ResultLook::name});
        }
        for (const PrintedResult &result : results) {
            const Parameter &parameter = *result.parameter;
            std::vector<Cell> row;
            row.reserve(columns.size());
            for (const ResultColumn *column : columns)
                row.emplace_back(column->look == ResultLook::symbol ? symbolPhrase(parameter)
                                 : column->look == ResultLook::name
                                     ? nameOf(parameter, notCorrected(evaluation))
                                     : column->shown({result, m_language}));
            table.rows.push_back(std::move(row));
        }
        table.rulesAfter = rulesBetween(results);
        m_report.blocks.emplace_back(Heading{2, text(REPORT_TEXT("report", "Results"))});
        m_report.blocks.emplace_back(std::move(table));
        if (coverage.mixed())
            m_report.blocks.emplace_back(
                Paragraph{QStringLiteral("U: ") + coverageNote(coverage, m_language), TextSize::small});
    }

    // ---- Verdict and findings --------------------------------------------------------------------------

    [[nodiscard]] VerdictLine verdictLine(const Test &test, const TestEvaluation &evaluation) const {
        QString limits = text(limitsText(evaluation.verdict, hasLimits(test.limits)));
        if (evaluation.verdict)
            limits += QStringLiteral(" (") + ruleOf(test) + u')';
        const QString unknown = notEvaluableSentence(evaluation, m_language);
        if (!unknown.isEmpty())
            limits += u'.';
        VerdictLine line;
        line.limits = {text(REPORT_TEXT_FOR("report", "Limits", "part of a verdict")), Mark::none, limits,
                       withSymbols(unknown, evaluation.parameters)};
        line.accordance = accordanceStatement(test, evaluation, m_language, false);
        return line;
    }

    void addFindings(const TestEvaluation &evaluation) {
        if (evaluation.findings.empty()) {
            m_report.blocks.emplace_back(Paragraph{text(REPORT_TEXT("report", "No findings."))});
            return;
        }
        FindingsBlock block = findingLines(evaluation, m_language);
        m_report.blocks.emplace_back(Heading{2, text(REPORT_TEXT("report", "Findings"))});
        m_report.blocks.emplace_back(std::move(block));
    }

    const EvaluatedDocument &m_evaluated;
    const Language &m_language;
    Writer m_write;
    Report m_report;
};

} // namespace

Report composeResults(const EvaluatedDocument &evaluated, const Language &language) {
    Composer composer(evaluated, language);
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i)
        composer.addResults(*evaluated.document->tests[i], *evaluated.tests[i]);
    Report report = composer.take();
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (const auto stated = statedComparison(evaluated, i))
            std::ranges::move(composeComparison(stated->comparison, {&evaluated, stated->before},
                                                {&evaluated, stated->after}, language,
                                                stated->options.tolerance)
                                  .blocks,
                              std::back_inserter(report.blocks));
    }
    addSheetResults(report.blocks, evaluated, Writer(language));
    return report;
}

Report composeFindings(const EvaluatedDocument &evaluated, const Language &language) {
    Composer composer(evaluated, language);
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i)
        composer.addFindingsOf(*evaluated.document->tests[i], *evaluated.tests[i]);
    Report report = composer.take();
    addSheetFindings(report.blocks, evaluated, Writer(language));
    return report;
}

} // namespace palmer
