// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// Statistics per target, a row each; what rules a parameter of the axis is bold.
[[nodiscard]] Table targetTable(const PositioningPart &part);

/// Statistics per target, what rules a parameter of the axis bold; and all readings as entered: in the same
/// table where they find room, else below it, both directions side by side, or ↑ above ↓ where these would be
/// too narrow (more than seven runs a direction); many runs in several tables.
void addTargetsAndReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// About how many pages of rows "all readings" prints that the report leaves out without it; 0: none.
[[nodiscard]] int pagesOfAllReadings(const Document &document);

/// Readings set aside, each with its reason.
void addExcludedReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// The results under the editions asked for, side by side, without verdict; null where none is. The first
/// column holds the symbols, below its title the unit. `narrow`: the factors stand as "c = 2".
[[nodiscard]] std::optional<Table> editionsTable(const TestPart &part, bool narrow = false);

/// It and the remarks of the test, beside each other where they fit.
void addEditionsAndRemarks(std::vector<Block> &blocks, const TestPart &part, const QString &remarks);

/// The files the measurement came from, with the results their own program states.
void addImports(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
