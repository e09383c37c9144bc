// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <type_traits>

namespace palmer {

static_assert(std::variant_size_v<decltype(TestEvaluation::results)> == allKinds.size());

/// Returns the results that belong to the measurement of a kind; `evaluation` is that of its test. Results
/// and measurements are alternatives in the same order.
template <class Measurement, std::size_t place = 0>
[[nodiscard]] const auto &resultsOf(const Measurement &measurement, const TestEvaluation &evaluation) {
    using Other = std::variant_alternative_t<place, decltype(Test::measurement)>;
    if constexpr (std::is_same_v<Measurement, Other>)
        return std::get<place>(evaluation.results);
    else
        return resultsOf<Measurement, place + 1>(measurement, evaluation);
}

/// Returns `use` applied to the measurement of a test and its results; it has an overload for each kind.
template <class Use>
auto withResults(const Test &test, const TestEvaluation &evaluation, Use use) {
    return std::visit(
        [&](const auto &measurement) { return use(measurement, resultsOf(measurement, evaluation)); },
        test.measurement);
}

} // namespace palmer
