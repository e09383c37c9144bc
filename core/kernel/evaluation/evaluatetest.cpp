// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"

#include "kernel/measurement/testfacts.h"

namespace palmer {

namespace {

TestEvaluation evaluateDrift(const DriftMeasurement &measurement) {
    TestEvaluation evaluation;
    DriftResults results;
    results.range = rangeOf(measurement);
    evaluation.results = results;
    return evaluation;
}

} // namespace

const Edition *editionFor(const Test &test, const Edition *asked) {
    if (!isJudged(test))
        return nullptr;
    const bool isOfKind = asked && asked->kind == kindOf(test);
    return isOfKind ? asked : findEdition(test.edition);
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
