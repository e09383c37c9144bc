// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/columnrole.h"
#include "import/layouts/tablereading.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// Which columns of a table of a positioning test are what.
struct PositioningColumns {
    std::vector<ImportColumn> columns; ///< all of the table, each with its role
    std::optional<std::size_t> target;
    std::optional<std::size_t> direction;          ///< a column of directions
    std::optional<std::size_t> number;             ///< a column of numbers of runs
    std::vector<std::size_t> values;               ///< readings: of one role, one unit, one axis
    std::map<std::size_t, std::size_t> ownTargets; ///< readings beside a column of targets of their own
    std::string content;    ///< "deviations", "positions", or empty: the headings do not say
    std::string sign;       ///< proven by actual positions beside the deviations, else empty
    SaidUnit unit = {};     ///< of the readings
    bool hasSenses = false; ///< directions were taken from senses of rotation
    bool hasHints = false;  ///< directions were taken from letters or abbreviations
};

/// Settles the role of every column: what the user chose ("columns"), else what the whole words of the
/// headings and the units say. What is not understood is ignored, with a remark; what can be understood in
/// two ways is asked. Throws Error where there are no targets or no readings.
[[nodiscard]] PositioningColumns positioningColumns(TableReading &reading);

/// The question which of several axes in one table is read.
/// Which state is read, where a table has readings before and after an adjustment, with its question.
[[nodiscard]] TestRole settleState(TableReading &reading);

[[nodiscard]] Remark askForAxis(const std::vector<std::string> &axes, const std::string &axis);

} // namespace palmer
