// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/remark.h"
#include "kernel/measurement/test.h"

#include <vector>

namespace palmer {

/// Adds red questions about suspicious numbers, each with its run: deviations above 1 mm or 0.1°, runs whose
/// spread is a hundred times that of the others, deviations equal to the targets, readings that are all 0.
void questionNumbers(const Test &test, std::vector<Remark> &remarks);

} // namespace palmer
