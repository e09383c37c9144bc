// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The first page of a report over several tests: the verdict of all, and every quantity that has a limit,
/// test by test. Tests as found are printed for information where there are others.
void addSummary(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

} // namespace palmer
