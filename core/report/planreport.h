// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/cycleprogram.h"
#include "kernel/planning/targetplan.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <QString>
#include <span>

namespace palmer {

/// The plan of a measurement as it is printed and taken to the machine: of the travel, and of the zone of a
/// long axis, what was planned and how, and a table of the targets with an empty field for every reading, in
/// the order they are taken. `program`: of the first; its targets and runs are those of each plan.
[[nodiscard]] Report composePlan(std::span<const PlannedMeasurement> planned, const CycleProgram &program,
                                 const Language &language);

/// The targets alone, one a line: number, tabulator, position with a decimal point.
[[nodiscard]] QString targetList(const TargetPlan &plan, int decimals);

} // namespace palmer
