// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "language/language.h"

#include <QString>
#include <string_view>

namespace palmer {

/// What the conditions of a test say of a point to be agreed ("warmUp", "feed", …), as the text of the
/// agreement: "2 000 mm/min". Empty where they say nothing, or the point has nothing to do with them.
[[nodiscard]] QString agreedTextFromConditions(const Test &test, std::string_view point,
                                               const Language &language);

} // namespace palmer
