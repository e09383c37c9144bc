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

/// What a test says under a key of its own or of its conditions: a text, yes or no, a number in the unit of
/// the file, or the place of a word in its enumeration (of an optional one 0 for none, the words from 1).
/// monostate: it has no such key, or something of several parts stands there.
using FieldValue =
    std::variant<std::monostate, std::string, std::optional<bool>, std::optional<double>, std::size_t>;

[[nodiscard]] FieldValue fieldValue(const Test &test, std::string_view key);

/// What the file format demands of it (Demand, joined with |); 0 without such a key.
[[nodiscard]] unsigned fieldDemands(const Test &test, std::string_view key);

/// Without effect where fieldValue has another type.
void setFieldValue(Test &test, std::string_view key, const FieldValue &value);

/// Those of its conditions.
[[nodiscard]] std::vector<std::string_view> conditionKeys(const Test &test);

} // namespace palmer
