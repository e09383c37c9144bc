// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "report/blocks/report.h"
#include "validation/validation.h"

namespace palmer {

/// What selftest and the help print: of each set of reference data computed and expected values.
[[nodiscard]] Report composeValidation(const std::vector<SetValidation> &sets, const Language &language);

} // namespace palmer
