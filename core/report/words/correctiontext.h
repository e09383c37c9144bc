// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/text.h"
#include "language/language.h"

#include <QString>

namespace palmer {

/// The correction to 20 °C as stated; one that was to be made here and could not be says so.
[[nodiscard]] Text correctionText(const Test &test);

/// The largest correction to 20 °C of a test, applied or not: "13.8 µm over 1 500 mm", the differential
/// expansion over the farthest target from the origin or over the radius. Empty if temperatures or
/// coefficients are missing, or there are no lengths.
[[nodiscard]] QString correctionSizeText(const Test &test, const Language &language);

} // namespace palmer
