// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// Statistics per target, one row each; values that rule a parameter of the axis are bold.
[[nodiscard]] Table targetTable(const PositioningPart &part);

/// Adds the statistics per target, with ruling values bold, and all readings as entered: in the same table if
/// they fit, otherwise below it with both directions side by side, or ↑ above ↓ if these would be too narrow
/// (more than seven runs per direction); many runs in several tables.
void addTargetsAndReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// Estimates the pages of rows that "all readings" adds to the report; 0: none.
[[nodiscard]] int pagesOfAllReadings(const Document &document);

/// Adds the excluded readings, each with its reason.
void addExcludedReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// Results under the requested editions, side by side, without verdict; null if none is requested. The first
/// column contains the symbols, with the unit below its title. `narrow`: factors are printed as "c = 2".
[[nodiscard]] std::optional<Table> editionsTable(const TestPart &part, bool narrow = false);

/// Adds this table and the remarks of the test, side by side if they fit.
void addEditionsAndRemarks(std::vector<Block> &blocks, const TestPart &part, const QString &remarks);

/// Adds the files the measurement came from, with the results stated by their programs.
void addImports(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
