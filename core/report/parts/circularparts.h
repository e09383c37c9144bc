// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// Adds the figure of a circular test with the test parameters next to it (4.4): both senses in one, or the
/// first of the three figures of the standard.
void addActualPaths(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the other figures of the standard, each with the circle it is drawn about; none if the report
/// combines them.
void addSeparateFigures(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the measured and evaluated range of each path and its duration.
void addPaths(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the reference circles with their certificates.
void addCircles(std::vector<Block> &blocks, const CircularPart &part);

/// Adds G of the further arcs of each sense next to that of the first, if the report includes them.
void addRepetitions(std::vector<Block> &blocks, const CircularPart &part);

/// "+10.1": centres need their sign.
[[nodiscard]] QString signedNumber(const Writer &write, double value, Quantity quantity, int decimals);

/// "X −14.9; Y +10.1 µm".
[[nodiscard]] QString centreText(const CircularPart &part, Point centre, int decimals);

} // namespace palmer
