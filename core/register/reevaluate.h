// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"
#include "register/scan.h"

#include <vector>

namespace palmer {

/// Re-evaluates tests under one edition, from the readings in their files; tests of other kinds are
/// unchanged. Those whose file is unreadable or no longer contains them are removed and returned.
[[nodiscard]] std::vector<Unreadable> reevaluate(std::vector<ListedTest> &tests, const Edition &edition);

} // namespace palmer
