// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "language/language.h"

#include <QString>
#include <string_view>

namespace palmer {

/// Statement of the conditions of a test about a point to be agreed ("warmUp", "feed", …), as the text of the
/// agreement: "2 000 mm/min". Empty if they state nothing or the point does not depend on them.
[[nodiscard]] QString agreedTextFromConditions(const Test &test, std::string_view point,
                                               const Language &language);

} // namespace palmer
