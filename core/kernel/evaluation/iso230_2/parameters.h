// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

#include <span>

/// Computation of each parameter of an axis from the statistics per target (ISO 230-2; VDI/DGQ 3441). Pure,
/// without allocation; NaN if a needed statistic is missing. c: factor of s. Results in mm (rotary: degrees).
namespace palmer::iso230_2 {

using Targets = std::span<const TargetStatistics>;

Outcome accuracyUp(Targets targets, double c); ///< A↑ = max(x̄_i↑ + c·s_i↑) − min(x̄_i↑ − c·s_i↑)
Outcome accuracyDown(Targets targets, double c); ///< A↓
Outcome accuracy(Targets targets, double c);     ///< A: the same over both directions together

Outcome systematicUp(Targets targets, double c);   ///< E↑ = max x̄_i↑ − min x̄_i↑
Outcome systematicDown(Targets targets, double c); ///< E↓
Outcome systematic(Targets targets, double c);     ///< E: the same over both directions together
Outcome meanRange(Targets targets, double c);      ///< M = max x̄_i − min x̄_i

Outcome repeatabilityUp(Targets targets, double c);   ///< R↑ = max R_i↑
Outcome repeatabilityDown(Targets targets, double c); ///< R↓ = max R_i↓
Outcome repeatabilityOfAxis(Targets targets,
                            double c); ///< R = max R_i; a direction rules if its R_i↑ or R_i↓ alone is larger
Outcome smallerRepeatability(Targets targets, double c); ///< UPR = min(R↑; R↓)

Outcome meanRepeatabilityUp(Targets targets, double c);   ///< r̄↑: mean of R_i↑
Outcome meanRepeatabilityDown(Targets targets, double c); ///< r̄↓: mean of R_i↓
Outcome meanRepeatability(Targets targets, double c);     ///< r̄: mean of R_i

Outcome reversal(Targets targets, double c);     ///< B = max |B_i|
Outcome meanReversal(Targets targets, double c); ///< B̄: mean of the signed B_i

Outcome vdiMeanReversal(Targets targets, double c); ///< Ū: mean of U_i = |B_i|
Outcome vdiScatter(Targets targets, double c);      ///< Ps max = max Ps_i, Ps_i = 2c·s̄_i = 6 s̄_i
Outcome vdiMeanScatter(Targets targets, double c);  ///< P̄s: mean of Ps_i
Outcome vdiUncertainty(Targets targets,
                       double c); ///< P = max(x̄_i + (U_i + Ps_i)/2) − min(x̄_i − (U_i + Ps_i)/2)

/// Returns the same formula for four tests at once, identical per lane to the last bit; the values must exist
/// in all of them. Null for a function not listed above.
using LanesFormula = Lanes (*)(std::span<const TargetStatisticsOf<Lanes>>, double c);
[[nodiscard]] LanesFormula inLanes(Outcome (*value)(Targets, double));

} // namespace palmer::iso230_2
