// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"

#include "kernel/measurement/testfacts.h"

namespace palmer {

namespace {

/// A kind without an evaluation does not compile. `edition` is null for kinds that no edition judges, and for
/// a word that no reader accepts.
struct EvaluationOfKind {
    const Test &test;
    const Surroundings &surroundings;
    const Edition *edition;

    TestEvaluation operator()(const PositioningMeasurement & /*measurement*/) const {
        return edition ? evaluatePositioning(test, surroundings, *edition) : TestEvaluation{};
    }

    TestEvaluation operator()(const CircularMeasurement & /*measurement*/) const {
        return edition ? evaluateCircular(test, surroundings, *edition) : TestEvaluation{};
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
    TestEvaluation evaluation =
        std::visit(EvaluationOfKind{test, surroundings, editionFor(test, asked)}, test.measurement);
    evaluation.parameters.shrink_to_fit(); // those of a thousand tests are kept
    evaluation.findings.shrink_to_fit();
    return evaluation;
}

} // namespace palmer
