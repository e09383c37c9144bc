// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/planning/cycleprogram.h"
#include "kernel/planning/targetplan.h"

#include <string>
#include <utility>

namespace palmer {

/// The test that a plan prepares: axis, targets and how they were chosen, cycle, feed, dwell, and for each
/// run a row of readings still to come. Judged by that edition.
[[nodiscard]] Test plannedTest(const TargetRequest &request, const TargetPlan &plan,
                               const CycleProgram &program, const std::string &edition);

/// The plan that a positioning test asks for by what it states; where it says nothing, the values of a new
/// plan. The travel, mm or degrees, leaves room at both ends of the axis to approach the targets. Without
/// stated ends it is the travel of the test, or else that of the axis. A rotary axis gets one turn, a long
/// axis its agreed zone.
[[nodiscard]] std::pair<TargetRequest, CycleProgram> plannedFor(const Test &test);

} // namespace palmer
