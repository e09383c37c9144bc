// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

namespace palmer {

/// Copies from another test of the same machine the statements common to all its tests: warm-up,
/// compensation, load and state of the machine, positions of the temperature sensors, α; the agreed points
/// that name no axis; the decision rule; between tests of one kind (and axes of one motion) also instruments,
/// feed and dwell, and the budget inputs on instrument and sensors. Unchanged: measured values (temperatures,
/// pressure, humidity, drift), what belongs to the axis (limits, offsets, positions), dates, remarks. No
/// effect on drift tests, which state no conditions.
void takeStatements(Test &test, const Test &from);

} // namespace palmer
