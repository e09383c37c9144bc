// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/agreement.h"
#include "kernel/measurement/axis.h"
#include "kernel/measurement/uncertaintyinputs.h"
#include "kernel/uncertainty/simulation.h"
#include "kernel/words/quantity.h"
#include "kernel/words/text.h"

#include <array>
#include <optional>
#include <string>

namespace palmer {

/// A symbol as it is printed: "A↑"; the subscript is set lower on paper ("x̄" "i" "↑").
struct Symbol {
    const char *base = "";
    const char *subscript = "";
    const char *arrow = ""; ///< after the subscript
};

/// always: in every table; onRequest: in JSON always, on the report only where it was asked for.
enum class Printed { always, onRequest };

/// What a parameter is called. `clause` of the edition; empty where it is not known.
struct Term {
    const char *id = "";
    Symbol symbol;
    Text name = {};
    const char *clause = "";
    Quantity quantity = Quantity::deviation;
    Printed printed = Printed::always;
};

/// What makes a parameter as large as it is: a target (counted from 1), and the approach where one rules.
struct Ruling {
    int target = 1;
    std::optional<Direction> approach;

    bool operator==(const Ruling &) const = default;
};

enum class Verdict { conforms, notProven, doesNotConform };

/// How a value stands to its limit: by its size, signed from above (Fmax), signed from below (Fmin).
enum class Bound { magnitude, upper, lower };

/// A parameter of a test. Values, uncertainty and guard band in mm (rotary: degrees), not rounded.
/// `value` is null where a statistic it needs is missing; a finding says why.
struct Parameter {
    Term term;
    std::string index;                 ///< axes of a circular result ("XY"); empty for positioning
    bool dependsOnTemperature = false; ///< wrong away from 20 °C unless corrected
    bool required = true;              ///< one of the results the parties asked for (circular tests)
    std::optional<double> value;
    double size = 0; ///< of the numbers it is a difference of: a circle's radius, mm; 0: of its own
    std::array<std::optional<Ruling>, 2> ruling; ///< the larger end first; first target on ties
    std::optional<double> expandedUncertainty;   ///< U of the deciding method; simulated: 95.45 %, else k = 2
    UncertaintyMethod decidedBy = UncertaintyMethod::none; ///< where that U comes from
    std::optional<double> budgetUncertainty;               ///< U, k = 2, of the budget
    std::optional<double> actualUncertainty;     ///< the same with S_eff in place of S; null: no S in it
    std::optional<double> effectiveSystematic;   ///< S_eff: what the actual targets carry of S
    std::optional<SimulatedParameter> simulated; ///< what a simulation says, if one was run
    std::optional<Limit> limit; ///< of several the one with the worse verdict; of equal verdicts the tighter
    std::string limitOf;        ///< its key: that of the parameter, or "F" at Fmax and Fmin
    Bound bound = Bound::magnitude; ///< how that limit is meant
    std::optional<double> guardBand;
    std::optional<Verdict> verdict; ///< null: no limit, or one agreed for another edition

    /// What the guard band is guardFactor times of: U, of a simulation U + 2 s_U.
    [[nodiscard]] std::optional<double> guardedUncertainty() const;
};

/// "A", "G(b)_XY": the key of results.
[[nodiscard]] std::string parameterId(const Parameter &parameter);

/// The symbol without typography: "A↑", "Psmax", "G(b)XY".
[[nodiscard]] std::string plainSymbol(const Parameter &parameter);

} // namespace palmer
