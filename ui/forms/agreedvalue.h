// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "ui/forms/member.h"

#include <optional>
#include <string_view>

namespace palmer::ui {

/// The number agreed for a point; setting it declares the point agreed.
[[nodiscard]] Member<std::optional<double>> agreedValue(const char *point);

/// The quantity of a point's number in this test; null for points agreed only in words.
[[nodiscard]] std::optional<Quantity> agreedQuantity(std::string_view point, const Test &test);

} // namespace palmer::ui
