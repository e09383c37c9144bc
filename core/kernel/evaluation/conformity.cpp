#include "kernel/evaluation/conformity.h"

#include <algorithm>
#include <cmath>

namespace palmer {

Verdict decide(std::optional<double> value, double limit, std::optional<double> expandedUncertainty,
               const DecisionRule &rule) {
    if (!value)
        return Verdict::notProven;
    const double size = std::abs(*value);
    if (rule.rule == Rule::simpleAcceptance)
        return size <= limit ? Verdict::conforms : Verdict::doesNotConform;
    const auto guard = guardBand(expandedUncertainty, rule);
    if (!guard)
        return Verdict::notProven;
    if (size <= limit - *guard)
        return Verdict::conforms;
    return size > limit + *guard ? Verdict::doesNotConform : Verdict::notProven;
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
