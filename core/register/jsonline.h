// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/json.h"
#include "document/jsonformats.h"

#include <QByteArray>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace palmer {

using Json = nlohmann::ordered_json;

/// Returns null for an empty or missing text, and for a missing number or one that is not finite.
[[nodiscard]] inline Json orNull(const std::string &text) {
    return text.empty() ? Json() : Json(text);
}
[[nodiscard]] inline Json orNull(const std::optional<std::string> &text) {
    return text ? Json(*text) : Json();
}
[[nodiscard]] inline Json orNull(std::optional<double> number) {
    return number && std::isfinite(*number) ? Json(*number) : Json();
}

/// Returns an object of a format (jsonformats.h) on a line of its own.
[[nodiscard]] inline QByteArray jsonLine(std::string_view format, const Json &object) {
    Json whole = jsonHead(format);
    whole.update(object);
    return QByteArray::fromStdString(compactJson(whole)) + '\n';
}

} // namespace palmer
