// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/diagnosis/diagnosis.h"

#include <optional>
#include <vector>

namespace palmer {

/// A circular test with its diagnosis of the machine. Shares the points with the evaluation.
struct DiagnosedTest {
    TestPointer test; ///< holds a CircularMeasurement
    TestEvaluationPointer evaluation;
    DiagnosedCircle circle;
    Diagnosis diagnosis; ///< valid

    [[nodiscard]] const CircularMeasurement &measurement() const;
    [[nodiscard]] const CircularResults &results() const;
};

/// Returns the evaluated arcs of a circular test; null for other tests, and if no arc was evaluated.
[[nodiscard]] std::optional<DiagnosedCircle> circleOf(const Test &test, const TestEvaluation &evaluation);

/// Null for tests that are not circular or have too few points. Takes up to half a second for 2 · 10⁶ points;
/// may run on any thread.
[[nodiscard]] std::optional<DiagnosedTest> diagnosedTest(const EvaluatedDocument &evaluated,
                                                         std::size_t test);

/// Returns groups of circular tests in one plane with one radius at different feeds, which can be diagnosed
/// together, as indices in the order of the document.
[[nodiscard]] std::vector<std::vector<std::size_t>> testsAtSeveralFeeds(const EvaluatedDocument &evaluated);

/// Returns the group of tests at several feeds that includes this test; empty if there is none.
[[nodiscard]] std::vector<std::size_t> testsAtFeedsWith(const EvaluatedDocument &evaluated, std::size_t test);

} // namespace palmer
