// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

// Paths in a test file, as errors report places: "tests[0].limits.A.value".

/// A key, or the index of an element from 0.
struct FieldStep {
    std::string key;
    std::optional<std::size_t> index = {};
};

/// Parses a path: "tests[0].limits" → tests, 0, limits. Throws Error if it is not one.
[[nodiscard]] std::vector<FieldStep> stepsOf(std::string_view path);

/// Throws Error: the text is no path of a test file.
[[noreturn]] void refusePath(std::string_view path);

/// Sets a value at a path; missing parents are created, an element after the last is appended. Throws Error
/// with the path if the file has something else on the way.
void setAt(nlohmann::json &place, std::span<const FieldStep> steps, const nlohmann::json &value,
           std::string_view path);

/// Returns the test file of a document as JSON.
[[nodiscard]] nlohmann::json fileOf(const Document &document);

/// Returns the demands of a field of a struct: without a unit of its own it has that of its struct, with its
/// demands.
[[nodiscard]] unsigned demandsIn(unsigned ofStruct, unsigned own);

/// Returns the possible meanings of a value, the most likely first: a JSON literal, a number with a comma,
/// the text itself.
[[nodiscard]] std::vector<nlohmann::json> meaningsOf(std::string_view value);

} // namespace palmer
