// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

// Merged sections of a report over several tests: a statement made by several tests is printed once, with
// their numbers.

/// "1, 3 – 5"; "all" if all `count` tests are listed. `numbers` must be ascending.
[[nodiscard]] QString testNumbers(const Writer &write, const std::vector<int> &numbers, int count);

/// Adds the conditions of all tests, their environment and sensors.
void addConditionsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the paths of the circular tests and their corrections to 20 °C.
void addPathsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the points to be agreed, grouped by edition.
void addAgreedPointsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the limits with their sources, and the decision rules in words.
void addLimitsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the results of tests as found and as left, with the same axis or plane and edition, side by side.
void addBeforeAndAfter(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the remarks of the report and of its tests.
void addRemarksOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the results under the requested editions, with as many tests side by side as fit.
void addComparisonsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the first page of a report over several tests: the overall verdict, and every quantity with a limit,
/// test by test. Tests as found are only informative if there are others.
void addSummary(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

} // namespace palmer
