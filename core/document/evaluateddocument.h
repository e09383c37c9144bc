// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/simulation/simulate.h"

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

/// A simulation and what it was computed from: that says whether it is outdated.
struct TestSimulation {
    std::shared_ptr<const Simulation> simulation; ///< null: none
    TestPointer of;
    std::optional<double> environmentalVariation; ///< of the drift test it took, mm or degrees
};

/// A document together with its evaluation: a result can never be shown beside data it was not computed from.
/// Immutable once made; copies are cheap.
struct EvaluatedDocument {
    std::shared_ptr<const Document> document;
    std::vector<TestEvaluationPointer> tests; ///< one a test of the document
    std::vector<TestSimulation> simulations;  ///< likewise; those of `previous` are kept
    std::vector<std::size_t> pending;         ///< tests that wait for their results, see awaitingResults

    /// The worst verdict of the tests; null where none has a limit.
    [[nodiscard]] std::optional<Verdict> verdict() const;
    [[nodiscard]] bool isPending(std::size_t test) const;
};

/// The same of a document that is evaluated: null, too, without one.
template <class Measurement>
[[nodiscard]] const Measurement *measured(const EvaluatedDocument &evaluated, std::size_t test) {
    return test < evaluated.tests.size() ? measured<Measurement>(*evaluated.document, test) : nullptr;
}

/// E_VE of the drift test with that id, mm or degrees; null without one of that motion: a linear axis learns
/// nothing from angles, a rotary one nothing from lengths.
[[nodiscard]] std::optional<double> driftRange(const Document &document, const std::string &id,
                                               Motion motion);

/// Evaluates all tests; those that are the same as in `previous` keep their evaluation.
/// `edition`: the word of another edition for all tests of its kind (a view, no verdicts); empty: each its
/// own.
[[nodiscard]] EvaluatedDocument evaluate(std::shared_ptr<const Document> document,
                                         const EvaluatedDocument *previous = nullptr,
                                         std::string_view edition = {});

/// The same, each test under the edition of its own word in `editions`; empty or none: the test's. A
/// `previous` without document counts as none.
[[nodiscard]] EvaluatedDocument evaluateUnder(std::shared_ptr<const Document> document,
                                              std::span<const std::string> editions,
                                              const EvaluatedDocument *previous = nullptr);

/// The document at once, for whoever edits it while it is evaluated: tests that `previous` has evaluated keep
/// their evaluation; the others are pending. A pending test has no statistics, yet as many targets as the
/// document; findings and verdict are those it had before, parameters and their uncertainty, too, if that was
/// under the same edition: pages that ask for what belongs to them keep their fields.
[[nodiscard]] EvaluatedDocument awaitingResults(std::shared_ptr<const Document> document,
                                                std::span<const std::string> editions,
                                                const EvaluatedDocument &previous);

/// Runs the Monte Carlo simulation of a test under the edition it is evaluated under. Null where its inputs
/// are incomplete, for drift tests, and when stopped. May run on any thread: nothing is shared but values.
[[nodiscard]] std::optional<TestSimulation>
simulateTest(const EvaluatedDocument &evaluated, std::size_t test, const SimulationOptions &options,
             const std::stop_token &stop = {},
             const std::function<void(const SimulationProgress &)> &progress = {});

/// The same evaluation with a simulation of one of its tests, which decides where it is to decide. If the
/// test was edited since the simulation began it is marked as outdated.
[[nodiscard]] EvaluatedDocument withSimulation(const EvaluatedDocument &evaluated, std::size_t test,
                                               TestSimulation simulation);

/// Which tests get a simulation: those whose method is Monte Carlo; or, for a report that prints the budget,
/// those beside whose complete budget it is shown, too, unless they are too large for that.
enum class SimulateWhich { monteCarloOnly, forReport };

/// Readings that are perturbed without being asked for, of the fewest trials that decide: some seconds.
inline constexpr double mostDrawsUnasked = 1e8;

/// A simulation of the test would take more than that.
[[nodiscard]] bool isTooLargeUnasked(const Test &test);

/// Whether a simulation is to be run for that: it is wanted, and there is none, or an outdated one.
[[nodiscard]] bool isSimulationDue(const EvaluatedDocument &evaluated, std::size_t test, SimulateWhich which);

/// Runs the simulations that are missing or outdated, with the trials and the seed of each test. Null when
/// stopped. `progress`: the test, counted from 0.
[[nodiscard]] std::optional<EvaluatedDocument>
withSimulations(EvaluatedDocument evaluated, SimulateWhich which, int threads = 0,
                const std::stop_token &stop = {},
                const std::function<void(std::size_t test, const SimulationProgress &)> &progress = {});

/// The worst accordance of the tests that the verdict rests on; null where none was evaluated.
[[nodiscard]] std::optional<Accordance> worstAccordance(const EvaluatedDocument &evaluated);

} // namespace palmer
