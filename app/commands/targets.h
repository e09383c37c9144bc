#pragma once

#include "commands/command.h"

namespace palmer {

/// A plan of targets, or the part program that measures it.
[[nodiscard]] Command targetsCommand();

} // namespace palmer
