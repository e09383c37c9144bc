// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "figures/curvefield.h"
#include "figures/thinning.h"
#include "figures/ticks.h"
#include "kernel/evaluation/resultsof.h"
#include "language/decimals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr double secondsPerHour = 3600;
constexpr std::size_t partsOfLine = 500;
constexpr double mostTimeTicks = 8;
constexpr double mostTicksOfValues = 8;

/// Thins the points to as many as are needed to draw the line.
std::vector<QPointF> thinned(std::vector<QPointF> points) {
    if (points.size() <= 4 * partsOfLine)
        return points;
    std::vector<QPointF> kept;
    for (const std::size_t place : thinnedPlaces(
             points.size(), points.front().x(), points.back().x(), partsOfLine,
             [&](std::size_t i) { return points[i].x(); }, [&](std::size_t i) { return points[i].y(); }))
        kept.push_back(points[place]);
    return kept;
}

LineRole roleOf(SensorMeasures measures) {
    return measures == SensorMeasures::instrument ? LineRole::instrument
           : measures == SensorMeasures::air      ? LineRole::air
                                                  : LineRole::machine;
}

Text nameOf(SensorMeasures measures) {
    return inOrder(measures, {REPORT_TEXT("report", "machine"), REPORT_TEXT("report", "instrument"),
                              REPORT_TEXT("report", "air"), REPORT_TEXT("report", "not stated")});
}

} // namespace

LineFigure temperatureFigure(const std::vector<Sensor> &sensors, const Language &language) {
    LineFigure figure;
    figure.title = language.text(REPORT_TEXT("report", "Temperatures over time"));
    Bounds times;
    Bounds temperatures;
    const auto shown = [](const Sensor &sensor) { return sensor.series && sensor.series->times.size() > 1; };
    const bool several = std::ranges::count_if(sensors, shown) > 1;
    double first = std::numeric_limits<double>::infinity();
    for (const Sensor &sensor : sensors) {
        if (shown(sensor))
            first = std::min(first, sensor.series->times.front());
    }
    const double scale = unitScale(Quantity::temperature, language.units());
    for (const Sensor &sensor : sensors) {
        if (!shown(sensor))
            continue;
        FigureLine line;
        line.role = roleOf(sensor.measures);
        line.name = language.text(nameOf(sensor.measures));
        const QString position = QString::fromStdString(sensor.position);
        if (!position.isEmpty() && position.compare(line.name, Qt::CaseInsensitive) != 0)
            line.name += QStringLiteral(", ") + position;
        if (several)
            line.label = QString::number(figure.lines.size() + 1);
        for (std::size_t i = 0; i < sensor.series->times.size(); ++i) {
            line.points.emplace_back((sensor.series->times[i] - first) / secondsPerHour,
                                     sensor.series->temperatures[i] * scale);
            times.include(line.points.back().x());
            temperatures.include(line.points.back().y());
        }
        line.points = thinned(std::move(line.points));
        figure.lines.push_back(std::move(line));
    }
    figure.x.quantity = language.text(REPORT_TEXT("report", "Time"));
    figure.x.symbol = QStringLiteral("t");
    figure.x.unit = QStringLiteral("h");
    figure.y.quantity = language.text(REPORT_TEXT("report", "Temperature"));
    figure.y.symbol = QStringLiteral("θ");
    figure.y.unit = language.unit(Quantity::temperature);
    const Bounds x = times.widened(0, 1e-3);
    const Bounds y = temperatures.widened(valueMargin, 0.1); // keeps noise of a steady line small
    setRange(figure.x, x.lowest, x.highest, mostTimeTicks, TickSteps::lengths, language);
    setRange(figure.y, y.lowest, y.highest, mostTicksOfValues, TickSteps::values, language);
    return figure;
}

LineFigure compensationFigure(const Test &test, const TestEvaluation &before, const TestEvaluation &after,
                              const Language &language) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    const bool rotary = measurement.axis.motion == Motion::rotary;
    const double along = unitScale(positionQuantity(measurement.axis), language.units());
    const double across = unitScale(deviationQuantity(measurement.axis), language.units());
    LineFigure figure;
    figure.title =
        language.sentence(REPORT_TEXT("report", "Compensation of the %1 axis"), {measurement.axis.name});
    Bounds positions;
    Bounds values;
    const auto add = [&](const TestEvaluation &evaluation, Direction direction, LineRole role,
                         const Text &name) {
        const PositioningResults &results = resultsOf(measurement, evaluation);
        FigureLine line;
        line.role = role;
        const QString mean = direction == Direction::positive ? QStringLiteral("x̄↑") : QStringLiteral("x̄↓");
        line.name = mean + QLatin1Char(' ') + language.text(name);
        for (std::size_t i = 0; i < std::min(measurement.targets.size(), results.targets.size()); ++i) {
            const double value =
                (direction == Direction::positive ? results.targets[i].positive : results.targets[i].negative)
                    .mean;
            if (!std::isfinite(value))
                continue;
            line.points.emplace_back(measurement.targets[i] * along, value * across);
            positions.include(line.points.back().x());
            values.include(line.points.back().y());
        }
        line.points = thinned(std::move(line.points));
        if (!line.points.empty())
            figure.lines.push_back(std::move(line));
    };
    const Text measured = REPORT_TEXT("report", "measured");
    const Text predicted = REPORT_TEXT("report", "predicted");
    add(before, Direction::positive, LineRole::measuredUp, measured);
    add(before, Direction::negative, LineRole::measuredDown, measured);
    add(after, Direction::positive, LineRole::predictedUp, predicted);
    add(after, Direction::negative, LineRole::predictedDown, predicted);
    const QString letter = QString::fromUtf8(before.edition->targetLetter);
    figure.x.quantity = language.text(REPORT_TEXT("report", "Target position"));
    figure.x.symbol = QStringLiteral("P");
    figure.x.subscript = letter;
    figure.x.unit = language.unit(positionQuantity(measurement.axis));
    figure.x.angle = rotary;
    figure.y.quantity = language.text(REPORT_TEXT("report", "Mean deviation"));
    figure.y.symbol = QStringLiteral("x̄");
    figure.y.subscript = letter;
    figure.y.unit = language.unit(deviationQuantity(measurement.axis));
    const Bounds x = positions.widened(0.03, 1e-6);
    const Bounds y = values.widened(valueMargin, 1e-6);
    setRange(figure.x, x.lowest, x.highest, mostPositionTicks,
             rotary ? TickSteps::angles : TickSteps::lengths, language);
    setRange(figure.y, y.lowest, y.highest, mostTicksOfValues, TickSteps::values, language);
    return figure;
}

} // namespace palmer
