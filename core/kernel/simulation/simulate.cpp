// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/simulate.h"

#include "kernel/evaluation/evaluatetest.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/simulation/circulartrials.h"
#include "kernel/simulation/positioningtrials.h"
#include "kernel/simulation/runtrials.h"

namespace palmer {

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
    std::optional<Simulation> result;
    if (const auto *m = std::get_if<PositioningMeasurement>(&test.measurement)) {
        const PositioningBudget budget = positioningBudget(*m, surroundings.environmentalVariation);
        if (!budget.isComplete())
            return std::nullopt;
        const PositioningTrials trials(*m, evaluation, budget, options.seed);
        if (!trials.parameters().empty())
            result = TrialRun(trials, options, stop, progress).run();
    } else if (const auto *c = std::get_if<CircularMeasurement>(&test.measurement)) {
        const CircularTrials trials(test, *c, surroundings, evaluation, options.seed);
        if (!trials.parameters().empty())
            result = TrialRun(trials, options, stop, progress).run();
    }
    if (result)
        result->edition = edition.word;
    return result;
}

} // namespace palmer
