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

/// `register type`: what the machines of a type say of the type.
int runRegisterType(const Invocation &invocation);

/// Value of an option that the part of `register` cannot do without. Throws UsageError.
[[nodiscard]] QString neededOption(const Invocation &invocation, const char *option);

/// Returns the machine a user means. Throws UsageError if there is none, or if there are several: their
/// numbers.
[[nodiscard]] ListedMachine machineCalled(Database &database, const QString &words, const Language &language);

/// Value of --register, or the register of the user.
[[nodiscard]] QString registerAddress(const Invocation &invocation);

} // namespace palmer
