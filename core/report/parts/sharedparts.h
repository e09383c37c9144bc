// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

// What the tests of a report over several of them state of the same things stands in one place: a statement
// that several tests make stands once, with their numbers.

/// "1, 3 – 5"; "all" for every one of `count`. `numbers` ascend.
[[nodiscard]] QString testNumbers(const Writer &write, const std::vector<int> &numbers, int count);

/// The conditions of all tests, their environment and sensors.
void addConditionsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// The paths of the circular tests and their corrections to 20 °C.
void addPathsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// The points to be agreed, those of one edition together.
void addAgreedPointsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// The limits with their sources, and the decision rules in words.
void addLimitsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// What tests as found and as left, of one axis or plane and edition, gave: side by side.
void addBeforeAndAfter(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// The remarks of the report and of its tests.
void addRemarksOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// The results under the editions asked for, as many tests beside each other as find room.
void addComparisonsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

} // namespace palmer
