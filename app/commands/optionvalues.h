#pragma once

#include "commands/command.h"

#include <cstdint>
#include <optional>

namespace palmer {

/// "--OPTION cannot be GIVEN": throws UsageError.
[[noreturn]] void refuse(const char *option, const QString &given);

/// The number of an option, as a cell of the window reads it; nothing without the option. Throws UsageError
/// for what is no finite number.
[[nodiscard]] std::optional<double> numberOf(const Invocation &invocation, const char *option);

/// The number that is `given` to the option. Throws as numberOf().
[[nodiscard]] double numberGiven(const char *option, const QString &given);

/// --seed, a whole number that a test file can keep; nothing without it. Throws UsageError.
[[nodiscard]] std::optional<std::int64_t> seedOf(const Invocation &invocation);

} // namespace palmer
