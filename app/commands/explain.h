#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command explainCommand();

} // namespace palmer
