// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

namespace palmer {

/// Text alternative of a figure for screen readers: what is drawn, over what, from which value to which, with
/// the texts and in the units of the figure.
[[nodiscard]] QString figureSentence(const Figure &figure, const Language &language);

} // namespace palmer
