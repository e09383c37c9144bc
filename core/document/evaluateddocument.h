// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/evaluation/evaluatesheet.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/simulation/simulate.h"
#include "kernel/thermal/variation.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

using TestEvaluationPointer = std::shared_ptr<const TestEvaluation>;

/// A simulation with its inputs, which tell whether it is outdated.
struct TestSimulation {
    std::shared_ptr<const Simulation> simulation; ///< null: none
    TestPointer of;
    std::optional<double> environmentalVariation; ///< of the drift test used, mm or degrees
};

/// A document together with its evaluation: a result can never be shown with data it was not computed from.
/// Immutable; copies are cheap.
struct EvaluatedDocument {
    std::shared_ptr<const Document> document;
    std::vector<TestEvaluationPointer> tests; ///< one per test of the document
    std::vector<TestSimulation> simulations;  ///< likewise; those of `previous` are kept
    std::vector<std::size_t> pending;         ///< indices of tests waiting for results, see awaitingResults

    /// Returns the worst verdict of tests and acceptance sheet; null if none has a limit.
    [[nodiscard]] std::optional<Verdict> verdict() const;
    /// The rows of the acceptance sheet, judged by the rule of the report.
    [[nodiscard]] std::vector<SheetResult> sheet() const;
    [[nodiscard]] bool isPending(std::size_t test) const;
};

/// The same for an evaluated document; also null without a document.
template <class Measurement>
[[nodiscard]] const Measurement *measured(const EvaluatedDocument &evaluated, std::size_t test) {
    return test < evaluated.tests.size() ? measured<Measurement>(*evaluated.document, test) : nullptr;
}

/// E_VE, mm or degrees, with the channel that gives it.
struct TakenVariation {
    DriftChannel channel;
    Variation variation;
};

/// Returns E_VE that the drift test with this id gives to a test: over the duration of the test if that is
/// stated, else over the whole record. Of several channels that of the axis counts, of a plane the largest of
/// its two. Null without a channel of the same kind: angles are of no use to a linear axis, nor lengths to a
/// rotary one.
[[nodiscard]] std::optional<TakenVariation> takenVariation(const Document &document, const std::string &id,
                                                           const Test &test);
/// The same without its channel.
[[nodiscard]] std::optional<Variation> driftVariation(const Document &document, const std::string &id,
                                                      const Test &test);

/// Evaluates all tests; those unchanged since `previous` keep their evaluation. `edition`: word of another
/// edition for all tests of its kind (a view, no verdicts); empty: each its own.
[[nodiscard]] EvaluatedDocument evaluate(std::shared_ptr<const Document> document,
                                         const EvaluatedDocument *previous = nullptr,
                                         std::string_view edition = {});

/// The same, each test under its edition in `editions`; empty or missing: the test's own. A `previous`
/// without document is ignored.
[[nodiscard]] EvaluatedDocument evaluateUnder(std::shared_ptr<const Document> document,
                                              std::span<const std::string> editions,
                                              const EvaluatedDocument *previous = nullptr);

/// Returns the document immediately, for editing while it is being evaluated: tests evaluated in `previous`
/// keep their evaluation; the others are pending. A pending test has no statistics, but as many targets as
/// the document; it keeps its previous findings and verdict, and under the same edition also parameters and
/// uncertainty, so that pages that depend on them keep their fields.
[[nodiscard]] EvaluatedDocument awaitingResults(std::shared_ptr<const Document> document,
                                                std::span<const std::string> editions,
                                                const EvaluatedDocument &previous);

/// Evaluates what is pending in the result of awaitingResults() with the same editions.
[[nodiscard]] EvaluatedDocument evaluatePending(EvaluatedDocument awaiting,
                                                std::span<const std::string> editions);

/// Runs the Monte Carlo simulation of a test under its evaluated edition. Null if its inputs are incomplete,
/// for drift tests, and if stopped. May run on any thread: nothing is shared but values.
[[nodiscard]] std::optional<TestSimulation>
simulateTest(const EvaluatedDocument &evaluated, std::size_t test, const SimulationOptions &options,
             const std::stop_token &stop = {},
             const std::function<void(const SimulationProgress &)> &progress = {});

/// Returns the same evaluation with a simulation of one of its tests, which decides if selected. It is marked
/// as outdated if the test was edited since the simulation began.
[[nodiscard]] EvaluatedDocument withSimulation(const EvaluatedDocument &evaluated, std::size_t test,
                                               TestSimulation simulation);

/// Which tests are simulated: those whose method is Monte Carlo; for a report that prints the budget, also
/// those whose complete budget is shown with a simulation, unless they are too large.
enum class SimulateWhich { monteCarloOnly, forReport };

/// Most readings perturbed in simulations not requested by the user (fewest trials): some seconds.
inline constexpr double mostDrawsUnasked = 1e8;

/// True if a simulation of the test would exceed that.
[[nodiscard]] bool isTooLargeUnasked(const Test &test);

/// True if a simulation is to be run: it is wanted, and missing or outdated.
[[nodiscard]] bool isSimulationDue(const EvaluatedDocument &evaluated, std::size_t test, SimulateWhich which);

/// Runs the simulations that are missing or outdated, with the trials and the seed of each test. Null if
/// stopped. `progress`: index of the test from 0.
[[nodiscard]] std::optional<EvaluatedDocument>
withSimulations(EvaluatedDocument evaluated, SimulateWhich which, int threads = 0,
                const std::stop_token &stop = {},
                const std::function<void(std::size_t test, const SimulationProgress &)> &progress = {});

/// Returns the worst accordance of the tests that count for the verdict; null if none was evaluated.
[[nodiscard]] std::optional<Accordance> worstAccordance(const EvaluatedDocument &evaluated);

} // namespace palmer
