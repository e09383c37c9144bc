#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command exportCommand();

} // namespace palmer
