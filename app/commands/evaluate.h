#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command evaluateCommand();

} // namespace palmer
