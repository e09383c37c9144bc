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

/// Statements of a positioning table about its numbers.
struct FoundForm {
    std::string content; ///< "deviations", "positions", or empty if the headings do not tell
    std::string sign;    ///< proven by actual positions in addition to deviations, otherwise empty
    SaidUnit unit = {};  ///< of the readings
    SaidUnit positionUnit = {};
    bool hasSenses = false; ///< directions are from senses of rotation
    bool hasHints = false;  ///< directions are from letters, abbreviations or titles
};

/// The columns of a positioning table by role.
struct PositioningColumns : FoundForm, LineConditions {
    std::vector<ImportColumn> columns; ///< all columns of the table, each with its role
    std::optional<std::size_t> target;
    std::optional<std::size_t> direction;          ///< column of directions
    std::optional<std::size_t> number;             ///< column of run numbers
    std::vector<std::size_t> values;               ///< readings of one role, one unit and one axis
    std::map<std::size_t, std::size_t> ownTargets; ///< readings next to their own column of targets
};

/// Settles the role of every column: chosen by the user ("columns"), otherwise from the whole words and units
/// of the headings. Columns not understood are ignored with a remark; ambiguous ones become questions. Throws
/// Error if there are no targets or no readings.
[[nodiscard]] PositioningColumns positioningColumns(TableReading &reading);

/// Settles which readings to read if a table has some before and some after an adjustment, with its question.
[[nodiscard]] TestRole resolveState(TableReading &reading);
/// Takes the state that these words say, with a remark.
[[nodiscard]] TestRole statedState(TableReading &reading, TestRole state, std::string_view words);

/// Settles which of several axes in a table to read, with its question.
std::string resolveAxis(TableReading &reading, const std::vector<std::string> &axes);

} // namespace palmer
