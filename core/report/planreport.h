// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/cycleprogram.h"
#include "kernel/planning/targetplan.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <QString>
#include <optional>
#include <span>

namespace palmer {

/// Printable plan of a measurement for use at the machine, for the travel and, on a long axis, the zone: what
/// was planned and how, and a table of targets with an empty field for every reading, in measuring order.
/// `program`: of the first plan; targets and runs are those of each plan.
[[nodiscard]] Report composePlan(std::span<const PlannedMeasurement> planned, const CycleProgram &program,
                                 const Language &language);

/// The fault of a cycle that moves beyond its axis; null if it does not. It follows the sentence that
/// says from where to where the axis moves.
[[nodiscard]] std::optional<Message> overtravelText(const CycleProgram &program,
                                                    const TargetRequest &request);

/// Only the targets, one per line: number, tab, position with a decimal point.
[[nodiscard]] QString targetList(const TargetPlan &plan, int decimals);

} // namespace palmer
