// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/simulate.h"

#include "kernel/evaluation/evaluatetest.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/simulation/circulartrials.h"
#include "kernel/simulation/positioningtrials.h"
#include "kernel/simulation/runtrials.h"

namespace palmer {

namespace {

/// Does not compile for a kind for which simulation is not decided.
struct SimulationOfKind {
    const Test &test;
    const Surroundings &surroundings;
    const TestEvaluation &evaluation;
    const SimulationOptions &options;
    const std::stop_token &stop;
    const std::function<void(const SimulationProgress &)> &progress;

    std::optional<Simulation> operator()(const PositioningMeasurement &measurement) const {
        const PositioningBudget budget = positioningBudget(measurement, surroundings.environmentalVariation);
        if (!budget.isComplete())
            return std::nullopt;
        return run(PositioningTrials(measurement, evaluation, budget, options.seed));
    }

    std::optional<Simulation> operator()(const CircularMeasurement &measurement) const {
        return run(CircularTrials(test, measurement, surroundings, evaluation, options.seed));
    }

    /// A kind without inputs of the uncertainty is not simulated.
    std::optional<Simulation> operator()(const auto &measurement) const
        requires(!requires { measurement.uncertainty; }) {
        return std::nullopt;
    }

private:
    [[nodiscard]] std::optional<Simulation> run(const auto &trials) const {
        if (trials.parameters().empty())
            return std::nullopt;
        return TrialRun(trials, options, stop, progress).run();
    }
};

} // namespace

SimulationOptions simulationOptions(const Test &test) {
    SimulationOptions options;
    withUncertainty(test, [&](const auto &inputs) {
        options.trials = inputs.trials;
        options.seed = inputs.seed;
    });
    return options;
}

std::optional<Simulation> simulate(const Test &test, const Surroundings &surroundings, const Edition &edition,
                                   const SimulationOptions &options, const std::stop_token &stop,
                                   const std::function<void(const SimulationProgress &)> &progress) {
    const TestEvaluation evaluation = evaluateTest(test, surroundings, &edition);
    if (evaluation.edition != &edition)
        return std::nullopt;
    std::optional<Simulation> result = std::visit(
        SimulationOfKind{test, surroundings, evaluation, options, stop, progress}, test.measurement);
    if (result)
        result->edition = edition.word;
    return result;
}

} // namespace palmer
