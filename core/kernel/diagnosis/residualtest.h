// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influencefit.h"

namespace palmer {

/// Returns what in the residual of a fit contradicts its model of the noise, the most telling first; empty
/// if nothing does. The whitened residual is tested for single values, for the variance in sectors of 15°,
/// for runs of signs, its spectrum for lines, for its shape and for a plateau towards slow waves: without
/// one, the noise of the estimates is not known. Each test is meant for 0.2 %; together they were seen to
/// object to 1.6 to 3 % of simulated fits that hold (720 points each way). A residual below 0.02 µm is not
/// tested.
[[nodiscard]] std::vector<Message> misfits(const PathRows &rows, const InfluenceFit &fit);

} // namespace palmer
