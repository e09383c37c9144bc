#pragma once

#include "report/testpart.h"

namespace palmer {

/// Statistics per target; what rules a parameter of the axis stands bold.
void addTargetTable(std::vector<Block> &blocks, const PositioningPart &part);

/// All readings as entered: both directions side by side, or ↑ above ↓ where these would be too narrow (more
/// than seven runs a direction); many runs in several tables.
void addReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// Readings set aside, each with its reason.
void addExcludedReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// The results under the editions asked for, side by side, without verdict; and the remarks of the test.
/// `remarks` are those to stand beside them.
void addEditionsAndRemarks(std::vector<Block> &blocks, const TestPart &part, const QString &remarks);

/// The files the measurement came from, with the results their own program states.
void addImports(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
