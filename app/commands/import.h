#pragma once

#include "commands/command.h"

namespace palmer {

[[nodiscard]] Command importCommand();

} // namespace palmer
