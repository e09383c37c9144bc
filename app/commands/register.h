#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command registerCommand();

} // namespace palmer
