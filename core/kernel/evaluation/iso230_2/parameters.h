// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

/// Computation of each parameter of an axis from the statistics per target (ISO 230-2; VDI/DGQ 3441). Pure,
/// without allocation; NaN if a needed statistic is missing. c: factor of s. Results in mm (rotary: degrees).
namespace palmer::iso230_2 {

extern const ParameterFormula accuracyUp; ///< A↑ = max(x̄_i↑ + c·s_i↑) − min(x̄_i↑ − c·s_i↑)
extern const ParameterFormula accuracyDown; ///< A↓
extern const ParameterFormula accuracy;     ///< A: the same over both directions together

extern const ParameterFormula systematicUp;   ///< E↑ = max x̄_i↑ − min x̄_i↑
extern const ParameterFormula systematicDown; ///< E↓
extern const ParameterFormula systematic;     ///< E: the same over both directions together
extern const ParameterFormula meanRange;      ///< M = max x̄_i − min x̄_i

extern const ParameterFormula repeatabilityUp;   ///< R↑ = max R_i↑
extern const ParameterFormula repeatabilityDown; ///< R↓ = max R_i↓
extern const ParameterFormula
    repeatabilityOfAxis; ///< R = max R_i; a direction rules if its R_i↑ or R_i↓ alone is larger
extern const ParameterFormula smallerRepeatability; ///< UPR = min(R↑; R↓)

extern const ParameterFormula meanRepeatabilityUp;   ///< r̄↑: mean of R_i↑
extern const ParameterFormula meanRepeatabilityDown; ///< r̄↓: mean of R_i↓
extern const ParameterFormula meanRepeatability;     ///< r̄: mean of R_i

extern const ParameterFormula reversal;     ///< B = max |B_i|
extern const ParameterFormula meanReversal; ///< B̄: mean of the signed B_i

extern const ParameterFormula vdiMeanReversal; ///< Ū: mean of U_i = |B_i|
extern const ParameterFormula vdiScatter;      ///< Ps max = max Ps_i, Ps_i = 2c·s̄_i = 6 s̄_i
extern const ParameterFormula vdiMeanScatter;  ///< P̄s: mean of Ps_i
extern const ParameterFormula vdiUncertainty; ///< P = max(x̄_i + (U_i + Ps_i)/2) − min(x̄_i − (U_i + Ps_i)/2)

} // namespace palmer::iso230_2
