// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"

#include "kernel/measurement/testfacts.h"

namespace palmer {

namespace {

/// A kind without an evaluation does not compile. `edition` is null for kinds that no edition judges.
struct EvaluationOfKind {
    const Test &test;
    const Surroundings &surroundings;
    const Edition *edition;

    TestEvaluation operator()(const PositioningMeasurement & /*measurement*/) const {
        return evaluatePositioning(test, surroundings, *edition);
    }

    TestEvaluation operator()(const CircularMeasurement & /*measurement*/) const {
        return evaluateCircular(test, surroundings, *edition);
    }

    TestEvaluation operator()(const DriftMeasurement &measurement) const {
        TestEvaluation evaluation;
        DriftResults results;
        results.range = rangeOf(measurement);
        evaluation.results = results;
        return evaluation;
    }
};

} // namespace

const Edition *editionFor(const Test &test, const Edition *asked) {
    if (!isJudged(test))
        return nullptr;
    const bool isOfKind = asked && asked->kind == kindOf(test);
    return isOfKind ? asked : findEdition(test.edition);
}

TestEvaluation evaluateTest(const Test &test, const Surroundings &surroundings, const Edition *asked) {
    const Edition *edition = editionFor(test, asked);
    if (!edition && isJudged(test))
        return {}; // a word no reader lets in
    return std::visit(EvaluationOfKind{test, surroundings, edition}, test.measurement);
}

} // namespace palmer
