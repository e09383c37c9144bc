// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"

namespace palmer {

// The commands in the order of the help, each in the source of its name.
[[nodiscard]] Command evaluateCommand();
[[nodiscard]] Command checkCommand();
[[nodiscard]] Command reportCommand();
[[nodiscard]] Command verifyCommand();
[[nodiscard]] Command figureCommand();
[[nodiscard]] Command explainCommand();
[[nodiscard]] Command compareCommand();
[[nodiscard]] Command importCommand();
[[nodiscard]] Command exportCommand();
[[nodiscard]] Command targetsCommand(); ///< a plan of targets, or the part program that measures it
[[nodiscard]] Command feedCommand();
[[nodiscard]] Command synthesizeCommand(); ///< creates a measurement with known truth
[[nodiscard]] Command registerCommand();
[[nodiscard]] Command schemaCommand();
[[nodiscard]] Command selftestCommand();

} // namespace palmer
