// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/conditioncolumns.h"

#include "document/place.h"
#include "import/notelabels.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <algorithm>

namespace palmer {

namespace {

/// A column that names a condition of each line.
struct ConditionColumn {
    std::size_t column = 0;
    NoteFact condition = NoteFact::machine;
    std::vector<std::string> values = {}; ///< the different ones, in file order
};

/// A cell without the time of day behind its date.
std::string valueOf(std::string_view cell, NoteFact condition) {
    const std::size_t end = cell.find_first_of(" T");
    const bool hasTime = condition == NoteFact::date && isDate(cell.substr(0, end));
    return std::string(hasTime ? cell.substr(0, end) : cell);
}

class ConditionSearch {
public:
    ConditionSearch(TableReading &reading, const std::vector<ImportColumn> &columns, LineConditions &result)
        : m(reading)
        , m_columns(columns)
        , m_result(result) {}

    void take(bool asks) {
        std::vector<ConditionColumn> several;
        for (std::size_t c = 0; c < m.body.columns.size(); ++c) {
            const auto found = conditionIn(c);
            if (!found)
                continue;
            if (found->values.size() > 1)
                several.push_back(*found);
            else if (!found->values.empty() && state(found->condition, c, found->values.front()))
                m_result.conditions.push_back(c);
        }
        if (!asks)
            return;
        if (!several.empty())
            chooseLines(several);
        askForTemperatures();
    }

private:
    [[nodiscard]] std::optional<ConditionColumn> conditionIn(std::size_t c) const {
        constexpr std::size_t most = 20;
        const TableColumn &head = m.body.columns[c];
        const auto condition = factOfWholeTest(head.heading);
        const ColumnRole role = m_columns[c].role;
        if (!condition || head.kind == ColumnKind::empty ||
            (role != ColumnRole::ignored && role != ColumnRole::time))
            return {};
        ConditionColumn found{c, *condition};
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const std::string value = valueOf(m.cellText(row, c), *condition);
                if (value.empty() || std::ranges::find(found.values, value) != found.values.end())
                    continue;
                found.values.push_back(value);
                if (found.values.size() > most)
                    return {};
            }
        }
        // A value of its own in each line is a measured one, or counts.
        const bool isOfLines = found.values.size() > 1 && 2 * found.values.size() > m.body.rowCount();
        return isOfLines ? std::nullopt : std::optional(found);
    }

    /// Uses a value for all lines. False if the test has no place for it.
    bool state(NoteFact condition, std::size_t c, const std::string &value) {
        const auto fill = [&](std::string &field) {
            if (field.empty())
                field = value;
            return field == value;
        };
        switch (condition) {
        case NoteFact::machine:
            return fill(m.notes.machine);
        case NoteFact::serialNumber:
            return fill(m.notes.serialNumber);
        case NoteFact::operatorName:
            return fill(m.notes.operatorName);
        case NoteFact::date:
            return stateDay(value);
        case NoteFact::plane:
            return statePlane(planeIn(value));
        case NoteFact::feed:
            return stateFeed(c, value);
        default:
            return false;
        }
    }

    bool stateDay(const std::string &value) {
        const auto day = isoDate(value);
        if (day && !m.notes.date)
            m.notes.date = day;
        else if (!day && m.notes.dateText.empty())
            m.notes.dateText = value;
        return day ? m.notes.date == day : m.notes.dateText == value;
    }

    bool statePlane(const std::string &plane) {
        if (!plane.empty())
            m.notes.plane = plane; // closer to the numbers than a line above them
        return !plane.empty();
    }

    bool stateFeed(std::size_t c, const std::string &value) {
        const bool hasUnit =
            folded(m.body.columns[c].heading + ' ' + value).find("mm/min") != std::string::npos;
        const LeadingNumber number = leadingNumber(value, m.table().decimalMark.value);
        if (!hasUnit || number.size == 0 || number.value <= 0 ||
            (m.notes.feed && m.notes.feed != number.value))
            return false;
        m.notes.feed = number.value;
        return true;
    }

    /// The values of a line in these columns; an empty cell has that of the line above.
    [[nodiscard]] static std::string joined(const std::vector<std::string> &values) {
        std::string text;
        for (const std::string &value : values)
            text += (text.empty() || value.empty() ? "" : ", ") + value;
        return text;
    }

    void chooseLines(const std::vector<ConditionColumn> &several) {
        std::vector<std::pair<std::uint32_t, std::string>> lines;
        std::vector<std::string> different;
        std::vector<std::string> values(several.size());
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                for (std::size_t k = 0; k < several.size(); ++k) {
                    if (std::string value = valueOf(m.cellText(row, several[k].column), several[k].condition);
                        !value.empty())
                        values[k] = std::move(value);
                }
                lines.emplace_back(row, joined(values));
                if (std::ranges::find(different, lines.back().second) == different.end())
                    different.push_back(lines.back().second);
            }
        }
        const std::string read = resolve(several, different);
        m_result.isOfOtherTest.resize(m.table().rows().size());
        const auto first = std::ranges::find(lines, read, &std::pair<std::uint32_t, std::string>::second);
        for (const ConditionColumn &each : several) {
            m_result.conditions.push_back(each.column);
            const std::string value = valueOf(m.cellText(first->first, each.column), each.condition);
            if (!value.empty())
                state(each.condition, each.column, value);
        }
        for (const auto &[row, line] : lines)
            m_result.isOfOtherTest[row] = line != read;
    }

    std::string resolve(const std::vector<ConditionColumn> &several,
                        const std::vector<std::string> &different) {
        const auto choice = m.choices.resolve("part", different.front(), Origin::guessed);
        std::string list;
        for (const std::string &value : different)
            list += (list.empty() ? "" : "; ") + value;
        if (std::ranges::find(different, choice.value) == different.end())
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("part"),
                          choice.value, list);
        std::string headings;
        for (const ConditionColumn &each : several)
            headings += (headings.empty() ? "" : ", ") + m.body.columns[each.column].heading;
        m.remarks
            .problem("part",
                     REPORT_TEXT("report", "Lines: those of the table differ in “%1” (%2); those of “%3” are "
                                           "read, the others are a test of their own."),
                     excerpt(headings), list, choice.value)
            .answers = different;
        return choice.value;
    }

    void askForTemperatures() {
        constexpr double most = 3; // K, within a test
        for (std::size_t c = 0; c < m.body.columns.size(); ++c) {
            const TableColumn &head = m.body.columns[c];
            if (m_columns[c].role != ColumnRole::temperature || !head.isNumeric() ||
                (head.unit && !head.isIn(UnitKind::temperature)))
                continue;
            const auto [low, high] = m.rangeOf(c);
            const auto inBase = [&](double value) {
                return head.isIn(UnitKind::temperature) ? head.unit->toBase(value) : value;
            };
            if (inBase(high) - inBase(low) > most)
                m.remarks.problem("columns",
                                  REPORT_TEXT("report", "Columns: “%1” runs from %2 to %3; all readings are "
                                                        "read as those of one test."),
                                  excerpt(head.heading), Number{low, Quantity::number},
                                  Number{high, Quantity::number});
        }
    }

    TableReading &m;
    const std::vector<ImportColumn> &m_columns;
    LineConditions &m_result;
};

} // namespace

void takeConditions(TableReading &reading, const std::vector<ImportColumn> &columns, bool asks,
                    LineConditions &result) {
    ConditionSearch(reading, columns, result).take(asks);
}

} // namespace palmer
