// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "register/queries.h"

#include <QString>

namespace palmer {

/// `register trend`.
int runRegisterTrend(const Invocation &invocation);

/// `register report`: the history of a machine.
int runRegisterReport(const Invocation &invocation);

/// Returns the machine a user means. Throws UsageError if there is none, or if there are several: their
/// numbers.
[[nodiscard]] ListedMachine machineCalled(const std::vector<ListedMachine> &machines, const QString &words,
                                          const Language &language);

/// Value of --register, or the register of the user.
[[nodiscard]] QString registerAddress(const Invocation &invocation);

} // namespace palmer
