#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command verifyCommand();

} // namespace palmer
