// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/planning/cycleprogram.h"
#include "kernel/planning/targetplan.h"

#include <string>

namespace palmer {

/// The test that a plan prepares: axis, targets and how they were chosen, cycle, feed, dwell, and for each
/// run a row of readings still to come. Judged by that edition.
[[nodiscard]] Test plannedTest(const TargetRequest &request, const TargetPlan &plan,
                               const CycleProgram &program, const std::string &edition);

} // namespace palmer
