// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "kernel/measurement/axis.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace palmer {

/// "--OPTION cannot be GIVEN; expected FORM": throws UsageError.
[[noreturn]] void refuse(const char *option, const QString &given, const std::string &form);

/// The number of an option, with a point or a comma, with a power of ten (1e3) or without; nothing without
/// the option. Throws UsageError for what is no finite number, and for "1,000", which may be one or a
/// thousand.
[[nodiscard]] std::optional<double> numberOf(const Invocation &invocation, const char *option);

/// The number that is `given` to the option. Throws as numberOf().
[[nodiscard]] double numberGiven(const char *option, const QString &given);

/// The same from `least` to `most`, and greater than a bound.
[[nodiscard]] double numberBetween(const char *option, const QString &given, double least, double most);
[[nodiscard]] double numberAbove(const char *option, const QString &given, double bound);

/// "FROM:TO", ascending. Throws UsageError.
[[nodiscard]] Interval intervalGiven(const char *option, const QString &given);

/// A whole number, also with a power of ten (1e6); nothing for any other.
[[nodiscard]] std::optional<long long> wholeGiven(const QString &given);

/// The same from `least` to `most`. Throws UsageError.
[[nodiscard]] long long wholeBetween(const char *option, const QString &given, long long least,
                                     long long most);

/// Index of the test that --test asks for, from 1, of `count`; without it the first. Throws UsageError where
/// there is none.
[[nodiscard]] std::size_t testIndex(const Invocation &invocation, std::size_t count);

/// --seed, a whole number that a test file can keep; nothing without it. Throws UsageError.
[[nodiscard]] std::optional<std::int64_t> seedOf(const Invocation &invocation);

} // namespace palmer
