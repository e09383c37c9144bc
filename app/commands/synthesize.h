// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"

namespace palmer {

/// Creates a measurement with known truth.
[[nodiscard]] Command synthesizeCommand();

} // namespace palmer
