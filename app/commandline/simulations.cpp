// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/simulations.h"

#include "commandline/optionvalues.h"
#include "commandline/progressline.h"
#include "commandline/streams.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <limits>

namespace palmer {

namespace {

/// Integer value of an option; null without it. Error messages name `most` only if it is exceeded.
std::optional<long long> wholeNumber(const Invocation &invocation, const char *option, long long least,
                                     long long most = std::numeric_limits<long long>::max()) {
    const auto text = invocation.value(option);
    if (!text)
        return std::nullopt;
    const std::optional<long long> number = wholeGiven(*text);
    if (!number || *number < least)
        throw UsageError({REPORT_TEXT("report", "--%1 takes a whole number from %2 on, not %3"),
                          {std::string(option), std::to_string(least), text->toStdString()}});
    if (*number > most)
        throw UsageError({REPORT_TEXT("report", "--%1 takes a whole number up to %2, not %3"),
                          {std::string(option), std::to_string(most), text->toStdString()}});
    return number;
}

std::optional<UncertaintyMethod> methodOf(const Invocation &invocation) {
    const auto word = invocation.value("uncertainty");
    if (!word)
        return std::nullopt;
    return *word == QLatin1StringView("budget") ? UncertaintyMethod::budget : UncertaintyMethod::monteCarlo;
}

} // namespace

SimulationChoices simulationChoices(const Invocation &invocation) {
    constexpr long long mostThreads = 256;
    const auto threads = wholeNumber(invocation, "threads", 1);
    return {methodOf(invocation), wholeNumber(invocation, "seed", std::numeric_limits<long long>::min()),
            wholeNumber(invocation, "trials", 1, mostTrialsStated),
            static_cast<int>(std::min(threads.value_or(0), mostThreads))};
}

void choose(Document &document, const SimulationChoices &choices) {
    const auto put = [&](auto &inputs) {
        inputs.method = choices.method.value_or(inputs.method);
        inputs.seed = choices.seed.value_or(inputs.seed);
        if (choices.trials)
            inputs.trials = choices.trials;
    };
    if (!choices.method && !choices.seed && !choices.trials)
        return;
    for (TestPointer &test : document.tests) {
        auto chosen = std::make_shared<Test>(*test);
        withUncertainty(*chosen, put);
        test = std::move(chosen);
    }
}

void requireEffect(const SimulationChoices &choices, const Document &document) {
    const auto simulates = [](const TestPointer &test) {
        const UncertaintyMethod *method = methodOf(*test);
        return method && *method == UncertaintyMethod::monteCarlo;
    };
    if ((choices.seed || choices.trials) && std::ranges::none_of(document.tests, simulates))
        refuseEffect(choices.seed ? "--seed" : "--trials", "--uncertainty monteCarlo");
    const auto hasMethod = [](const TestPointer &test) { return methodOf(*test) != nullptr; };
    if (choices.method && std::ranges::none_of(document.tests, hasMethod))
        throw UsageError({REPORT_TEXT("report", "--%1 has no effect here: no test of the file has a budget"),
                          {std::string("uncertainty")}});
}

EvaluatedDocument simulated(EvaluatedDocument evaluated, SimulateWhich which, int threads,
                            const Language &language) {
    ProgressLine line(language);
    auto result = withSimulations(std::move(evaluated), which, threads, {},
                                  [&](std::size_t, const SimulationProgress &done) { line.show(done); });
    return std::move(result).value(); // cannot be stopped
}

} // namespace palmer
