// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/palmercsv.h"

#include "document/filewords.h"
#include "document/statements.h"
#include "import/layouts/phrases.h"
#include "import/readers.h"
#include "kernel/words/shortest.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palmer {

namespace {

/// Length of the byte order mark and the quotation mark that may precede the first line.
std::size_t startOf(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    std::size_t start = text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
    if (text.substr(start).starts_with('"'))
        ++start;
    return start;
}

/// The delimiter follows the key of the first line; null for other files.
std::optional<std::pair<char, Delimiter>> delimiterOf(std::string_view text) {
    constexpr std::array signs{std::pair{'\t', Delimiter::tab}, std::pair{';', Delimiter::semicolon},
                               std::pair{',', Delimiter::comma}, std::pair{'|', Delimiter::bar}};
    std::string_view rest = text.substr(std::min(startOf(text), text.size()));
    for (const std::string_view part : {palmercsv::mark, palmercsv::format}) {
        if (!rest.starts_with(part))
            return {};
        rest.remove_prefix(part.size());
    }
    if (rest.starts_with('"'))
        rest.remove_prefix(1);
    const auto found =
        std::ranges::find_if(signs, [&](const auto &sign) { return rest.starts_with(sign.first); });
    const std::string_view word = palmercsv::formatWord;
    const std::size_t at = rest.find(word);
    return found != signs.end() && at <= 2 ? std::optional(*found) : std::nullopt; // quoted or not
}

/// A JSON array.
class List {
public:
    void add(std::optional<double> value) {
        m_text += (m_text.empty() ? "" : ",") + (value ? shortest(*value) : "null");
    }
    [[nodiscard]] std::string text() const { return '[' + m_text + ']'; }

private:
    std::string m_text;
};

/// Splits the file into statements, headings and rows of readings.
class Reader {
public:
    Reader(Choices &choices, Imported &imported, char delimiter)
        : m_choices(choices)
        , m_imported(imported)
        , m_table(imported.table)
        , m_delimiter(delimiter) {
        imported.roles.assign(cellCount(), CellRole::ignored);
    }

    void read() {
        takeApart();
        const std::string kind = settled("kind", stated("kind"));
        resolveUnit();
        switch (ofFileWord<Kind>(kind).value_or(Kind::drift)) { // else temperatures
        case Kind::positioning:
            takeRuns();
            break;
        case Kind::circular:
            takeArcs();
            break;
        case Kind::drift:
            takeDrift();
            break;
        }
        Document document = documentOf(m_statements);
        m_imported.test = *document.tests.front();
        m_imported.machine = std::move(document.machine);
        m_imported.instruments = std::move(document.instruments);
    }

private:
    [[nodiscard]] std::size_t cellCount() const {
        const auto rows = m_table.rows();
        return rows.empty() ? 0 : std::size_t(rows.back().first) + rows.back().count;
    }

    [[nodiscard]] std::string textOf(const TableRow &row, std::size_t column) const {
        return column < row.count ? std::string(m_table.text(m_table.cells(row)[column])) : std::string();
    }

    void takeApart() {
        for (const TableRow &row : m_table.rows()) {
            const std::string first = textOf(row, 0);
            if (first.starts_with(palmercsv::mark))
                takeStatement(row, first.substr(std::string_view(palmercsv::mark).size()));
            else if (first == palmercsv::parameter)
                return;
            else if (!m_heading)
                m_heading = &row;
            else if (!m_blocks.empty())
                m_blocks.back().push_back(&row);
            else
                m_blocks.push_back({&row});
        }
    }

    /// The value of a statement line; it may be longer than a cell can hold.
    [[nodiscard]] std::string valueOf(const TableRow &row) const {
        const std::string &all = m_table.text();
        const std::size_t cell = m_table.cells(row).front().begin;
        const std::size_t first = all.find_last_of("\r\n", cell) + 1; // npos + 1 is 0
        const std::size_t end = std::min(all.find_first_of("\r\n", cell), all.size());
        std::vector<std::string> cells(1);
        bool quoted = false;
        for (std::size_t at = first; at < end; ++at) {
            const bool isDoubled = quoted && all[at] == '"' && at + 1 < end && all[at + 1] == '"';
            if (isDoubled || (all[at] != '"' && (quoted || all[at] != m_delimiter)))
                cells.back() += all[at];
            else if (all[at] == '"')
                quoted = !quoted;
            else
                cells.emplace_back();
            at += isDoubled ? 1 : 0;
        }
        return cells.size() > 1 ? cells[1] : std::string();
    }

    /// A comment without value precedes each arc.
    void takeStatement(const TableRow &row, const std::string &key) {
        std::string value = valueOf(row);
        const bool isSpecial = key == palmercsv::format || key == palmercsv::unit || key == palmercsv::sign;
        if (!value.empty())
            (isSpecial ? m_special : m_statements).push_back({key, std::move(value)});
        else if (m_heading)
            m_blocks.emplace_back();
    }

    [[nodiscard]] std::string stated(std::string_view key) const {
        for (const auto *statements : {&m_special, &m_statements}) {
            const auto found = std::ranges::find(*statements, key, &Statement::path);
            if (found != statements->end())
                return found->value;
        }
        refuseContent(REPORT_TEXT("report", "this CSV does not state its “%1”; export it again"),
                      std::string(key));
    }

    std::string settled(const char *choice, const std::string &found) {
        requireKnown({{choice, found}});
        return m_choices.resolve(choice, found, Origin::recognised).value;
    }

    void resolveUnit() {
        const std::string word = stated(palmercsv::unit);
        const Unit *unit = unitOfSign(word);
        const std::string known = settled("unit", unit ? unit->word : word);
        m_unit = unitOf(known);
        if (!m_heading)
            refuseWithoutReadings();
    }

    /// The unit in a column heading.
    [[nodiscard]] const Unit *unitOfHeading(std::size_t column) const {
        const std::string heading = textOf(*m_heading, column);
        const Unit *said = unitIn(heading);
        if (said && said->kind == m_unit->kind && said != m_unit)
            refuseContentAt(placeOfLine(m_heading->line),
                            REPORT_TEXT("report", "“%1” contradicts the unit stated above, %2"), heading,
                            std::string(m_unit->sign));
        return said ? said : m_unit;
    }

    /// The number in a cell, in mm, degrees or s; null if the cell is empty.
    [[nodiscard]] std::optional<double> number(const TableRow &row, std::size_t column, const Unit &unit,
                                               CellRole role) {
        if (column < row.count)
            m_imported.roles[row.first + column] = role;
        const std::string text = textOf(row, column);
        for (const DecimalMark mark : {DecimalMark::point, DecimalMark::comma}) {
            const CellValue value = readCell(text, mark);
            if (value.kind == CellKind::empty)
                return {};
            if (value.kind == CellKind::number)
                return unit.toBase(value.value);
        }
        refuseContentAt(placeOfLine(row.line), REPORT_TEXT("report", "“%1” is no number"), text);
    }

    [[nodiscard]] std::vector<const TableRow *> rows() const {
        return m_blocks.empty() ? std::vector<const TableRow *>() : m_blocks.front();
    }

    void say(std::string path, const List &list) { m_statements.push_back({std::move(path), list.text()}); }

    void takeRuns() {
        const bool negated = settled("sign", stated(palmercsv::sign)) != "actualMinusTarget";
        List targets;
        for (const TableRow *row : rows())
            targets.add(number(*row, columnOf(palmercsv::target), *unitOfHeading(columnOf(palmercsv::target)),
                               CellRole::position));
        say("targets", targets);
        std::size_t run = 0;
        for (std::size_t column = 0; column < m_heading->count; ++column) {
            const std::string heading = textOf(*m_heading, column);
            if (!heading.starts_with(palmercsv::deviation))
                continue;
            const std::string path = "runs[" + std::to_string(run++) + "].";
            const bool up = stated(path + "approach") == fileWord(Direction::positive);
            if (heading.find(up ? "↑" : "↓") == std::string::npos)
                refuseContentAt(placeOfLine(m_heading->line),
                                REPORT_TEXT("report", "“%1” contradicts the direction stated above, %2"),
                                heading, std::string(up ? "↑" : "↓"));
            List deviations;
            for (const TableRow *row : rows()) {
                const auto value = number(*row, column, *unitOfHeading(column),
                                          up ? CellRole::positive : CellRole::negative);
                deviations.add(value && negated ? -*value : value);
            }
            say(path + "deviations", deviations);
        }
        m_choices.resolve("content", "deviations", Origin::recognised);
        if (run == 0)
            m_statements.push_back({"runs", "[]"});
    }

    /// The first column with that heading, whatever its unit.
    [[nodiscard]] std::size_t columnOf(std::string_view name) const {
        for (std::size_t column = 0; column < m_heading->count; ++column) {
            if (withoutUnit(textOf(*m_heading, column)) == name)
                return column;
        }
        refuseContentAt(placeOfLine(m_heading->line), REPORT_TEXT("report", "the heading “%1” is missing"),
                        std::string(name));
    }

    [[nodiscard]] List column(const std::vector<const TableRow *> &block, std::size_t column, CellRole role) {
        List list;
        for (const TableRow *row : block)
            list.add(number(*row, column, *unitOfHeading(column), role));
        return list;
    }

    void takeArcs() {
        for (std::size_t i = 0; i < m_blocks.size(); ++i) {
            const std::string path = "arcs[" + std::to_string(i) + "].";
            say(path + "angles", column(m_blocks[i], 0, CellRole::position));
            say(path + "radialDeviations", column(m_blocks[i], 1, CellRole::positive));
        }
        if (m_blocks.empty())
            m_statements.push_back({"arcs", "[]"});
    }

    void takeDrift() {
        say("times", column(rows(), 0, CellRole::position));
        const auto countOf = [this](const std::string &name) { // "deviation 1", "deviation 2"
            std::size_t count = 0;
            for (std::size_t column = 0; column < m_heading->count; ++column)
                count +=
                    textOf(*m_heading, column).starts_with(name + ' ' + std::to_string(count + 1)) ? 1 : 0;
            return count;
        };
        const std::size_t channels = countOf(palmercsv::deviation);
        const std::size_t temperatures = countOf(palmercsv::temperature);
        std::size_t next = 1;
        if (channels == 0)
            say("deviations", column(rows(), next++, CellRole::positive));
        for (std::size_t i = 0; i < channels; ++i)
            say("channels[" + std::to_string(i) + "].values", column(rows(), next++, CellRole::positive));
        for (std::size_t i = 0; i < temperatures; ++i)
            say("temperatures[" + std::to_string(i) + "].values", column(rows(), next++, CellRole::positive));
    }

    Choices &m_choices;
    Imported &m_imported;
    const CellTable &m_table;
    char m_delimiter;
    std::vector<Statement> m_special;    ///< about the file itself
    std::vector<Statement> m_statements; ///< about the test
    const TableRow *m_heading = nullptr;
    std::vector<std::vector<const TableRow *>> m_blocks; ///< rows of readings; one block per arc
    const Unit *m_unit = nullptr;
};

bool isPalmerCsv(QByteArrayView bytes) {
    constexpr qsizetype enough = 100;
    const QByteArrayView head = bytes.first(std::min(bytes.size(), enough));
    return delimiterOf({head.data(), static_cast<std::size_t>(head.size())}).has_value();
}

void readPalmerCsv(const ImportSource &source, Choices &choices, Imported &imported) {
    std::string text = decodedText(source.bytes, choices, imported);
    const auto [sign, delimiter] = delimiterOf(text).value_or(std::pair{',', Delimiter::comma});
    // A decimal comma is recognised when a number is read.
    imported.table = readTable(std::move(text), {delimiter, DecimalMark::point, false});
    Reader(choices, imported, sign).read();
}

} // namespace

const ImportFormat palmerCsvFormat{"palmer", REPORT_TEXT("report", "CSV of Palmer"), "csv", isPalmerCsv,
                                   readPalmerCsv};

} // namespace palmer
