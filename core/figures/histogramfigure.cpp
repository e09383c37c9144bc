// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "figures/ticks.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "language/rounding.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double mostBarTicks = 7;
constexpr double besideBars = 0.04; ///< on either side, fraction of the displayed range

/// From the start of the first non-empty interval to the end of the last.
Interval counted(const HistogramFigure &figure) {
    const auto holds = [](long long count) { return count > 0; };
    const auto first = std::ranges::find_if(figure.counts, holds);
    const auto last = std::find_if(figure.counts.rbegin(), figure.counts.rend(), holds);
    if (first == figure.counts.end() || figure.width == 0)
        return {figure.from, figure.from};
    return {figure.from + figure.width * static_cast<double>(first - figure.counts.begin()),
            figure.from + figure.width * static_cast<double>(figure.counts.rend() - last)};
}

} // namespace

std::optional<HistogramFigure> histogramFigure(const Test &test, const TestEvaluation &evaluation,
                                               const Parameter &parameter, const Language &language,
                                               std::optional<double> resolution) {
    if (!parameter.simulated)
        return std::nullopt;
    const SimulatedParameter &simulated = *parameter.simulated;
    const Quantity quantity = deviationQuantity(test);
    const double scale = unitScale(quantity, language.units());
    HistogramFigure figure;
    figure.from = simulated.histogram.from * scale;
    figure.width = simulated.histogram.width * scale;
    figure.counts = simulated.histogram.counts;
    figure.coverage = {simulated.low * scale, simulated.high * scale};
    figure.evaluated = simulated.value * scale;
    figure.mean = simulated.mean * scale;

    const std::string symbol = plainSymbol(parameter);
    const long long trials =
        evaluation.uncertainty.simulation ? evaluation.uncertainty.simulation->trials : 0;
    figure.title = language.sentence({REPORT_TEXT_COUNTED("report", "Distribution of %1 in %n trial(s)"),
                                      {symbol},
                                      static_cast<int>(trials)});
    const int decimals = decimalsWithUncertainty(simulated.expanded(), quantity, resolution);
    const auto number = [&](double value) { return Number{value, quantity, decimals}; };
    figure.evaluatedText =
        language.sentence(REPORT_TEXT("report", "evaluated %1"), {number(simulated.value)});
    figure.meanText =
        language.sentence(REPORT_TEXT("report", "mean of the trials %1"), {number(simulated.mean)});
    figure.coverageText = language.sentence(REPORT_TEXT("report", "95.45 %: %1 to %2"),
                                            {number(simulated.low), number(simulated.high)});
    figure.x.symbol = QString::fromStdString(symbol);
    figure.x.unit = language.unit(quantity);
    const Interval values = counted(figure);
    const double low = std::min({values.from, figure.evaluated, figure.coverage.from});
    const double high = std::max({values.to, figure.evaluated, figure.coverage.to});
    const double margin = high > low ? (high - low) * besideBars : 1;
    setRange(figure.x, low - margin, high + margin, mostBarTicks, TickSteps::values, language);
    return figure;
}

} // namespace palmer
