// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/agreement.h"
#include "kernel/measurement/axis.h"
#include "kernel/measurement/circular.h"
#include "kernel/measurement/uncertaintyinputs.h"
#include "kernel/uncertainty/simulation.h"
#include "kernel/words/quantity.h"
#include "kernel/words/text.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// A symbol as it is printed: "A↑"; the subscript is set lower on paper ("x̄" "i" "↑").
struct Symbol {
    const char *base = "";
    const char *subscript = "";
    const char *arrow = ""; ///< after the subscript
};

/// always: in every table; onRequest: in JSON always, on the report only where it was asked for.
enum class Printed { always, onRequest };

/// What lists call a parameter: the standards' own names are too long for a column.
struct ShortName {
    Text below;       ///< beside the first of its family; empty: the name
    Text alone = {};  ///< where that does not stand above it; empty: the same
    Text narrow = {}; ///< where there is little room for that, or the name; empty: the same
};

/// What a parameter is of: an axis, one path of a circle, both paths together.
enum class Of { axis, path, pair };

/// Whether it is read first, or looked up.
enum class Weight { main, detail };

/// How a value stands to its limit: by its size, signed from above (Fmax), signed from below (Fmin).
enum class Bound { magnitude, upper, lower };

/// All that is to be known of a parameter but how it is computed. `clause` of the edition; empty where it is
/// not known.
struct Term {
    const char *id = "";
    Symbol symbol;
    Text name = {};
    const char *clause = "";
    const char *family = ""; ///< of those that belong together: "A" of A, A↑ and A↓
    ShortName shortName = {};
    Weight weight = Weight::main;
    Printed printed = Printed::always;
    Of of = Of::axis;
    OfCircle circle = OfCircle::nothing;
    Bound bound = Bound::magnitude;
    const char *also = ""; ///< what limits and requests call it with others: "F" of Fmax and Fmin
    Quantity quantity = Quantity::deviation;

    /// Whether `word`, of limits or of requests, means it.
    [[nodiscard]] bool isMeantBy(std::string_view word) const {
        return word == id || (*also && word == also);
    }
};

/// What makes a parameter as large as it is: a target (counted from 1), and the approach where one rules.
struct Ruling {
    int target = 1;
    std::optional<Direction> approach;

    bool operator==(const Ruling &) const = default;
};

enum class Verdict { conforms, notProven, doesNotConform };

/// A parameter of a test. Values, uncertainty and guard band in mm (rotary: degrees), not rounded.
/// `value` is null where a statistic it needs is missing; a finding says why.
struct Parameter {
    Term term;
    std::string index;                 ///< axes of a circular result ("XY"); empty for positioning
    bool dependsOnTemperature = false; ///< wrong away from 20 °C unless corrected
    bool calibrationOpen = false;      ///< nobody says whether its reference length is calibrated
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

/// A limit with a value is agreed for it, by its own name or with others; for anything.
[[nodiscard]] bool hasLimit(const Limits &limits, const Term &term);
[[nodiscard]] bool hasLimits(const Limits &limits);

/// "A", "G(b)_XY": the key of results.
[[nodiscard]] std::string parameterId(const Parameter &parameter);

/// The symbol without typography: "A↑", "Psmax", "G(b)XY".
[[nodiscard]] std::string plainSymbol(const Parameter &parameter);

} // namespace palmer
