// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "report/blocks/report.h"
#include "validation/validation.h"

namespace palmer {

/// Computed and expected values of each set of reference data, for selftest and help.
[[nodiscard]] Report composeValidation(const std::vector<SetValidation> &sets, const Language &language);

} // namespace palmer
