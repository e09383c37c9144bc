// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"

#include <algorithm>

namespace palmer {

namespace {

TestEvaluation evaluateDrift(const DriftMeasurement &measurement) {
    TestEvaluation evaluation;
    DriftResults results;
    if (!measurement.deviations.empty()) {
        const auto [low, high] = std::ranges::minmax(measurement.deviations);
        results.range = high - low;
    }
    evaluation.results = results;
    return evaluation;
}

} // namespace

const Edition *editionFor(const Test &test, const Edition *asked) {
    if (std::holds_alternative<DriftMeasurement>(test.measurement))
        return nullptr;
    const Kind kind =
        std::holds_alternative<PositioningMeasurement>(test.measurement) ? Kind::positioning : Kind::circular;
    return asked && asked->kind == kind ? asked : findEdition(test.edition);
}

TestEvaluation evaluateTest(const Test &test, const Surroundings &surroundings, const Edition *asked) {
    if (const auto *drift = std::get_if<DriftMeasurement>(&test.measurement))
        return evaluateDrift(*drift);
    const Edition *edition = editionFor(test, asked);
    if (!edition)
        return {}; // a word no reader lets in
    return edition->kind == Kind::positioning ? evaluatePositioning(test, surroundings, *edition)
                                              : evaluateCircular(test, surroundings, *edition);
}

} // namespace palmer
