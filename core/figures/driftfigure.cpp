// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double rangeMargin = 0.06; ///< above and below the values, fraction of their range
constexpr double longTest = 600;
constexpr double veryLongTest = 36000;
constexpr double minute = 60;
constexpr double hour = 3600;

struct TimeUnit {
    double seconds = 0;
    const char *symbol = nullptr;
};

TimeUnit timeUnit(double duration) {
    if (duration >= veryLongTest)
        return {hour, "h"};
    return duration >= longTest ? TimeUnit{minute, "min"} : TimeUnit{1, "s"};
}

/// The range with a margin; for equal values one unit on either side.
Interval widened(double low, double high) {
    const double space = high > low ? (high - low) * rangeMargin : 1;
    return {low - space, high + space};
}

/// A channel that is not the axis is called by its own name.
QString titleOf(const std::string &channel, const std::string &axis, const Language &language) {
    if (!channel.empty() && channel != axis)
        return language.sentence(REPORT_TEXT("report", "Drift of “%1”"), {channel});
    return axis.empty() ? language.text(REPORT_TEXT("report", "Drift"))
                        : language.sentence(REPORT_TEXT("report", "Drift of the %1 axis"), {axis});
}

} // namespace

CurveFigure driftFigure(const Test &test, const TestEvaluation &evaluation, const Language &language,
                        const std::optional<TakenVariation> &taken) {
    const auto &measurement = std::get<DriftMeasurement>(test.measurement);
    const DriftResults &results = resultsOf(measurement, evaluation);
    const DriftChannel channel = taken ? taken->channel : mainChannel(measurement);
    const Quantity quantity = taken ? deviationQuantity(channel) : deviationQuantity(measurement);
    const double scale = unitScale(quantity, language.units());
    const std::size_t count = std::min(measurement.times.size(), channel.values.size());
    const double last =
        count > 0 ? *std::max_element(measurement.times.begin(),
                                      measurement.times.begin() + static_cast<std::ptrdiff_t>(count))
                  : 0;
    const TimeUnit unit = timeUnit(last);
    CurveFigure figure;
    figure.title = titleOf(channel.name, measurement.axis.name, language);
    Curve curve{CurveRole::drift, {}};
    curve.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (channel.values[i])
            curve.points.push_back(
                {measurement.times[i] / unit.seconds, *channel.values[i] * scale, static_cast<int>(i) + 1});
    }
    figure.x.quantity = language.text(REPORT_TEXT("report", "Time"));
    figure.x.symbol = QStringLiteral("t");
    figure.x.unit = QString::fromLatin1(unit.symbol);
    figure.y.quantity = language.text(REPORT_TEXT("report", "Deviation at rest"));
    figure.y.symbol = QStringLiteral("x");
    figure.y.unit = language.unit(quantity);
    if (curve.points.empty())
        return withRanges(std::move(figure), {0, 1}, {-1, 1}, language);
    const auto [lowest, highest] = std::ranges::minmax_element(curve.points, {}, &FigurePoint::y);
    const auto [begin, end] = std::ranges::minmax_element(curve.points, {}, &FigurePoint::x);
    const Interval x = end->x > begin->x ? Interval{begin->x, end->x} : Interval{begin->x - 1, end->x + 1};
    const Interval y = widened(lowest->y, highest->y);
    const auto inWindow = [&](const FigurePoint &point) {
        return !taken || (point.x >= taken->variation.from / unit.seconds &&
                          point.x <= taken->variation.to / unit.seconds);
    };
    std::vector<FigurePoint> window;
    std::ranges::copy_if(curve.points, std::back_inserter(window), inWindow);
    const bool isPart = window.size() < curve.points.size();
    const auto [least, most] = std::ranges::minmax_element(window, {}, &FigurePoint::y);
    if (most->y > least->y) {
        Dimension range;
        range.label = QStringLiteral("E");
        range.subscript = QStringLiteral("VE");
        range.lower = least->y;
        range.upper = most->y;
        range.lowerPosition = least->x;
        range.upperPosition = most->x;
        figure.dimensions.push_back(std::move(range));
    }
    constexpr int decimals = 1;
    const Text words = isPart ? REPORT_TEXT("report", "deviation at rest, largest range within the duration "
                                                      "of the test %1")
                              : REPORT_TEXT("report", "deviation at rest, range %1");
    figure.legend.push_back(
        {LegendSample::drift,
         language.sentence(
             words, {Number{taken ? taken->variation.value : results.range.value_or(0), quantity, decimals}}),
         false});
    figure.curves.push_back(std::move(curve));
    return withRanges(std::move(figure), x, y, language);
}

} // namespace palmer
