#pragma once

#include "commands/command.h"

namespace palmer {

/// Makes a measurement with known truth.
[[nodiscard]] Command synthesizeCommand();

} // namespace palmer
