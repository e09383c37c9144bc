#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command feedCommand();

} // namespace palmer
