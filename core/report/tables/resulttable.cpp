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

/// The sense for a path, since the symbol shows the rest.
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

/// Converts a printed number so that a spreadsheet reads it.
QString plainNumber(QString text) {
    return text.remove(QChar(u'\u202F')).remove(QChar(u'\u00A0')).replace(QChar(u'\u2212'), u'-');
}

/// All except short name and weight, which depend on the preceding lines.
ResultLine lineOf(const PrintedResult &result, const Language &language) {
    const Parameter &parameter = *result.parameter;
    ResultLine line;
    line.id = QString::fromStdString(parameterId(parameter));
    line.symbol = symbolFormula(parameter);
    line.fullName = language.text(parameter.term.name);
    if (const QString of = limitNote(parameter, language); !of.isEmpty())
        line.fullName += QStringLiteral(" (") + of + u')';
    line.verdict = parameter.verdict;
    line.scale = decisionScale(parameter);
    line.isFirst = result.isFirst;
    return line;
}

std::vector<QString> cellsOf(const ShownResult &shown) {
    std::vector<QString> cells;
    for (const ResultColumn &column : resultColumns()) {
        const QString cell = column.shown ? column.shown(shown) : QString();
        const bool isMissing = cell.isEmpty() && column.look == ResultLook::number && !column.besideOnly;
        cells.push_back(isMissing ? QStringLiteral("–") : cell);
    }
    return cells;
}

/// Adds the same quantity of the test of the other role; `shown` points to `numbers` afterwards.
void addOther(ResultLine &line, ShownResult &shown, PrintedNumbers &numbers, bool isFound,
              const RolesBeside &both, const EvaluatedDocument &evaluated) {
    const auto same = std::ranges::find_if(both.quantities, [&](const QuantityOfRoles &quantity) {
        return (isFound ? quantity.left : quantity.found) == shown.result.parameter;
    });
    if (same == both.quantities.end())
        return;
    const Parameter &other = isFound ? *same->found : *same->left;
    const Document &document = *evaluated.document;
    const Test &test = *document.tests[isFound ? both.found : both.left];
    numbers = printedNumbers(other, test, document, shown.language);
    shown.other = &numbers;
    shown.change = same->change;
    line.otherVerdict = other.verdict;
    if (other.verdict)
        line.otherVerdictWord = shown.language.text(limitText(*other.verdict));
}

/// Column title with the unit, in lists for people.
QString titleOf(const ResultColumn &column, const ResultTable &table, const Language &language) {
    if (column.look != ResultLook::number)
        return language.text(column.title);
    QStringList title;
    if (!column.title.empty())
        title << language.text(column.title);
    if (column.besideOnly && column.key != std::string_view("change"))
        title << language.text(roleText(table.otherIsFound ? TestRole::asFound : TestRole::asLeft));
    const bool isCovered = column.key == std::string_view("expandedUncertainty") && !table.coverage.isEmpty();
    return title.join(QStringLiteral(", ")) + QStringLiteral(" (") + table.unit +
           (isCovered ? QStringLiteral(", ") + table.coverage : QString()) + u')';
}

/// The columns copied to the clipboard.
std::vector<const ResultColumn *> copied(const ResultTable &table) {
    auto columns = resultColumns(onClipboard);
    std::erase_if(columns,
                  [&](const ResultColumn *column) { return column->besideOnly && !table.otherTest; });
    return columns;
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
            REPORT_TEXT("report", "Seen under another edition than that of the test (%1): no verdict."),
            {source.edition});
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
    const auto both = table.view ? std::nullopt : rolesBeside(evaluated, test, language);
    if (both) {
        table.otherIsFound = both->left == test;
        table.otherTest = table.otherIsFound ? both->found : both->left;
    }
    for (const PrintedResult &result : printedResults(document, source, evaluation, language)) {
        const Term &term = result.parameter->term;
        table.unit = language.unit(term.quantity);
        ResultLine line = lineOf(result, language);
        if (line.verdict == Verdict::notProven)
            line.reason = language.text(whyNotProven(*result.parameter, evaluation));
        // An axis measured from one side has no main parameter.
        const bool standsForAll = line.isFirst && term.of == Of::axis;
        line.main = standsForAll || term.weight == Weight::main;
        line.name = language.text(shortNameOf(*result.parameter, evaluation, standsForAll));
        line.narrowName =
            language.text(shortNameOf(*result.parameter, evaluation, standsForAll, Room::little));
        ShownResult shown{result, language};
        PrintedNumbers numbers;
        if (both)
            addOther(line, shown, numbers, table.otherIsFound, *both, evaluated);
        line.cells = cellsOf(shown);
        table.lines.push_back(std::move(line));
    }
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
    } else { // the last state as left
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

const QString &ResultLine::cell(const ResultColumn &column) const {
    return cells[static_cast<std::size_t>(&column - resultColumns().data())];
}

const QString &ResultLine::cell(std::string_view key) const {
    return cell(resultColumn(key));
}

QString asTabSeparated(const ResultTable &table, const Language &language) {
    const auto columns = copied(table);
    QStringList cells;
    for (const ResultColumn *column : columns)
        cells << titleOf(*column, table, language);
    QString text = cells.join(u'\t') + u'\n';
    for (const ResultLine &line : table.lines) {
        cells.clear();
        for (const ResultColumn *column : columns) {
            const QString &cell = line.cell(*column);
            cells << (column->look == ResultLook::symbol   ? line.symbol.plain()
                      : column->look == ResultLook::name   ? line.fullName
                      : column->look != ResultLook::number ? cell
                      : cell == QStringLiteral("–")        ? QString()
                                                           : plainNumber(cell));
        }
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

QString asHtml(const ResultTable &table, const Language &language) {
    const auto columns = copied(table);
    QString html = QStringLiteral("<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n<tr>");
    for (const ResultColumn *column : columns)
        html += QStringLiteral("<th>") + titleOf(*column, table, language).toHtmlEscaped() +
                QStringLiteral("</th>");
    html += QStringLiteral("</tr>\n");
    for (const ResultLine &line : table.lines) {
        html += QStringLiteral("<tr>");
        for (const ResultColumn *column : columns) {
            html += column->look == ResultLook::number ? QStringLiteral("<td align=\"right\">")
                                                       : QStringLiteral("<td>");
            if (column->look == ResultLook::symbol) {
                for (const FormulaSpan &span : line.symbol.spans)
                    html += span.subscript ? QStringLiteral("<sub>") + span.text.toHtmlEscaped() +
                                                 QStringLiteral("</sub>")
                                           : span.text.toHtmlEscaped();
            } else {
                const bool isName = column->look == ResultLook::name;
                html += (isName ? line.fullName : line.cell(*column)).toHtmlEscaped();
            }
            html += QStringLiteral("</td>");
        }
        html += QStringLiteral("</tr>\n");
    }
    return html + QStringLiteral("</table>\n");
}

} // namespace palmer
