#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command checkCommand();

} // namespace palmer
