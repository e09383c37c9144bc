// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "ui/forms/member.h"

#include <optional>
#include <string_view>

namespace palmer::ui {

/// The number that was agreed on a point; to state one is to agree.
[[nodiscard]] Member<std::optional<double>> agreedValue(const char *point);

/// What the number of a point is in this test; null for points that are agreed in words alone.
[[nodiscard]] std::optional<Quantity> agreedQuantity(std::string_view point, const Test &test);

} // namespace palmer::ui
