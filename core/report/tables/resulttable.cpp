// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/resulttable.h"

#include "document/testsofverdict.h"
#include "kernel/evaluation/conformity.h"
#include "kernel/measurement/testfacts.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <string_view>

namespace palmer {

namespace {

enum class Room { little, usual };

Text shortName(const Term &term, bool alone, Room room) {
    const auto &[below, standing, narrow] = term.shortName;
    if ((alone || standing.empty()) && room == Room::little && !narrow.empty())
        return narrow;
    return alone && !standing.empty() ? standing : below.empty() ? term.name : below;
}

/// Of a path its sense: the symbol tells the rest.
Text shortNameOf(const Parameter &parameter, const TestEvaluation &evaluation, bool alone,
                 Room room = Room::usual) {
    const auto *paths = partOr<const std::vector<EvaluatedPath> *>(
        nullptr, evaluation.results,
        [](auto &results) -> decltype(&results.paths) { return &results.paths; });
    for (std::size_t k = 0; paths && parameter.term.of == Of::path && k < paths->size(); ++k) {
        if ((*paths)[k].index == parameter.index)
            return room == Room::little ? shortSenseText((*paths)[k].sense) : senseText((*paths)[k].sense);
    }
    const bool oneDirection =
        partOr(false, evaluation.results,
               [](auto &results) -> decltype(results.upward) { return results.upward != results.downward; });
    return shortName(parameter.term, alone || oneDirection, room);
}

QString circleName(ReferenceCircle circle) {
    return circle == ReferenceCircle::minimumZone ? QStringLiteral("MZC") : QStringLiteral("LSC");
}

/// What a spreadsheet reads as a number.
QString plainNumber(QString text) {
    return text.remove(QChar(u'\u202F')).remove(QChar(u'\u00A0')).replace(QChar(u'\u2212'), u'-');
}

/// But for its short name and weight, which depend on the lines before it.
ResultLine lineOf(const PrintedResult &result, const Language &language) {
    const Parameter &parameter = *result.parameter;
    const auto orDash = [](const QString &text) { return text.isEmpty() ? QStringLiteral("–") : text; };
    ResultLine line;
    line.id = QString::fromStdString(parameterId(parameter));
    line.symbol = symbolFormula(parameter.term.symbol, parameter.index);
    line.fullName = language.text(parameter.term.name);
    if (const QString of = limitNote(parameter, language); !of.isEmpty())
        line.fullName += QStringLiteral(" (") + of + u')';
    line.ruling = rulingText(parameter);
    line.value = orDash(result.value);
    line.uncertainty = orDash(result.uncertainty);
    line.limit = orDash(result.alignedLimit);
    line.verdict = parameter.verdict;
    if (parameter.verdict)
        line.verdictWord = language.text(limitText(*parameter.verdict));
    line.scale = decisionScale(parameter);
    line.isFirst = result.isFirst;
    return line;
}

/// The test of the other role, in the rows of its quantities.
void addOtherRole(ResultTable &table, const EvaluatedDocument &evaluated, std::size_t test,
                  const Language &language) {
    const auto both = table.view ? std::nullopt : rolesBeside(evaluated, test, language);
    if (!both)
        return;
    table.otherIsFound = both->left == test;
    const std::size_t place = table.otherIsFound ? both->found : both->left;
    table.otherTest = place;
    const Test &other = *evaluated.document->tests[place];
    for (const QuantityOfRoles &quantity : both->quantities) {
        const Parameter &parameter = table.otherIsFound ? *quantity.found : *quantity.left;
        const auto line =
            std::ranges::find(table.lines, QString::fromStdString(parameterId(parameter)), &ResultLine::id);
        if (line == table.lines.end())
            continue;
        const PrintedNumbers numbers = printedNumbers(parameter, other, *evaluated.document, language);
        line->other = numbers.value;
        line->otherUncertainty = numbers.uncertainty;
        line->otherVerdict = parameter.verdict;
        if (parameter.verdict)
            line->otherVerdictWord = language.text(limitText(*parameter.verdict));
        line->change = quantity.change;
    }
}

QStringList titles(const ResultTable &table, const Language &language) {
    const QString unit = QStringLiteral(" (") + table.unit + u')';
    QString uncertainty = QStringLiteral("U (") + table.unit;
    if (!table.coverage.isEmpty())
        uncertainty += QStringLiteral(", ") + table.coverage;
    QStringList titles{language.text(REPORT_TEXT("report", "Symbol")),
                       language.text(REPORT_TEXT("report", "Result")),
                       language.text(REPORT_TEXT("report", "Value")) + unit,
                       uncertainty + u')',
                       language.text(REPORT_TEXT("report", "Limit")) + unit,
                       language.text(REPORT_TEXT("report", "Verdict"))};
    if (table.otherTest) {
        const QString role =
            language.text(roleText(table.otherIsFound ? TestRole::asFound : TestRole::asLeft));
        titles << role + unit << QStringLiteral("U, ") + role + unit
               << language.text(REPORT_TEXT("report", "Change")) + unit;
    }
    return titles;
}

/// Of the test of the other role; none where there is no other.
QStringList otherNumbers(const ResultTable &table, const ResultLine &line) {
    return table.otherTest ? QStringList{line.other, line.otherUncertainty, line.change} : QStringList();
}

} // namespace

std::vector<PrintedResult> printedResults(const Document &document, const Test &test,
                                          const TestEvaluation &evaluation, const Language &language) {
    std::vector<PrintedResult> results;
    std::string_view family;
    for (const Parameter &parameter : evaluation.parameters) {
        if (!isPrinted(parameter, document.report))
            continue;
        results.push_back({printedNumbers(parameter, test, document, language), &parameter,
                           family != parameter.term.family});
        family = parameter.term.family;
    }
    return results;
}

std::vector<std::size_t> rulesBetween(const std::vector<PrintedResult> &results) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 1; i < results.size(); ++i) {
        if (results[i].isFirst)
            rows.push_back(i - 1);
    }
    return rows;
}

Text briefName(const Parameter &parameter, const TestEvaluation &evaluation) {
    return shortNameOf(parameter, evaluation, true);
}

Text listedName(const Term &term) {
    return shortName(term, false, Room::usual);
}

std::optional<DecisionScale> decisionScale(const Parameter &parameter) {
    if (!parameter.value || !parameter.limit || !parameter.limit->value ||
        !(judgedLimit(*parameter.limit->value, parameter.bound) > 0))
        return std::nullopt;
    const double limit = judgedLimit(*parameter.limit->value, parameter.bound);
    DecisionScale scale;
    scale.band = parameter.guardBand && *parameter.guardBand > 0;
    const double half = scale.band ? *parameter.guardBand / DecisionScale::guard : limit;
    const double place = (judgedValue(*parameter.value, parameter.bound) - limit) / half;
    scale.below = place < -1;
    scale.above = place > 1;
    scale.value = std::clamp(place, -1.0, 1.0);
    return scale;
}

ResultTable resultTable(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    ResultTable table;
    if (test >= evaluated.tests.size() || !evaluated.tests[test]->edition)
        return table;
    const Document &document = *evaluated.document;
    const Test &source = *document.tests[test];
    const TestEvaluation &evaluation = *evaluated.tests[test];
    table.edition = QString::fromUtf8(evaluation.edition->word);
    table.view = evaluation.view;
    table.provisional = isUnfinished(source) || evaluation.provisional;
    if (table.view)
        table.viewNote = language.sentence(
            {REPORT_TEXT("report", "Seen under another edition than that of the test (%1): no verdict."),
             {source.edition},
             {}});
    else
        table.verdict = evaluation.verdict;
    if (table.verdict)
        table.verdictWord = language.text(verdictText(*table.verdict));
    table.rule = language.text(ruleWords(source.decisionRule.rule).name);

    table.circle =
        partOr(QString(), source.measurement, [](auto &m) -> decltype(circleName(m.referenceCircle)) {
            return circleName(m.referenceCircle);
        });

    table.coverage = coverageNote(coverageOf(evaluation, document.report), language);
    for (const PrintedResult &result : printedResults(document, source, evaluation, language)) {
        const Term &term = result.parameter->term;
        table.unit = language.unit(term.quantity);
        ResultLine line = lineOf(result, language);
        // Of an axis measured from one side no main one is there.
        const bool standsForAll = line.isFirst && term.of == Of::axis;
        line.main = standsForAll || term.weight == Weight::main;
        line.name = language.text(shortNameOf(*result.parameter, evaluation, standsForAll));
        line.narrowName =
            language.text(shortNameOf(*result.parameter, evaluation, standsForAll, Room::little));
        table.lines.push_back(std::move(line));
    }
    addOtherRole(table, evaluated, test, language);
    return table;
}

std::optional<RolesBeside> rolesBeside(const EvaluatedDocument &evaluated, std::size_t test,
                                       const Language &language) {
    const Document &document = *evaluated.document;
    RolesBeside both{test, test, {}};
    if (document.tests[test]->role == TestRole::asLeft) {
        const auto found = testAsFound(document, test);
        if (!found)
            return std::nullopt;
        both.found = *found;
    } else { // the last state that was left
        for (std::size_t i = 0; i < document.tests.size(); ++i)
            both.left = testAsFound(document, i) == test ? i : both.left;
    }
    const auto counts = [&](std::size_t i) {
        return !evaluated.isPending(i) && evaluated.tests[i]->edition && !evaluated.tests[i]->view;
    };
    if (both.found == both.left || !counts(both.found) || !counts(both.left))
        return std::nullopt;
    constexpr int decimals = 1;
    const auto &found = evaluated.tests[both.found]->parameters;
    for (const Parameter &left : evaluated.tests[both.left]->parameters) {
        const auto same = std::ranges::find_if(
            found, [&](const Parameter &parameter) { return parameterId(parameter) == parameterId(left); });
        if (!isPrinted(left, document.report) || same == found.end())
            continue;
        both.quantities.push_back({&*same, &left,
                                   same->value && left.value ? language.number(*left.value - *same->value,
                                                                               left.term.quantity, decimals)
                                                             : QString()});
    }
    return both;
}

QString asTabSeparated(const ResultTable &table, const Language &language) {
    QString text = titles(table, language).join(u'\t') + u'\n';
    const auto cell = [](const QString &number) {
        return number == QStringLiteral("–") ? QString() : plainNumber(number);
    };
    for (const ResultLine &line : table.lines) {
        QStringList cells{line.symbol.plain(),    line.fullName,    cell(line.value),
                          cell(line.uncertainty), cell(line.limit), line.verdictWord};
        for (const QString &number : otherNumbers(table, line))
            cells << cell(number);
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

QString asHtml(const ResultTable &table, const Language &language) {
    QString html = QStringLiteral("<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n<tr>");
    for (const QString &title : titles(table, language))
        html += QStringLiteral("<th>") + title.toHtmlEscaped() + QStringLiteral("</th>");
    html += QStringLiteral("</tr>\n");
    const auto addNumbers = [&](const QStringList &numbers) {
        for (const QString &number : numbers)
            html += QStringLiteral("<td align=\"right\">") + number.toHtmlEscaped() + QStringLiteral("</td>");
    };
    for (const ResultLine &line : table.lines) {
        html += QStringLiteral("<tr><td>");
        for (const FormulaSpan &span : line.symbol.spans)
            html += span.subscript
                        ? QStringLiteral("<sub>") + span.text.toHtmlEscaped() + QStringLiteral("</sub>")
                        : span.text.toHtmlEscaped();
        html += QStringLiteral("</td><td>") + line.fullName.toHtmlEscaped() + QStringLiteral("</td>");
        addNumbers({line.value, line.uncertainty, line.limit});
        html += QStringLiteral("<td>") + line.verdictWord.toHtmlEscaped() + QStringLiteral("</td>");
        addNumbers(otherNumbers(table, line));
        html += QStringLiteral("</tr>\n");
    }
    return html + QStringLiteral("</table>\n");
}

} // namespace palmer
