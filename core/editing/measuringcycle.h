// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <optional>

namespace palmer {

// The order in which the machine visits the readings of a positioning test and in which they are typed.
//
// Standard cycle: run by run in the order of the test, from the positive side targets 1…m, from the negative
// side m…1. Step cycle: target by target, at each the runs in the order of the test. A place not in the test
// has no neighbours.

/// The reading after this one; null after the last.
[[nodiscard]] std::optional<ReadingPlace> nextInCycle(const PositioningMeasurement &measurement,
                                                      const ReadingPlace &place);

/// The reading before this one; null before the first.
[[nodiscard]] std::optional<ReadingPlace> previousInCycle(const PositioningMeasurement &measurement,
                                                          const ReadingPlace &place);

/// The first reading of the cycle; null without targets or runs.
[[nodiscard]] std::optional<ReadingPlace> firstOfCycle(const PositioningMeasurement &measurement);

/// The first reading of the cycle that is missing and not excluded: the next to type. Null if none is
/// missing.
[[nodiscard]] std::optional<ReadingPlace> firstMissing(const PositioningMeasurement &measurement);

} // namespace palmer
