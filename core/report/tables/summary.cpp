// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/summary.h"

#include "document/filewords.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/shortest.h"
#include "language/csvwriter.h"
#include "language/rounding.h"
#include "report/blocks/plaintext.h"
#include "report/tables/resulttable.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace palmer {

namespace {

/// A column and its alignment on a terminal.
struct SummaryColumn {
    const char *word = nullptr;
    Text title;
    bool atRight = false;
    bool canBeMissed = false; ///< on a narrow terminal
};

/// Columns before the results.
constexpr std::array headColumns{
    SummaryColumn{"file", REPORT_TEXT("report", "File")},
    SummaryColumn{"test", REPORT_TEXT("report", "Test"), true},
    SummaryColumn{"machine", REPORT_TEXT("report", "Machine")},
    SummaryColumn{"manufacturer", REPORT_TEXT("report", "Manufacturer"), false, true},
    SummaryColumn{"model", REPORT_TEXT("report", "Type"), false, true},
    SummaryColumn{"serialNumber", REPORT_TEXT("report", "Serial number"), false, true},
    SummaryColumn{"reportNumber", REPORT_TEXT("report", "Report No."), false, true},
    SummaryColumn{"axis", REPORT_TEXT("report", "Axis")},
    SummaryColumn{"date", REPORT_TEXT("report", "Date")},
    SummaryColumn{"edition", REPORT_TEXT("report", "Edition")},
    SummaryColumn{"purpose", REPORT_TEXT("report", "Purpose"), false, true},
    SummaryColumn{"role", REPORT_TEXT("report", "Role")},
    SummaryColumn{"zone", REPORT_TEXT("report", "Working zone"), false, true}};
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

SummaryTest identified(const EvaluatedDocument &evaluated, std::size_t index, const QString &file) {
    const Document &document = *evaluated.document;
    const Test &test = *document.tests[index];
    const TestEvaluation &evaluation = *evaluated.tests[index];
    const Machine &machine = document.machine;
    const auto *positioning = std::get_if<PositioningMeasurement>(&test.measurement);
    return {file,
            static_cast<int>(index) + 1,
            machine.name,
            machine.manufacturer,
            machine.model,
            machine.serialNumber,
            document.report.number,
            axesOf(test),
            test.date.value_or(""),
            evaluation.edition ? evaluation.edition->word : "",
            test.purpose,
            test.role,
            positioning && positioning->zone ? shortText(*positioning->zone) : "",
            motionOf(test) == Motion::rotary};
}

/// The limit of a parameter that was agreed for another edition; null if there is none.
const AgreedLimit *openLimitOf(const TestEvaluation &evaluation, const Parameter &parameter) {
    const auto found = std::ranges::find_if(evaluation.limits, [&](const AgreedLimit &limit) {
        return std::ranges::find(limit.parameters, parameterId(parameter)) != limit.parameters.end();
    });
    return parameter.limit || found == evaluation.limits.end() ? nullptr : &*found;
}

/// Enters a limit that cannot be evaluated into the cells of a row, which are those of resultHeadings.
void enter(QStringList &cells, const AgreedLimit &limit, Quantity quantity, SummaryForm form,
           const Language &language) {
    const bool csv = form == SummaryForm::csv;
    cells[3] = csv ? QString::fromStdString(shortest(*limit.limit.value))
                   : language.number(*limit.limit.value, quantity,
                                     limitDecimals(*limit.limit.value, quantity, language.units()));
    cells[4] = csv ? QString::fromUtf8(resultUnit(quantity)) : language.unit(quantity);
    cells[5] = csv ? QString::fromUtf8(fileWord(limit.state))
                   : language.text(REPORT_TEXT_FOR("report", "not evaluable", "a limit"));
}

/// The cells of resultHeadings: a row for each parameter, then one for each limit without any.
std::vector<QStringList> resultRows(const EvaluatedDocument &evaluated, std::size_t test, SummaryForm form,
                                    const Language &language) {
    const TestEvaluation &evaluation = *evaluated.tests[test];
    std::vector<QStringList> rows;
    const auto add = [&](const Parameter &parameter, const auto &cell) {
        QStringList &row = rows.emplace_back();
        for (const char *heading : resultHeadings)
            row << cell(heading);
        if (const AgreedLimit *limit = openLimitOf(evaluation, parameter))
            enter(row, *limit, parameter.term.quantity, form, language);
    };
    if (form == SummaryForm::csv) {
        for (const Parameter &parameter : evaluation.parameters)
            add(parameter, [&](const char *heading) {
                return cellText(resultColumn(heading).told({parameter, evaluation.uncertainty, language}));
            });
    } else {
        for (const ResultLine &line : resultTable(evaluated, test, language).lines) {
            const auto parameter =
                std::ranges::find(evaluation.parameters, line.id.toStdString(), parameterId);
            add(*parameter, [&](const char *heading) { return line.cell(heading); });
        }
    }
    const Quantity quantity = deviationQuantity(*evaluated.document->tests[test]);
    for (const AgreedLimit &limit : evaluation.limits) {
        if (!limit.parameters.empty())
            continue;
        const QString name = QString::fromStdString(form == SummaryForm::csv ? limit.key : limit.symbol);
        const QString none = form == SummaryForm::csv ? QString() : QStringLiteral("–");
        enter(rows.emplace_back(QStringList{name, none, none, {}, {}, {}}), limit, quantity, form, language);
    }
    return rows;
}

} // namespace

std::string shortText(const Interval &interval) {
    return shortest(interval.from) + " … " + shortest(interval.to);
}

QString lengthsText(const QString &lengths, Quantity quantity, const Language &language) {
    QStringList pieces = lengths.split(u' ');
    for (QString &piece : pieces) {
        bool isNumber = false;
        const double number = piece.toDouble(&isNumber);
        piece = isNumber ? language.number(number, quantity, -1) : piece;
    }
    return (pieces << language.unit(quantity)).join(QChar::Nbsp);
}

QStringList summaryCells(const SummaryTest &test, SummaryForm form, const Language &language) {
    const bool csv = form == SummaryForm::csv;
    const auto word = [&](auto value, const Text &text) {
        return text.empty() ? QString() : csv ? QString::fromUtf8(fileWord(value)) : language.text(text);
    };
    const QString zone = QString::fromStdString(test.zone);
    QStringList cells{test.file, QString::number(test.test)};
    for (const std::string *text :
         {&test.machine, &test.manufacturer, &test.model, &test.serialNumber, &test.reportNumber, &test.axis})
        cells << QString::fromStdString(*text);
    return cells << (csv || test.date.empty() ? QString::fromStdString(test.date)
                                              : language.shortDate(test.date))
                 << QString::fromStdString(test.edition) << word(test.purpose, purposeText(test.purpose))
                 << word(test.role, roleText(test.role))
                 << (csv || zone.isEmpty()
                         ? zone
                         : lengthsText(zone, test.angular ? Quantity::angle : Quantity::position, language));
}

QString summaryAccordance(Accordance accordance, SummaryForm form, const Language &language) {
    if (form == SummaryForm::csv)
        return QString::fromUtf8(fileWord(accordance));
    return language.text(accordance == Accordance::yes ? REPORT_TEXT("report", "in accordance")
                                                       : accordanceWords(accordance));
}

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
        const QStringList head = summaryCells(identified(evaluated, i, file), form, language);
        const QString accordance = summaryAccordance(evaluation.accordance(), form, language);
        const std::vector<QStringList> results = resultRows(evaluated, i, form, language);
        for (const QStringList &result : results)
            rows.push_back(head + result + QStringList{accordance});
        if (results.empty()) {
            QStringList row = head;
            row.resize(head.size() + static_cast<qsizetype>(resultHeadings.size()) + 1);
            row.last() = accordance;
            rows.push_back(row);
        }
    }
    return rows;
}

QByteArray summaryCsv(const std::vector<QStringList> &rows, char decimalMark) {
    const std::vector<SummaryColumn> columns = allColumns();
    CsvWriter csv(decimalMark);
    for (const QStringList &row : rows) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.size()); ++i) {
            const QString &cell = row[static_cast<qsizetype>(i)];
            bool isNumber = false;
            const double number = cell.toDouble(&isNumber);
            if (isNumber && (i >= columns.size() || columns[i].atRight))
                csv.number(number);
            else
                csv.text(cell.toStdString());
        }
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

int widthOfRow(const std::vector<int> &widths) {
    return std::accumulate(widths.begin(), widths.end(), gap * (static_cast<int>(widths.size()) - 1));
}

/// Reduces the widest columns, down to `least`, until a row fits.
void narrow(std::vector<int> &widths, const std::vector<int> &least, int width) {
    while (widthOfRow(widths) > width) {
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

/// The lines that one row takes.
QString printed(const QStringList &row, const std::vector<SummaryColumn> &columns,
                const std::vector<int> &widths) {
    std::vector<QStringList> cells;
    qsizetype height = 1;
    for (std::size_t c = 0; c < widths.size(); ++c) {
        cells.push_back(broken(row[static_cast<qsizetype>(c)], widths[c]));
        height = std::max(height, cells.back().size());
    }
    QString text;
    for (qsizetype i = 0; i < height; ++i) {
        QString line;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const QString cell = cells[c].value(i);
            const QString blanks(widths[c] - displayWidth(cell), u' ');
            line += (c == 0 ? QString() : QString(gap, u' ')) +
                    (columns[c].atRight ? blanks + cell : cell + blanks);
        }
        while (line.endsWith(u' '))
            line.chop(1);
        text += line + u'\n';
    }
    return text;
}

} // namespace

QString summaryText(const QStringList &head, const std::vector<QStringList> &rows, std::optional<int> width) {
    std::vector<SummaryColumn> columns = allColumns();
    std::vector<QStringList> lines{head};
    lines.insert(lines.end(), rows.begin(), rows.end());
    const auto leaveOut = [&](std::size_t c) {
        columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(c));
        for (QStringList &line : lines)
            line.removeAt(static_cast<qsizetype>(c));
    };
    const auto widest = [&](std::size_t c, bool unbroken) {
        int result = 0;
        for (const QStringList &line : lines) {
            const QString &cell = line[static_cast<qsizetype>(c)];
            result =
                std::max(result, unbroken || columns[c].atRight ? displayWidth(cell) : longestWord(cell));
        }
        return c == 0 && !unbroken ? std::min(result, narrowestPath) : result;
    };
    const auto widthsOf = [&](bool unbroken) {
        std::vector<int> widths;
        for (std::size_t c = 0; c < columns.size(); ++c)
            widths.push_back(widest(c, unbroken));
        return widths;
    };
    for (std::size_t c = columns.size(); !rows.empty() && c-- > 0;) {
        if (std::all_of(lines.begin() + 1, lines.end(),
                        [c](const QStringList &row) { return row[static_cast<qsizetype>(c)].isEmpty(); }))
            leaveOut(c);
    }
    for (std::size_t c = columns.size(); width && c-- > 0;) {
        if (columns[c].canBeMissed && widthOfRow(widthsOf(false)) > *width)
            leaveOut(c);
    }
    std::vector<int> widths = widthsOf(true);
    if (width)
        narrow(widths, widthsOf(false), *width);
    QString text;
    for (const QStringList &line : lines)
        text += printed(line, columns, widths);
    return text;
}

} // namespace palmer
