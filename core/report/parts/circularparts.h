// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The figure of a circular test with the parameters of the test beside it (4.4): both senses in one, or the
/// first of the three figures of the standard.
void addActualPaths(std::vector<Block> &blocks, const CircularPart &part);

/// The other figures of the standard, each with the circle it is drawn about; nothing where the report has
/// them combined.
void addSeparateFigures(std::vector<Block> &blocks, const CircularPart &part);

/// What was measured of each path and what of it is evaluated; how long it took.
void addPaths(std::vector<Block> &blocks, const CircularPart &part);

/// The reference circles with their certificates.
void addCircles(std::vector<Block> &blocks, const CircularPart &part);

/// G of the further arcs of each sense, beside that of the first; only where the report asks for it.
void addRepetitions(std::vector<Block> &blocks, const CircularPart &part);

/// "+10.1": centres say on which side they are.
[[nodiscard]] QString signedNumber(const Writer &write, double value, Quantity quantity, int decimals);

/// "X −14.9; Y +10.1 µm".
[[nodiscard]] QString centreText(const CircularPart &part, Point centre, int decimals);

} // namespace palmer
