// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/sheetblock.h"

#include "document/bounds.h"
#include "language/entry.h"
#include "tables/contenterror.h"
#include "tables/table.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr Text tooLong = REPORT_TEXT("report", "this text is too long");
constexpr Text noNumber = REPORT_TEXT("report", "not a number");

/// Words of headings, without capitals and signs.
struct SheetHeading {
    SheetColumn column;
    std::array<const char16_t *, 6> words;
};
constexpr std::array headings{
    SheetHeading{SheetColumn::number, {u"n", u"no", u"nr", u"number", u"numéro", u"row"}},
    SheetHeading{SheetColumn::object,
                 {u"object", u"objet", u"check", u"contrôle", u"prüfung", u"description"}},
    SheetHeading{SheetColumn::permitted,
                 {u"tolerance", u"tolérance", u"permitted", u"limit", u"limite", u"toleranz"}},
    SheetHeading{SheetColumn::measured,
                 {u"measured", u"mesuré", u"mesurée", u"value", u"valeur", u"messwert"}},
    SheetHeading{SheetColumn::uncertainty,
                 {u"u", u"uk2", u"uncertainty", u"incertitude", u"unsicherheit", u"uu"}},
    SheetHeading{SheetColumn::unit, {u"unit", u"unité", u"einheit", u"units", u"unités", u"dimension"}},
    SheetHeading{SheetColumn::instrument,
                 {u"instrument", u"instruments", u"device", u"appareil", u"messmittel", u"moyen"}},
    SheetHeading{SheetColumn::remark,
                 {u"remark", u"remarque", u"remarks", u"remarques", u"note", u"bemerkung"}},
    SheetHeading{SheetColumn::standard, {u"standard", u"norme", u"norm", u"source", u"origine", u"clause"}}};

std::optional<SheetColumn> columnOfWord(const QString &cell) {
    static const QRegularExpression signs(QStringLiteral("[^\\p{L}\\p{N}]"));
    const QString word = cell.toLower().remove(signs);
    for (const SheetHeading &heading : headings) {
        if (std::ranges::any_of(heading.words,
                                [&](const char16_t *known) { return word == QStringView(known); }))
            return heading.column;
    }
    return std::nullopt;
}

/// "Tolerance" and "mm" of "Tolerance (mm)", "Tolerance [mm]" or "Tolerance, mm".
std::pair<QString, QString> nameAndUnit(const QString &cell) {
    static const QRegularExpression form(QStringLiteral("^([^(\\[,/]*)[(\\[,/]\\s*([^)\\]]*)[)\\]]?\\s*$"));
    const QRegularExpressionMatch found = form.match(cell);
    return found.hasMatch() ? std::pair(found.captured(1), found.captured(2).trimmed())
                            : std::pair(cell, QString());
}

std::optional<SheetColumn> columnNamed(const QString &cell) {
    const auto column = columnOfWord(cell);
    return column ? column : columnOfWord(nameAndUnit(cell).first);
}

std::optional<Text> putNumber(std::optional<double> &value, const QString &typed) {
    const NumberEntry entry = enteredNumber(typed, Quantity::number);
    if (entry.refusal)
        return entry.refusal;
    value = entry.value;
    return std::nullopt;
}

std::optional<Text> putPermitted(Permitted &permitted, QString typed) {
    static const QRegularExpression signs(QStringLiteral("^(±|≤|<=|\\+/-)\\s*"));
    typed.remove(signs);
    if (typed.isEmpty()) {
        permitted = {};
        return std::nullopt;
    }
    Permitted result;
    if (!putNumber(result.high, typed)) {
        if (*result.high < 0)
            return REPORT_TEXT("report",
                               "a tolerance is not negative; two values, the least and the largest, are a "
                               "range");
        permitted = result;
        return std::nullopt;
    }
    const IntervalEntry range = enteredInterval(typed, Quantity::number);
    if (!range.value)
        return noNumber;
    permitted = {range.value->from, range.value->to};
    return std::nullopt;
}

std::string *textOf(SheetRow &row, SheetColumn column) {
    switch (column) {
    case SheetColumn::number:
        return &row.number;
    case SheetColumn::object:
        return &row.object;
    case SheetColumn::unit:
        return &row.unit;
    case SheetColumn::instrument:
        return &row.instrument;
    case SheetColumn::remark:
        return &row.remark;
    case SheetColumn::standard:
        return &row.standard;
    case SheetColumn::permitted:
    case SheetColumn::measured:
    case SheetColumn::uncertainty:
        break;
    }
    return nullptr;
}

/// A row that is taken from a test has no numbers of its own.
bool isOfTest(SheetColumn column) {
    return column >= SheetColumn::permitted && column <= SheetColumn::unit;
}

QStringList trimmedCells(const CellTable &table, const TableRow &row) {
    QStringList cells;
    for (const TableCell &cell : table.cells(row))
        cells << QString::fromUtf8(table.text(cell)).trimmed();
    return cells;
}

/// Numbers as the decimal mark of the block has them; signs for "no reading" are none.
QString numberText(const QString &cell, DecimalMark mark) {
    const CellValue read = readCell(cell.toStdString(), mark);
    return read.kind == CellKind::missing ? QString() : cell;
}

} // namespace

std::optional<Text> typeIntoSheet(std::vector<SheetRow> &rows, std::size_t row, SheetColumn column,
                                  const QString &typed) {
    const QString text = typed.trimmed();
    if (row >= rows.size()) {
        if (text.isEmpty())
            return std::nullopt;
        std::vector<SheetRow> more = rows;
        more.resize(row + 1);
        const auto refused = typeIntoSheet(more, row, column, typed);
        if (!refused)
            rows = std::move(more);
        return refused;
    }
    SheetRow &changed = rows[row];
    if (changed.from && isOfTest(column))
        return REPORT_TEXT("report", "the test gives it; remove the row to type its numbers");
    if (std::string *member = textOf(changed, column)) {
        if (lengthOf(text) > mostOfLine)
            return tooLong;
        const std::string wanted = text.toStdString();
        const bool isTaken = std::ranges::any_of(
            rows, [&](const SheetRow &other) { return &other != &changed && other.number == wanted; });
        if (column == SheetColumn::number && !wanted.empty() && isTaken)
            return REPORT_TEXT("report", "another row has this number");
        *member = wanted;
        return std::nullopt;
    }
    if (column == SheetColumn::permitted)
        return putPermitted(changed.permitted, text);
    if (column == SheetColumn::measured)
        return putNumber(changed.measured, text);
    std::optional<double> uncertainty;
    if (const auto refused = putNumber(uncertainty, QString(text).remove(u'±')))
        return refused;
    if (uncertainty && *uncertainty < 0)
        return REPORT_TEXT("report", "an uncertainty is not negative");
    changed.uncertainty = uncertainty;
    return std::nullopt;
}

namespace {

using Columns = std::vector<std::optional<SheetColumn>>; ///< of a block; null: not read

CellTable tableOf(const QString &block, const ImportOptions &answers) {
    TableOptions options;
    options.comments = false;
    for (const auto &[sign, delimiter] :
         {std::pair(u'\t', Delimiter::tab), std::pair(u';', Delimiter::semicolon)}) {
        if (!options.delimiter && block.contains(sign))
            options.delimiter = delimiter; // an object has blanks and commas
    }
    if (const auto answer = answers.find("decimalMark"); answer != answers.end())
        options.decimalMark = answer->second == "comma" ? DecimalMark::comma : DecimalMark::point;
    return readTable(block.toStdString(), options);
}

/// Empty for a row that is no heading.
Columns columnsNamed(const QStringList &cells) {
    Columns columns;
    std::ranges::transform(cells, std::back_inserter(columns), columnNamed);
    const auto isNamed = [](const auto &column) { return column.has_value(); };
    return std::ranges::count_if(columns, isNamed) >= 2 ? columns : Columns();
}

Columns columnsFrom(SheetColumn column) {
    Columns columns;
    for (int k = static_cast<int>(column); k < sheetColumns; ++k)
        columns.emplace_back(static_cast<SheetColumn>(k));
    return columns;
}

/// The row that the cells belong to: that of their number, if they have one, else `next`.
std::size_t placeOf(const QStringList &cells, const Columns &columns, const std::vector<SheetRow> &rows,
                    std::size_t next) {
    const auto number = std::ranges::find(columns, std::optional(SheetColumn::number)) - columns.begin();
    if (number >= cells.size())
        return next;
    const auto same = std::ranges::find(rows, cells[number].toStdString(), &SheetRow::number);
    return cells[number].isEmpty() ? rows.size() : static_cast<std::size_t>(same - rows.begin());
}

[[noreturn]] void refuseCell(std::size_t line, const QString &cell) {
    throw Error(Error::Kind::content,
                {REPORT_TEXT("report", "line %1 of what was pasted: “%2” cannot stand in this column"),
                 {wholeNumber(line), cell.left(40).toStdString()},
                 {}});
}

/// The unit that the headings of numbers give, where no column does. Throws Error if they give several.
QString unitOf(const QStringList &cells, const Columns &columns, std::size_t line) {
    QString unit;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (columns[k] == SheetColumn::unit)
            return {};
        const QString &cell = cells[static_cast<qsizetype>(k)];
        const QString given = nameAndUnit(cell).second;
        const bool isNumber = columns[k] >= SheetColumn::permitted && columns[k] <= SheetColumn::uncertainty;
        if (!isNumber || given.isEmpty() || given.contains(u'=')) // "U (k = 2)"
            continue;
        if (!unit.isEmpty() && unit != given)
            refuseCell(line, cell);
        unit = given;
    }
    return unit;
}

/// Throws Error if the cell cannot stand in its column.
void putCell(std::vector<SheetRow> &rows, std::size_t place, SheetColumn column, const QString &cell,
             DecimalMark mark, std::size_t line) {
    const bool isNumber = column >= SheetColumn::permitted && column <= SheetColumn::uncertainty;
    const QString text = isNumber ? numberText(cell, mark) : cell;
    const bool isGrouped = isNumber && readCell(text.toStdString(), mark).kind == CellKind::grouped;
    if (isGrouped || typeIntoSheet(rows, place, column, text))
        refuseCell(line, cell);
}

} // namespace

PastedSheet pasteSheet(std::vector<SheetRow> rows, std::size_t first, SheetColumn column,
                       const QString &block, const ImportOptions &answers) {
    const CellTable table = tableOf(block, answers);
    PastedSheet result;
    Columns columns;
    QString unit;
    for (const TableRow &row : table.rows()) {
        const QStringList cells = trimmedCells(table, row);
        if (columns.empty()) {
            columns = columnsNamed(cells);
            if (!columns.empty()) {
                unit = unitOf(cells, columns, row.line);
                continue;
            }
            columns = columnsFrom(column);
        }
        const std::size_t place = placeOf(cells, columns, rows, first + result.taken);
        const auto count = std::min(static_cast<std::size_t>(cells.size()), columns.size());
        for (std::size_t k = 0; k < count; ++k) {
            if (!columns[k])
                continue;
            putCell(rows, place, *columns[k], cells[static_cast<qsizetype>(k)], table.decimalMark.value,
                    row.line);
            if (result.taken == 0)
                result.columns.push_back(*columns[k]);
        }
        if (!unit.isEmpty())
            putCell(rows, place, SheetColumn::unit, unit, table.decimalMark.value, row.line);
        ++result.taken;
    }
    result.sheet = std::move(rows);
    if (table.decimalMark.origin != Origin::recognised)
        result.units.push_back({"decimalMark",
                                table.decimalMark.value == DecimalMark::comma ? "comma" : "point",
                                table.decimalMark.origin});
    return result;
}

} // namespace palmer
