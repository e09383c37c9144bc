#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command figureCommand();

} // namespace palmer
