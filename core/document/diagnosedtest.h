// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/diagnosis/diagnosis.h"

#include <optional>
#include <vector>

namespace palmer {

/// A circular test with what its circle says about the machine. Shares the points with the evaluation.
struct DiagnosedTest {
    TestPointer test; ///< holds a CircularMeasurement
    TestEvaluationPointer evaluation;
    DiagnosedCircle circle;
    Diagnosis diagnosis; ///< valid

    [[nodiscard]] const CircularMeasurement &measurement() const;
    [[nodiscard]] const CircularResults &results() const;
};

/// The evaluated arcs of a circular test; null for another test, and where no arc was evaluated.
[[nodiscard]] std::optional<DiagnosedCircle> circleOf(const Test &test, const TestEvaluation &evaluation);

/// Null for a test that is no circle, or too few points of one. Takes up to half a second for 2 · 10⁶ points;
/// may run on any thread.
[[nodiscard]] std::optional<DiagnosedTest> diagnosedTest(const EvaluatedDocument &evaluated,
                                                         std::size_t test);

/// Circular tests of one plane and radius at different feeds, in the order of the document: they can be
/// diagnosed together. Places of the tests.
[[nodiscard]] std::vector<std::vector<std::size_t>> testsAtSeveralFeeds(const EvaluatedDocument &evaluated);

/// The tests at several feeds that this test belongs to; empty if it belongs to none.
[[nodiscard]] std::vector<std::size_t> testsAtFeedsWith(const EvaluatedDocument &evaluated, std::size_t test);

} // namespace palmer
