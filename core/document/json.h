// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/jsonprinter.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

// The JSON of the test file and of the results. Only document, export and register use the library.

/// Parses a text. Throws Error: syntax with `line:column`; duplicate keys, non-finite numbers and excessive
/// nesting with their path; more than 10⁷ readings or points before they fill the memory.
[[nodiscard]] nlohmann::json parseJson(std::string_view text);

/// Returns a value on one line, numbers in their shortest round-trip form.
[[nodiscard]] std::string compactJson(const nlohmann::json &value);
[[nodiscard]] std::string compactJson(const nlohmann::ordered_json &value);

/// Returns null for a value that is absent or not finite.
[[nodiscard]] nlohmann::ordered_json numberOrNull(std::optional<double> value);

/// Returns the text of a file: keys in order (sorted, unless it is an ordered value), two spaces per level,
/// arrays of numbers wrapped at about 100 columns, small objects on one line, a final line break. Throws
/// Error(unwritable) for a non-finite number.
[[nodiscard]] std::string printJson(const nlohmann::json &value);
[[nodiscard]] std::string printJson(const nlohmann::ordered_json &value);

/// Prints a value among others as printJson would. `place` is the place of the value.
void printValue(JsonPrinter &printer, const nlohmann::ordered_json &value, const Place &place);

/// Returns the members of an object, for printing with others; they refer to its values.
[[nodiscard]] std::vector<JsonMember> membersOf(const nlohmann::ordered_json &object);

/// Returns a member that owns its value, for printing with others.
[[nodiscard]] JsonMember jsonMember(std::string_view key, nlohmann::json value);

} // namespace palmer
