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

/// What is to be planned for a positioning test as it stands, from what it states; where it says nothing, the
/// values of a new plan. The travel lies between the ends of the axis, which it approaches its targets
/// within; where they are not stated it is that of the test, or of the axis; of a rotary axis one turn; of a
/// long axis its agreed zone.
[[nodiscard]] std::pair<TargetRequest, CycleProgram> plannedFor(const Test &test);

} // namespace palmer
