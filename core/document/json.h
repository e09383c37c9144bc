// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/jsonprinter.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace palmer {

// The JSON of the test file and of the results. Nothing but document and export knows the library.

/// The value a text says. Throws Error: syntax with `line:column`; duplicate keys, numbers that are not
/// finite and senseless nesting with their path; more than 10⁷ readings or points before they fill the
/// memory.
[[nodiscard]] nlohmann::json parseJson(std::string_view text);

/// The text of a value on one line, numbers in their shortest form that says the same.
[[nodiscard]] std::string compactJson(const nlohmann::json &value);
[[nodiscard]] std::string compactJson(const nlohmann::ordered_json &value);

/// The text of a file: keys in their order (sorted, unless it is an ordered value), two spaces a level,
/// arrays of numbers broken at about 100 columns, small objects on one line, a line break at the end. Throws
/// Error(unwritable) for a number that is not finite.
[[nodiscard]] std::string printJson(const nlohmann::json &value);
[[nodiscard]] std::string printJson(const nlohmann::ordered_json &value);

/// Prints a value among others as printJson would. `place` is that of the value.
void printValue(JsonPrinter &printer, const nlohmann::ordered_json &value, const Place &place);

/// The members of an object, to be printed with others; they refer to its values.
[[nodiscard]] std::vector<JsonMember> membersOf(const nlohmann::ordered_json &object);

/// A member with a value of its own, to be printed among others.
[[nodiscard]] JsonMember jsonMember(std::string_view key, nlohmann::json value);

} // namespace palmer
