// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/summary.h"

#include "document/filewords.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/shortest.h"
#include "language/csvwriter.h"
#include "report/blocks/plaintext.h"
#include "report/tables/resulttable.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace palmer {

namespace {

/// A column and its alignment on a terminal.
struct SummaryColumn {
    const char *word = nullptr;
    Text title;
    bool atRight = false;
};

/// Columns before the results.
constexpr std::array headColumns{SummaryColumn{"file", REPORT_TEXT("report", "File")},
                                 SummaryColumn{"test", REPORT_TEXT("report", "Test"), true},
                                 SummaryColumn{"machine", REPORT_TEXT("report", "Machine")},
                                 SummaryColumn{"axis", REPORT_TEXT("report", "Axis")},
                                 SummaryColumn{"date", REPORT_TEXT("report", "Date")},
                                 SummaryColumn{"edition", REPORT_TEXT("report", "Edition")},
                                 SummaryColumn{"role", REPORT_TEXT("report", "Role")}};
/// Columns of results, by their headings.
constexpr std::array resultHeadings{"parameter", "value", "U", "limit", "unit", "limits"};

std::vector<SummaryColumn> allColumns() {
    std::vector<SummaryColumn> all(headColumns.begin(), headColumns.end());
    for (const char *heading : resultHeadings) {
        const ResultColumn &column = resultColumn(heading);
        all.push_back({heading, column.title, column.look == ResultLook::number});
    }
    all.push_back({"accordance", REPORT_TEXT("report", "Accordance")});
    return all;
}

QString cellText(const nlohmann::ordered_json &told) {
    return told.is_number()   ? QString::fromStdString(shortest(told.get<double>()))
           : told.is_string() ? QString::fromStdString(told.get<std::string>())
                              : QString();
}

/// Leading cells common to all rows of a test.
QStringList headOf(const EvaluatedDocument &evaluated, std::size_t index, const QString &file,
                   SummaryForm form, const Language &language) {
    const Test &test = *evaluated.document->tests[index];
    const TestEvaluation &evaluation = *evaluated.tests[index];
    const bool csv = form == SummaryForm::csv;
    QString date;
    if (test.date)
        date = csv ? QString::fromStdString(*test.date) : language.shortDate(*test.date);
    QString role;
    if (test.role != TestRole::notStated)
        role = csv ? QString::fromUtf8(fileWord(test.role)) : language.text(roleText(test.role));
    return {file,
            QString::number(index + 1),
            QString::fromStdString(evaluated.document->machine.name),
            QString::fromStdString(axesOf(test)),
            date,
            evaluation.edition ? QString::fromUtf8(evaluation.edition->word) : QString(),
            role};
}

QString accordanceCell(Accordance accordance, SummaryForm form, const Language &language) {
    if (form == SummaryForm::csv)
        return QString::fromUtf8(fileWord(accordance));
    return language.text(accordance == Accordance::yes ? REPORT_TEXT("report", "in accordance")
                                                       : accordanceWords(accordance));
}

} // namespace

QStringList summaryHead(SummaryForm form, const Language &language) {
    QStringList head;
    for (const SummaryColumn &column : allColumns())
        head << (form == SummaryForm::csv ? QString::fromUtf8(column.word) : language.text(column.title));
    return head;
}

std::vector<QStringList> summaryRows(const EvaluatedDocument &evaluated, const QString &file,
                                     SummaryForm form, const Language &language) {
    std::vector<QStringList> rows;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        const TestEvaluation &evaluation = *evaluated.tests[i];
        const QStringList head = headOf(evaluated, i, file, form, language);
        const QString accordance = accordanceCell(evaluation.accordance(), form, language);
        if (form == SummaryForm::csv) {
            for (const Parameter &parameter : evaluation.parameters) {
                QStringList row = head;
                for (const char *heading : resultHeadings)
                    row << cellText(
                        resultColumn(heading).told({parameter, evaluation.uncertainty, language}));
                rows.push_back(row << accordance);
            }
        } else {
            for (const ResultLine &line : resultTable(evaluated, i, language).lines) {
                QStringList row = head;
                for (const char *heading : resultHeadings)
                    row << line.cell(heading);
                rows.push_back(row << accordance);
            }
        }
        if (evaluation.parameters.empty()) {
            QStringList row = head;
            row.resize(head.size() + static_cast<qsizetype>(resultHeadings.size()) + 1);
            row.last() = accordance;
            rows.push_back(row);
        }
    }
    return rows;
}

QByteArray summaryCsv(const std::vector<QStringList> &rows) {
    CsvWriter csv('.');
    for (const QStringList &row : rows) {
        for (const QString &cell : row)
            csv.text(cell.toStdString());
        csv.endRow();
    }
    return csv.bytes();
}

namespace {

constexpr int gap = 2;            ///< between two columns
constexpr int narrowestPath = 16; ///< terminal columns; other texts keep the width of their longest word

/// Breaks at spaces, and anywhere in longer words such as paths.
QStringList broken(const QString &cell, int width) {
    QStringList lines;
    for (QString line : wrapped(cell, width)) {
        for (; displayWidth(line) > width; line.remove(0, width))
            lines << line.left(width);
        lines << line;
    }
    return lines;
}

int longestWord(const QString &cell) {
    int longest = 0;
    for (const QString &word : cell.split(u' '))
        longest = std::max(longest, displayWidth(word));
    return longest;
}

/// Reduces the widest columns, down to `least`, until a row fits.
void narrow(std::vector<int> &widths, const std::vector<int> &least, int width) {
    const auto total = [&] {
        int sum = gap * (static_cast<int>(widths.size()) - 1);
        for (const int column : widths)
            sum += column;
        return sum;
    };
    while (total() > width) {
        int *widest = nullptr;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            if (widths[c] > least[c] && (!widest || widths[c] > *widest))
                widest = &widths[c];
        }
        if (!widest)
            return;
        --*widest;
    }
}

} // namespace

QString summaryText(const QStringList &head, const std::vector<QStringList> &rows, std::optional<int> width) {
    const std::vector<SummaryColumn> columns = allColumns();
    std::vector<int> widths(columns.size());
    std::vector<int> least(columns.size());
    const auto widen = [&](const QStringList &row) {
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const QString &cell = row[static_cast<qsizetype>(c)];
            widths[c] = std::max(widths[c], displayWidth(cell));
            least[c] = std::max(least[c], columns.at(c).atRight ? displayWidth(cell) : longestWord(cell));
        }
    };
    widen(head);
    std::ranges::for_each(rows, widen);
    least.front() = std::min(least.front(), narrowestPath);
    if (width)
        narrow(widths, least, *width);
    QString text;
    const auto print = [&](const QStringList &row) {
        std::vector<QStringList> cells;
        qsizetype height = 1;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            cells.push_back(broken(row[static_cast<qsizetype>(c)], widths[c]));
            height = std::max(height, cells.back().size());
        }
        for (qsizetype i = 0; i < height; ++i) {
            QString line;
            for (std::size_t c = 0; c < widths.size(); ++c) {
                const QString cell = cells[c].value(i);
                const QString blanks(widths[c] - displayWidth(cell), u' ');
                line += (c == 0 ? QString() : QString(gap, u' ')) +
                        (columns.at(c).atRight ? blanks + cell : cell + blanks);
            }
            while (line.endsWith(u' '))
                line.chop(1);
            text += line + u'\n';
        }
    };
    print(head);
    std::ranges::for_each(rows, print);
    return text;
}

} // namespace palmer
