// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace palmer {

/// Value under a key of a test or of its conditions: text, yes or no, number in the unit of the file, or
/// index of a word in its enumeration (for an optional one 0 for none, words from 1). monostate: no such key,
/// or a value with several parts.
using FieldValue =
    std::variant<std::monostate, std::string, std::optional<bool>, std::optional<double>, std::size_t>;

[[nodiscard]] FieldValue fieldValue(const Test &test, std::string_view key);

/// Returns the requirements of the file format (Demand, combined with |); 0 without such a key.
[[nodiscard]] unsigned fieldDemands(const Test &test, std::string_view key);

/// Has no effect if fieldValue has another type.
void setFieldValue(Test &test, std::string_view key, const FieldValue &value);

/// Returns the keys of the test's conditions.
[[nodiscard]] std::vector<std::string_view> conditionKeys(const Test &test);

} // namespace palmer
