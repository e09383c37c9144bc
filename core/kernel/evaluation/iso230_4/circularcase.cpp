// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/circularcase.h"

#include "kernel/evaluation/iso230_4/circles.h"

#include <algorithm>

namespace palmer {

const EvaluatedPath *CircularCase::path(Sense sense) const {
    const auto found = std::ranges::find(results.paths, sense, &EvaluatedPath::sense);
    return found == results.paths.end() ? nullptr : &*found;
}

bool CircularCase::bothSenses() const {
    return iso230_4::bothMeasured(results.paths);
}

bool CircularCase::twoFullCircles() const {
    return bothSenses() && std::ranges::all_of(results.paths, &EvaluatedPath::fullCircle);
}

bool CircularCase::isRequired(const Term &term) const {
    const auto &asked = measurement.requiredResults;
    const auto isAsked = [&](const Term &one) {
        return std::ranges::any_of(asked, [&](const std::string &word) { return one.isMeantBy(word); });
    };
    // Fmax or Fmin alone is part of F.
    return asked.empty() || isAsked(term) ||
           (*term.also && std::ranges::any_of(edition.circles->rows, [&](const CircularRow &row) {
               return std::string_view(row.term.also) == term.also && isAsked(row.term);
           }));
}

bool CircularCase::resultsStated() const {
    return !measurement.requiredResults.empty() || hasLimits(test.limits);
}

bool CircularCase::asksForRow(const CircularRow &row) const {
    if (!measurement.requiredResults.empty() || !resultsStated())
        return isRequired(row.term);
    return hasLimit(test.limits, row.term);
}

bool CircularCase::asksFor(OfCircle what) const {
    return std::ranges::any_of(edition.circles->rows, [&](const CircularRow &row) {
        return row.term.circle == what && asksForRow(row);
    });
}

bool CircularCase::asksForPair() const {
    return std::ranges::any_of(edition.circles->rows, [&](const CircularRow &row) {
        return row.term.of == Of::pair && asksForRow(row);
    });
}

bool CircularCase::needsLength() const {
    return !feedback() && (asksFor(OfCircle::radialDeviation) || asksFor(OfCircle::meanRadialDeviation));
}

bool CircularCase::notCalibrated() const {
    return measurement.referenceLength.calibrated == false;
}

const CircleResult *CircularResults::circle(CircleOf of, ReferenceCircle kind) const {
    const auto found =
        std::ranges::find_if(circles, [&](const CircleResult &c) { return c.of == of && c.kind == kind; });
    return found == circles.end() ? nullptr : &*found;
}

} // namespace palmer
