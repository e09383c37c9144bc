// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "tables/choice.h"
#include "tables/units.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// Meaning of a column's numbers. Columns of different roles are never pooled.
enum class ColumnRole : std::uint8_t {
    ignored,
    target,
    actual, ///< actual positions, of one run or of all
    deviation,
    run,       ///< readings of one run: positions or deviations, by the choice "content"
    direction, ///< direction of approach of each line, or sense of contouring
    number,    ///< run number of each line
    angle,
    radius,
    x, ///< the first coordinate
    y, ///< the second coordinate
    time,
    temperature,
    nominal,
    statistic,
};

/// A column of the recognised table with its role.
struct ImportColumn {
    ColumnRole role = ColumnRole::ignored;
    std::optional<Direction> direction = {}; ///< of a run, if stated; positive: counterclockwise
    unsigned number = 0;                     ///< of a run, from 1; 0: not stated
    const Unit *unit = nullptr;              ///< of the heading; may be null
    std::string heading = {};

    bool operator==(const ImportColumn &) const = default;

    /// True if the column holds readings of a positioning test.
    [[nodiscard]] bool hasReadings() const {
        return role == ColumnRole::run || role == ColumnRole::actual || role == ColumnRole::deviation;
    }
    /// True if it can have a direction, or the sense of a path of a circle.
    [[nodiscard]] bool canHaveDirection() const {
        return hasReadings() || role == ColumnRole::radius || role == ColumnRole::y;
    }
};

/// Rows of the same columns: one of several tables of a file.
struct ListedTable {
    std::size_t firstLine = 0; ///< of its numbers, from 1
    std::size_t lastLine = 0;
    std::size_t rows = 0;
    std::string headings; ///< of its columns, joined

    bool operator==(const ListedTable &) const = default;
};

/// The roles in the format of the choice "columns": "target,ignored,run+1,run-1,run"; `+` and `-` are the
/// direction, the number is that of the run.
[[nodiscard]] std::string wordOf(const std::vector<ImportColumn> &columns);

/// The roles named by such a text; null for an unknown word, which is stored in `unknown`.
[[nodiscard]] std::optional<std::vector<ImportColumn>> columnsOf(std::string_view text,
                                                                 std::string *unknown = nullptr);

/// The index of the first item of that value; null if there is none.
template <class Items, class Value, class Projection>
[[nodiscard]] std::optional<std::size_t> indexOf(const Items &items, const Value &value,
                                                 Projection projection) {
    const auto found = std::ranges::find(items, value, projection);
    return found == items.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - items.begin()));
}

/// The first column of that role; null if there is none.
[[nodiscard]] inline std::optional<std::size_t> columnOf(const std::vector<ImportColumn> &columns,
                                                         ColumnRole role) {
    return indexOf(columns, role, &ImportColumn::role);
}

/// The words for roles, for help and errors.
[[nodiscard]] std::string roleWords();

} // namespace palmer
