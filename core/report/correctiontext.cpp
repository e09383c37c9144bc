// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/correctiontext.h"

#include "kernel/evaluation/correctionto20.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

struct Length {
    const Conditions *conditions = nullptr;
    double value = 0; ///< mm
};

Length lengthOf(const Test &test) {
    if (const auto *circle = std::get_if<CircularMeasurement>(&test.measurement))
        return {&circle->conditions.common, circle->nominalRadius};
    const auto *axis = std::get_if<PositioningMeasurement>(&test.measurement);
    if (!axis || axis->axis.motion != Motion::linear || axis->targets.empty())
        return {};
    const double origin = axis->conditions.referencePosition.value_or(axis->targets.front());
    double farthest = 0;
    for (const double target : axis->targets)
        farthest = std::max(farthest, std::abs(target - origin));
    return {&axis->conditions.common, farthest};
}

} // namespace

QString correctionSizeText(const Test &test, const Language &language) {
    const Length length = lengthOf(test);
    if (!length.conditions || !(length.value > 0))
        return {};
    const auto expansion = differentialExpansion(*length.conditions);
    if (!expansion)
        return {};
    const auto text = [&](double value, Quantity quantity, int decimals) {
        return language.quantity(value, quantity, decimals).toStdString();
    };
    return language.sentence(
        {REPORT_TEXT_FOR("report", "%1 over %2", "the differential expansion over a length"),
         {text(std::abs(*expansion) * length.value, Quantity::deviation, 1),
          text(length.value, Quantity::position, -1)}});
}

} // namespace palmer
