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

// Paths of a test file, as errors name places: "tests[0].limits.A.value".

/// A key, or the index of an element from 0.
struct FieldStep {
    std::string key;
    std::optional<std::size_t> index = {};
};

/// "tests[0].limits" → tests, 0, limits. Throws Error for what is no path.
[[nodiscard]] std::vector<FieldStep> stepsOf(std::string_view path);

/// Puts a value there; what is missing on the way is made, an element behind the last is added. Throws Error
/// that names the path where the file has something else on the way.
void setAt(nlohmann::json &place, std::span<const FieldStep> steps, const nlohmann::json &value,
           std::string_view path);

/// The test file of a document as JSON.
[[nodiscard]] nlohmann::json fileOf(const Document &document);

/// The possible meanings of a value, the likeliest first: a literal of JSON, a number with a comma, the text
/// itself.
[[nodiscard]] std::vector<nlohmann::json> meaningsOf(std::string_view value);

} // namespace palmer
