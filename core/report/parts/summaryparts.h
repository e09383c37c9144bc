// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// Adds the first page of a report over several tests: the overall verdict, and every quantity with a limit,
/// test by test. Tests as found are only informative if there are others.
void addSummary(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

} // namespace palmer
