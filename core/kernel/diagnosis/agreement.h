// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influencefit.h"

namespace palmer {

/// Objections to single terms of a fit.
struct Agreement {
    std::vector<std::vector<Message>> objections; ///< per term
    bool stepBetweenSenses = false; ///< radii that differ between the senses explain what the fit does not
};

/// Compares what should say the same within 3 u: the reversals of an axis in each sense (backlash, spikes),
/// even and odd sectors of 15°, plain weights and Huber's (1.345), and lateral play with radii that differ
/// between the senses.
[[nodiscard]] Agreement agreement(const PathRows &rows, const InfluenceFit &fit);

/// Returns how many reversals of a term are in the data, negative if those fitted alone contradict each
/// other.
[[nodiscard]] int reversals(const PathRows &rows, const InfluenceFit &fit, const FitTerm &term);

} // namespace palmer
