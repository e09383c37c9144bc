// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/circularcase.h"

#include <algorithm>

namespace palmer {

const EvaluatedPath *CircularCase::path(Sense sense) const {
    const auto found = std::ranges::find(results.paths, sense, &EvaluatedPath::sense);
    return found == results.paths.end() ? nullptr : &*found;
}

bool CircularCase::bothSenses() const {
    return results.paths.size() == 2;
}

bool CircularCase::twoFullCircles() const {
    return bothSenses() && std::ranges::all_of(results.paths, &EvaluatedPath::fullCircle);
}

bool CircularCase::isRequired(std::string_view quantity) const {
    const auto &asked = measurement.requiredResults;
    if (asked.empty())
        return true;
    // Fmax or Fmin alone is a part of F
    return std::ranges::any_of(asked, [&](const std::string &id) {
        return id == quantity || (quantity == "F" && (id == "Fmax" || id == "Fmin"));
    });
}

bool CircularCase::needsLength() const {
    return !feedback() && (isRequired("F") || isRequired("D"));
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
