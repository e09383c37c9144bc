// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

namespace palmer {

// Returns the results that belong to the measurement of a kind; `evaluation` is that of its test.

[[nodiscard]] inline const PositioningResults &resultsOf(const PositioningMeasurement & /*measurement*/,
                                                         const TestEvaluation &evaluation) {
    return std::get<PositioningResults>(evaluation.results);
}
[[nodiscard]] inline const CircularResults &resultsOf(const CircularMeasurement & /*measurement*/,
                                                      const TestEvaluation &evaluation) {
    return std::get<CircularResults>(evaluation.results);
}
[[nodiscard]] inline const DriftResults &resultsOf(const DriftMeasurement & /*measurement*/,
                                                   const TestEvaluation &evaluation) {
    return std::get<DriftResults>(evaluation.results);
}

/// Returns `use` applied to the measurement of a test and its results; it has an overload for each kind.
template <class Use>
auto withResults(const Test &test, const TestEvaluation &evaluation, Use use) {
    return std::visit(
        [&](const auto &measurement) { return use(measurement, resultsOf(measurement, evaluation)); },
        test.measurement);
}

} // namespace palmer
