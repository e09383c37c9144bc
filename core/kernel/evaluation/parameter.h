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

/// A symbol as printed: "A↑"; the subscript is set lower on paper ("x̄" "i" "↑").
struct Symbol {
    const char *base = "";
    const char *subscript = "";
    const char *arrow = ""; ///< after the subscript
};

/// always: in every table; onRequest: always in JSON, in the report only on request.
enum class Printed { always, onRequest };

/// Names of a parameter in lists: the standards' own names are too long for a column.
struct ShortName {
    Text below;       ///< below the first of its family; empty: the name
    Text alone = {};  ///< if the first of its family is not above it; empty: the same
    Text narrow = {}; ///< if there is little room for that, or for the name; empty: the same
};

/// Subject of a parameter: an axis, one path of a circle, or both paths together.
enum class Of { axis, path, pair };

/// Main result, or one for reference.
enum class Weight { main, detail };

/// How a value is compared with its limit: by magnitude, signed from above (Fmax), signed from below (Fmin).
enum class Bound { magnitude, upper, lower };

/// Properties of a parameter except its computation. `clause` of the edition; empty if unknown.
struct Term {
    const char *id = "";
    Symbol symbol;
    Text name = {};
    const char *clause = "";
    const char *family = ""; ///< common to related parameters: "A" of A, A↑ and A↓
    ShortName shortName = {};
    Weight weight = Weight::main;
    Printed printed = Printed::always;
    Of of = Of::axis;
    OfCircle circle = OfCircle::nothing;
    Bound bound = Bound::magnitude;
    const char *also = ""; ///< shared name in limits and requests: "F" of Fmax and Fmin
    Quantity quantity = Quantity::deviation;

    /// True if `word`, of limits or requests, refers to this parameter.
    [[nodiscard]] bool isMeantBy(std::string_view word) const {
        return word == id || (*also && word == also);
    }
};

/// The target (counted from 1) that determines a parameter, and the approach if one rules.
struct Ruling {
    int target = 1;
    std::optional<Direction> approach;

    bool operator==(const Ruling &) const = default;
};

enum class Verdict { conforms, notProven, doesNotConform };

/// A parameter of a test. Values, uncertainty and guard band in mm (rotary: degrees), not rounded. `value` is
/// null if a statistic it needs is missing; a finding says why.
struct Parameter {
    Term term;
    std::string index;                 ///< axes of a circular result ("XY"); empty for positioning
    bool dependsOnTemperature = false; ///< wrong away from 20 °C unless corrected
    bool calibrationOpen = false;      ///< whether its reference length is calibrated is not stated
    bool required = true;              ///< one of the results the parties asked for (circular tests)
    std::optional<double> value;
    double size = 0; ///< of the numbers it is a difference of: a circle's radius, mm; 0: its own
    std::array<std::optional<Ruling>, 2> ruling; ///< the larger end first; first target on ties
    std::optional<double> expandedUncertainty;   ///< U of the deciding method; simulated: 95.45 %, else k = 2
    UncertaintyMethod decidedBy = UncertaintyMethod::none; ///< source of that U
    std::optional<double> budgetUncertainty;               ///< U, k = 2, of the budget
    std::optional<double> actualUncertainty;     ///< the same with S_eff instead of S; null: has no S
    std::optional<double> effectiveSystematic;   ///< S_eff: part of S that affects the actual targets
    std::optional<SimulatedParameter> simulated; ///< result of the simulation, if one was run
    std::optional<Limit> limit;     ///< of several the one with the worse verdict, or the tighter
    std::string limitOf;            ///< its key: that of the parameter, or "F" for Fmax and Fmin
    Bound bound = Bound::magnitude; ///< sense of that limit
    std::optional<double> guardBand;
    std::optional<Verdict> verdict; ///< null: no limit, or one agreed for another edition

    /// Returns the uncertainty multiplied by guardFactor: U, for a simulation U + 2 s_U.
    [[nodiscard]] std::optional<double> guardedUncertainty() const;
};

/// True if a limit with a value is agreed for the parameter, by its own or a shared name; for anything.
[[nodiscard]] bool hasLimit(const Limits &limits, const Term &term);
[[nodiscard]] bool hasLimits(const Limits &limits);

/// Returns "A", "G(b)_XY": the key of results.
[[nodiscard]] std::string parameterId(const Parameter &parameter);

/// Returns the symbol without typography: "A↑", "Psmax", "G(b)XY".
[[nodiscard]] std::string plainSymbol(const Parameter &parameter);

} // namespace palmer
