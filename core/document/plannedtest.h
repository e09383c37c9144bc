// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/planning/cycleprogram.h"
#include "kernel/planning/targetplan.h"

#include <optional>
#include <string>
#include <utility>

namespace palmer {

/// Returns the test prepared by a plan: axis, targets and how they were chosen, cycle, feed, dwell, and for
/// each run a row of readings still to be taken. Judged by `edition`.
[[nodiscard]] Test plannedTest(const TargetRequest &request, const TargetPlan &plan,
                               const CycleProgram &program, const std::string &edition);

/// The nominal interval of a plan as a test states it: to a millionth, not with all digits of a quotient.
[[nodiscard]] std::optional<double> statedInterval(const TargetPlan &plan);

/// Returns the plan that follows from the statements of a positioning test; default values where it has none.
/// The travel, mm or degrees, leaves space at both ends of the axis to approach the targets. Without stated
/// ends it is the travel of the test, otherwise that of the axis. A rotary axis gets one turn, a long axis
/// its agreed zone.
[[nodiscard]] std::pair<TargetRequest, CycleProgram> plannedFor(const Test &test);

/// A test as it is measured: its own targets and the program of its cycle.
struct PlanOfTest {
    PlannedMeasurement planned;
    CycleProgram program;
};

/// Returns targets, runs, directions and cycle as the test has them, the rest like plannedFor(); null for a
/// test without targets and for other kinds. Positions have as many decimals as the targets need, 3 to 9.
[[nodiscard]] std::optional<PlanOfTest> planOf(const Test &test);

} // namespace palmer
