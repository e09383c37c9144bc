// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"
#include "register/scan.h"

#include <vector>

namespace palmer {

/// Evaluates tests anew under one edition, from the readings in their files; those of other kinds stay as
/// they are. Those whose file cannot be read any more, or no longer holds them, are taken out and returned.
[[nodiscard]] std::vector<Unreadable> reevaluate(std::vector<ListedTest> &tests, const Edition &edition);

} // namespace palmer
