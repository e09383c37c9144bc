#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command selftestCommand();

} // namespace palmer
