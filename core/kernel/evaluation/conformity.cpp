// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/conformity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

Verdict decide(std::optional<double> value, double limit, std::optional<double> expandedUncertainty,
               const DecisionRule &rule) {
    if (!value)
        return Verdict::notProven;
    return decideUpper(std::abs(*value), limit, expandedUncertainty, rule);
}

Verdict decideUpper(double value, double limit, std::optional<double> expandedUncertainty,
                    const DecisionRule &rule, double rounding) {
    // 18 equals 18, whatever the rounding errors of the readings.
    rounding *= std::max(std::abs(value), std::abs(limit));
    if (rule.rule == Rule::simpleAcceptance)
        return value <= limit + rounding ? Verdict::conforms : Verdict::doesNotConform;
    const auto guard = guardBand(expandedUncertainty, rule);
    if (!guard)
        return Verdict::notProven;
    if (value <= limit - *guard + rounding)
        return Verdict::conforms;
    return value > limit + *guard + rounding ? Verdict::doesNotConform : Verdict::notProven;
}

double roundingBeside(const Parameter &parameter, double limit) {
    constexpr double ofSize =
        64 * std::numeric_limits<double>::epsilon(); // of the steps from readings to a circle
    const double beside = std::max(std::abs(parameter.value.value_or(0)), std::abs(limit));
    return beside > 0 ? roundingOfSums + ofSize * parameter.size / beside : roundingOfSums;
}

double judgedValue(double value, Bound bound) {
    switch (bound) {
    case Bound::magnitude:
        return std::abs(value);
    case Bound::upper:
        return value;
    case Bound::lower:
        return -value;
    }
    return value;
}

double judgedLimit(double limit, Bound bound) {
    return bound == Bound::lower ? -limit : limit;
}

std::optional<double> guardBand(std::optional<double> expandedUncertainty, const DecisionRule &rule) {
    if (rule.rule == Rule::simpleAcceptance || !expandedUncertainty)
        return std::nullopt;
    return rule.guardFactor * *expandedUncertainty;
}

std::optional<Verdict> worst(std::optional<Verdict> a, std::optional<Verdict> b) {
    if (!a || !b)
        return a ? a : b;
    return std::max(*a, *b);
}

} // namespace palmer
