// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"

#include <QString>

namespace palmer {

/// `register trend`.
int runRegisterTrend(const Invocation &invocation);

/// `register report`: the history of a machine.
int runRegisterReport(const Invocation &invocation);

/// Throws Error if there is no register; the first scan creates it.
void requireRegister(const Invocation &invocation);

/// Value of --register, or the register of the user.
[[nodiscard]] QString registerAddress(const Invocation &invocation);

} // namespace palmer
