// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"

namespace palmer {

/// A plan of targets, or the part program that measures it.
[[nodiscard]] Command targetsCommand();

} // namespace palmer
