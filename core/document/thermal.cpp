// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/thermal.h"

#include "document/comparedtests.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace palmer {

std::vector<double> withGaps(const std::vector<std::optional<double>> &values) {
    std::vector<double> result;
    result.reserve(values.size());
    for (const std::optional<double> &value : values)
        result.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    return result;
}

void nameOnlyChannel(DriftMeasurement &drift) {
    if (drift.channels.size() == 1 && !drift.axis.name.empty())
        drift.channels.front().name = drift.axis.name;
}

std::optional<Variation> variationOf(const std::vector<double> &times,
                                     const std::vector<std::optional<double>> &values,
                                     std::optional<double> duration) {
    std::vector<double> gapped = withGaps(values);
    if (std::ranges::is_sorted(times))
        return variation(times, gapped, duration);
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return times[i]; });
    std::vector<double> sortedTimes;
    std::vector<double> sortedValues;
    for (const std::size_t i : order) {
        sortedTimes.push_back(times[i]);
        sortedValues.push_back(gapped[i]);
    }
    return variation(sortedTimes, sortedValues, duration);
}

std::vector<ThermalChannel> thermalChannels(const DriftMeasurement &drift) {
    std::vector<ThermalChannel> result;
    const bool ascends = std::ranges::is_sorted(drift.times);
    for (DriftChannel &channel : channelsOf(drift)) {
        ThermalChannel one;
        one.whole = variationOf(drift.times, channel.values, std::nullopt);
        const std::vector<double> deviations = withGaps(channel.values);
        for (std::size_t i = 0; ascends && i < drift.temperatures.size(); ++i) {
            const DriftTemperature &temperature = drift.temperatures[i];
            const std::vector<double> values = withGaps(temperature.values);
            one.responses.push_back(thermalResponse(
                {drift.times, deviations, values, temperature.resolution.value_or(0), drift.settled},
                static_cast<int>(drift.temperatures.size())));
            const ThermalResponse &now = one.responses.back();
            if (now.state == ResponseState::found &&
                (!one.best || now.squares < one.responses[*one.best].squares))
                one.best = i;
        }
        one.channel = std::move(channel);
        result.push_back(std::move(one));
    }
    return result;
}

bool takesVariation(const Test &test, const std::string &drift) {
    const std::string *named = driftTestOf(test);
    bool isEntered = false;
    withUncertainty(test, [&](const auto &inputs) { isEntered = inputs.environmentalVariation.has_value(); });
    return named && *named == drift && !isEntered;
}

std::vector<std::size_t> testsTaking(const Document &document, const std::string &drift) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        if (!drift.empty() && takesVariation(*document.tests[i], drift) &&
            driftVariation(document, drift, *document.tests[i]))
            result.push_back(i);
    }
    return result;
}

namespace {

constexpr std::array heldTo{1.0, 2.0, 5.0}; ///< °C
constexpr std::array<const char *, 2> explained{"A", "R"};

/// U of the parameters with another E_VE (mm or degrees), by the budget.
std::vector<std::optional<double>> expandedWith(const EvaluatedDocument &evaluated, std::size_t index,
                                                double variation, const std::vector<std::string> &ids) {
    Test test = *evaluated.document->tests[index];
    constexpr double micrometres = 1000;
    constexpr double arcSeconds = 3600;
    const double unit = motionOf(test) == Motion::linear ? micrometres : arcSeconds;
    withUncertainty(test, [&](auto &inputs) {
        inputs.environmentalVariation = variation * unit;
        if (!usesContributions(inputs.method) || inputs.method == UncertaintyMethod::monteCarlo)
            inputs.method = UncertaintyMethod::budget;
    });
    const TestEvaluation changed =
        evaluateTest(test, surroundingsOf(*evaluated.document, index), evaluated.tests[index]->edition);
    std::vector<std::optional<double>> result;
    for (const std::string &id : ids) {
        const auto found =
            std::ranges::find(changed.parameters, id, [](const Parameter &p) { return parameterId(p); });
        result.push_back(found == changed.parameters.end() ? std::nullopt : found->expandedUncertainty);
    }
    return result;
}

} // namespace

DriftCases driftCases(const EvaluatedDocument &evaluated, std::size_t index) {
    DriftCases result;
    const Document &document = *evaluated.document;
    const Test &test = *document.tests[index];
    const std::string *id = driftTestOf(test);
    const TestEvaluation &evaluation = *evaluated.tests[index];
    if (!id || !takesVariation(test, *id) || !usesContributions(evaluation.uncertainty.method) ||
        !evaluation.uncertainty.complete)
        return result;
    for (const char *wanted : explained) {
        if (std::ranges::any_of(evaluation.parameters,
                                [&](const Parameter &p) { return parameterId(p) == wanted; }))
            result.parameters.emplace_back(wanted);
    }
    const auto found = driftVariation(document, *id, test);
    if (result.parameters.empty() || !found)
        return result;
    const auto steady = expandedWith(evaluated, index, 0, result.parameters);
    const auto add = [&](DriftCase one) {
        one.expanded = expandedWith(evaluated, index, one.variation, result.parameters);
        const auto &all = one.expanded.front();
        if (all && steady.front() && *all > 0)
            one.share = 1 - *steady.front() * *steady.front() / (*all * *all);
        result.cases.push_back(std::move(one));
    };
    constexpr double minute = 60;
    const auto lasts = test.duration ? std::optional(*test.duration * minute) : std::nullopt;
    add({DriftCase::asTested, 0, lasts, found->value, found->isLowerBound, {}, {}});
    if (lasts) {
        Test shorter = test;
        shorter.duration = *test.duration / 2;
        if (const auto half = driftVariation(document, *id, shorter))
            add({DriftCase::halved, 0, *lasts / 2, half->value, half->isLowerBound, {}, {}});
    }
    add({DriftCase::none, 0, {}, 0, false, {}, {}});
    Test endless = test;
    endless.duration.reset();
    if (const auto whole = driftVariation(document, *id, endless); whole && lasts)
        add({DriftCase::wholeRecord, 0, whole->recorded, whole->value, whole->isLowerBound, {}, {}});
    if (found->isLowerBound) // no record of the rest says "at most" either
        return result;
    const auto drift = std::ranges::find(document.tests, *id, [](const TestPointer &t) { return t->id; });
    for (const ThermalChannel &channel : thermalChannels(std::get<DriftMeasurement>((*drift)->measurement))) {
        if (!channel.best || channel.channel.name != axesOf(test))
            continue;
        for (const double hold : heldTo)
            add({DriftCase::held,
                 hold,
                 lasts,
                 channel.responses[*channel.best].variationWhenHeld(hold, lasts.value_or(found->recorded)),
                 false,
                 {},
                 {}});
    }
    return result;
}

} // namespace palmer
