#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command reportCommand();

} // namespace palmer
