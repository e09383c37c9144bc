// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

namespace palmer {

/// Takes over from another test of the same machine what is stated once for all its tests: warm-up,
/// compensation, load and state of the machine, where the temperature sensors are, α; the agreed points that
/// name no axis; the decision rule; between tests of one kind (and axes of one motion) also instruments, feed
/// and dwell and what the budget says of instrument and sensors. Left as it is: whatever was measured
/// (temperatures, pressure, humidity, drift), what belongs to the axis (limits, offsets, positions), dates,
/// remarks. Without effect for drift tests, which state no conditions.
void takeStatements(Test &test, const Test &from);

} // namespace palmer
