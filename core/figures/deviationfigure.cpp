// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "figures/curvefield.h"
#include "figures/ticks.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/evaluation/resultsof.h"
#include "language/decimals.h"
#include "language/rounding.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace palmer {

namespace {

/// Space left of the first and right of the last target, as a fraction of the range.
constexpr double positionMargin = 0.03;
constexpr double mostValueTicks = 12;

struct AxisSource {
    const PositioningMeasurement &measurement;
    const PositioningResults &results;
    const TestEvaluation &evaluation;
    bool rotary = false;
    double positionScale = 0; ///< mm or degrees → displayed unit of positions
    double scale = 0;         ///< mm or degrees → displayed unit of deviations
    double c = 0;
    bool limits = false; ///< true: ± c·s is drawn

    [[nodiscard]] std::size_t targets() const {
        return std::min(measurement.targets.size(), results.targets.size());
    }
    [[nodiscard]] double position(std::size_t i) const { return measurement.targets[i] * positionScale; }
    [[nodiscard]] double position(const Ruling &ruling) const { return position(index(ruling)); }
    [[nodiscard]] static std::size_t index(const Ruling &ruling) {
        return static_cast<std::size_t>(ruling.target - 1);
    }
    [[nodiscard]] bool bothWays() const { return results.upward && results.downward; }

    [[nodiscard]] const DirectionStatistics &statistics(std::size_t i, Direction direction) const {
        return direction == Direction::positive ? results.targets[i].positive : results.targets[i].negative;
    }
    [[nodiscard]] double mean(std::size_t i, Direction direction) const {
        return statistics(i, direction).mean * scale;
    }
    [[nodiscard]] double upper(std::size_t i, Direction direction) const {
        return mean(i, direction) + c * statistics(i, direction).s * scale;
    }
    [[nodiscard]] double lower(std::size_t i, Direction direction) const {
        return mean(i, direction) - c * statistics(i, direction).s * scale;
    }
    [[nodiscard]] std::vector<Direction> directions() const {
        std::vector<Direction> directions;
        if (results.upward)
            directions.push_back(Direction::positive);
        if (results.downward)
            directions.push_back(Direction::negative);
        return directions;
    }
};

CurveRole roleOf(Direction direction) {
    return direction == Direction::positive ? CurveRole::up : CurveRole::down;
}

bool wholeTravelOfLongAxis(const PositioningMeasurement &measurement, const PositioningResults &results) {
    return !results.judgedAsZone && isLongAxis(measurement);
}

void addCurves(CurveFigure &figure, const AxisSource &source, CurveRole role, auto &&mean) {
    bool open = false;
    for (std::size_t i = 0; i < source.targets(); ++i) {
        const double y = mean(i);
        if (!std::isfinite(y)) {
            open = false;
            continue;
        }
        if (!open)
            figure.curves.push_back({role, {}});
        open = true;
        figure.curves.back().points.push_back({source.position(i), y, static_cast<int>(i) + 1});
    }
}

void addBands(CurveFigure &figure, const AxisSource &source, Direction direction) {
    bool open = false;
    for (std::size_t i = 0; i < source.targets(); ++i) {
        const BandPoint point{source.position(i), source.lower(i, direction), source.upper(i, direction)};
        if (!std::isfinite(point.lower) || !std::isfinite(point.upper)) {
            open = false;
            continue;
        }
        if (!open)
            figure.bands.push_back({roleOf(direction), {}});
        open = true;
        figure.bands.back().points.push_back(point);
    }
}

void addReadings(CurveFigure &figure, const AxisSource &source) {
    int ups = 0;
    int downs = 0;
    figure.readings.reserve(source.targets() * source.measurement.runs.size());
    for (const Run &run : source.measurement.runs) {
        const int number = run.approach == Direction::positive ? ++ups : ++downs;
        for (std::size_t i = 0; i < std::min(source.targets(), run.deviations.size()); ++i) {
            if (!run.deviations[i])
                continue;
            const double correction =
                i < source.results.corrections.size() ? source.results.corrections[i] : 0.0;
            figure.readings.push_back({roleOf(run.approach), source.position(i),
                                       (*run.deviations[i] + correction) * source.scale,
                                       static_cast<int>(i) + 1, number});
        }
    }
}

/// The parameter, or null if the edition does not have it or it has no value.
const Parameter *parameter(const AxisSource &source, std::string_view id) {
    for (const Parameter &candidate : source.evaluation.parameters) {
        if (candidate.term.id == id && candidate.value && candidate.ruling[0])
            return &candidate;
    }
    return nullptr;
}

/// Adds a dimension unless its value is zero. A limit that gave a verdict is drawn next to it.
void addDimension(CurveFigure &figure, const AxisSource &source, const Parameter &shown,
                  Dimension dimension) {
    if (!(dimension.upper > dimension.lower))
        return;
    if (shown.verdict && shown.limit && shown.limit->value) {
        dimension.limit = *shown.limit->value * source.scale;
        if (shown.guardBand)
            dimension.guard = *shown.guardBand * source.scale;
    }
    dimension.label = QString::fromUtf8(shown.term.symbol.base);
    dimension.id = QString::fromUtf8(shown.term.id);
    figure.dimensions.push_back(std::move(dimension));
}

/// Adds A, E or M: from the ruling place of the largest value to that of the smallest.
void addSpan(CurveFigure &figure, const AxisSource &source, std::string_view id, auto &&largest,
             auto &&smallest) {
    const Parameter *shown = parameter(source, id);
    if (!shown || !shown->ruling[1])
        return;
    addDimension(figure, source, *shown,
                 {{},
                  {},
                  smallest(*shown->ruling[1]),
                  largest(*shown->ruling[0]),
                  source.position(*shown->ruling[1]),
                  source.position(*shown->ruling[0]),
                  DimensionPlace::gutter});
}

/// Adds R: R_i is the height of the limits of both directions taken together.
void addRepeatability(CurveFigure &figure, const AxisSource &source, std::string_view id) {
    const Parameter *shown = parameter(source, id);
    if (!shown)
        return;
    const std::size_t i = AxisSource::index(*shown->ruling[0]);
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    for (const Direction direction : source.directions()) {
        lower = std::min(lower, source.lower(i, direction));
        upper = std::max(upper, source.upper(i, direction));
    }
    // The axis is left of the first target.
    const DimensionPlace place = i + 1 == source.targets() ? DimensionPlace::gutter
                                 : i == 0                  ? DimensionPlace::rightOfTarget
                                                           : DimensionPlace::leftOfTarget;
    addDimension(figure, source, *shown,
                 {{}, {}, lower, upper, source.position(i), source.position(i), place});
}

void addReversal(CurveFigure &figure, const AxisSource &source) {
    const Parameter *shown = parameter(source, "B");
    if (!shown)
        return;
    const std::size_t i = AxisSource::index(*shown->ruling[0]);
    const auto [lower, upper] =
        std::minmax({source.mean(i, Direction::positive), source.mean(i, Direction::negative)});
    addDimension(
        figure, source, *shown,
        {{}, {}, lower, upper, source.position(i), source.position(i), DimensionPlace::rightOfTarget});
}

/// Adds R, M, E, A from the plot outwards, and B.
void addDimensions(CurveFigure &figure, const AxisSource &source) {
    if (source.targets() == 0 || (!source.results.upward && !source.results.downward))
        return;
    const Direction only = source.results.upward ? Direction::positive : Direction::negative;
    const bool both = source.bothWays();
    const auto id = [&](const char *bidirectional, const char *up, const char *down) {
        return both ? bidirectional : only == Direction::positive ? up : down;
    };
    const auto mean = [&](const Ruling &ruling) {
        return source.mean(AxisSource::index(ruling), ruling.approach.value_or(only));
    };
    if (source.limits)
        addRepeatability(figure, source, id("R", "R+", "R-"));
    if (both) {
        const auto meanOfBoth = [&](const Ruling &ruling) {
            return source.results.targets[AxisSource::index(ruling)].mean() * source.scale;
        };
        addSpan(figure, source, "M", meanOfBoth, meanOfBoth);
    }
    addSpan(figure, source, id("E", "E+", "E-"), mean, mean);
    if (source.limits) {
        addSpan(
            figure, source, id("A", "A+", "A-"),
            [&](const Ruling &ruling) {
                return source.upper(AxisSource::index(ruling), ruling.approach.value_or(only));
            },
            [&](const Ruling &ruling) {
                return source.lower(AxisSource::index(ruling), ruling.approach.value_or(only));
            });
    }
    if (both)
        addReversal(figure, source);
}

void addLegend(CurveFigure &figure, const AxisSource &source, const Language &language) {
    const auto shown = [&](CurveRole role) {
        return std::any_of(figure.bands.begin(), figure.bands.end(),
                           [role](const Band &band) { return band.role == role; });
    };
    for (const Direction direction : source.directions()) {
        const bool up = direction == Direction::positive;
        const QString arrow = up ? QStringLiteral("↑") : QStringLiteral("↓");
        QString text = QStringLiteral("x̄") + arrow;
        const bool band = shown(roleOf(direction));
        if (band) {
            text += QStringLiteral(" ±\u202f") + language.number(source.c, Quantity::number, -1) +
                    QStringLiteral("s") + arrow;
        }
        figure.legend.push_back({up ? LegendSample::up : LegendSample::down, text, band});
    }
    if (source.bothWays()) {
        figure.legend.push_back(
            {LegendSample::mean,
             QStringLiteral("x̄ ") + language.text(REPORT_TEXT("report", "bi-directional")), false});
    }
    if (!figure.readings.empty()) {
        figure.legend.push_back(
            {LegendSample::readings, language.text(REPORT_TEXT("report", "readings")), false});
    }
}

/// Limits outside the axis are not drawn but named; the others get a legend entry.
void addLimits(CurveFigure &figure, const Test &test, const TestEvaluation &evaluation,
               const Language &language) {
    bool band = false;
    bool bandIsU = test.decisionRule.guardFactor == 1;
    bool any = false;
    QStringList beyond;
    for (Dimension &dimension : figure.dimensions) {
        const auto shown = std::ranges::find(evaluation.parameters, dimension.id.toStdString(),
                                             [](const Parameter &p) { return std::string(p.term.id); });
        if (!dimension.limit || shown == evaluation.parameters.end())
            continue;
        const double value = *shown->limit->value;
        const Quantity quantity = shown->term.quantity;
        const int decimals = limitDecimals(value, quantity, language.units());
        dimension.limitText = language.number(value, quantity, decimals);
        if (dimension.lower + *dimension.limit > figure.y.to) {
            beyond << dimension.label + QStringLiteral("\u00A0") +
                          language.quantity(value, quantity, decimals);
            dimension.limit.reset();
            dimension.guard.reset();
            continue;
        }
        any = true;
        band |= dimension.guard.has_value();
        bandIsU = bandIsU && shown->decidedBy != UncertaintyMethod::monteCarlo;
    }
    if (!beyond.isEmpty())
        figure.note =
            language.sentence(beyond.size() == 1 ? REPORT_TEXT("report", "limit beyond the scale: %1")
                                                 : REPORT_TEXT("report", "limits beyond the scale: %1"),
                              {beyond.join(QStringLiteral(", ")).toStdString()});
    if (any)
        figure.legend.push_back(
            {LegendSample::limit,
             band ? language.sentence({REPORT_TEXT("report", "limit ± %1"), {bandIsU ? "U" : "g"}, {}})
                  : language.text(REPORT_TEXT_FOR("report", "limit", "of a figure")),
             band});
}

Interval rangeOfPositions(const CurveFigure &figure, bool rotary) {
    const double alone = rotary ? 5 : 10; // half the range around a single target
    const double first = figure.positions.empty() ? 0 : figure.positions.front();
    const double last = figure.positions.empty() ? 0 : figure.positions.back();
    const double length = last - first;
    const double margin = length > 0 ? length * positionMargin / (1 - 2 * positionMargin) : alone;
    return {first - margin, last + margin};
}

Interval rangeOfValues(const CurveFigure &figure) {
    Bounds range;
    for (const Band &band : figure.bands) {
        for (const BandPoint &point : band.points) {
            range.include(point.lower);
            range.include(point.upper);
        }
    }
    for (const Curve &curve : figure.curves) {
        for (const FigurePoint &point : curve.points)
            range.include(point.y);
    }
    for (const ReadingMark &reading : figure.readings)
        range.include(reading.y);
    const auto [lowest, highest] = range;
    if (!(lowest <= highest))
        return {-1, 1}; // no values yet
    const double span = highest - lowest;
    if (span <= 1e-9 * std::max({1.0, std::abs(lowest), std::abs(highest)}))
        return {lowest - 1, highest + 1}; // all equal: one unit on either side
    const double margin = span * valueMargin / (1 - 2 * valueMargin);
    return {lowest - margin, highest + margin};
}

} // namespace

CurveFigure deviationFigure(const Test &test, const TestEvaluation &evaluation, const Language &language,
                            const DeviationFigureOptions &options) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    const PositioningResults &results = resultsOf(measurement, evaluation);
    const bool rotary = measurement.axis.motion == Motion::rotary;
    static const Edition ofNone;
    const Edition &edition = evaluation.edition ? *evaluation.edition : ofNone;
    const double c = edition.c;
    const AxisSource source{measurement,
                            results,
                            evaluation,
                            rotary,
                            unitScale(positionQuantity(measurement.axis), language.units()),
                            unitScale(deviationQuantity(measurement.axis), language.units()),
                            c,
                            c > 0 && !wholeTravelOfLongAxis(measurement, results)};

    CurveFigure figure;
    figure.title = language.sentence(edition.deviationsOfAxis, {measurement.axis.name});
    for (std::size_t i = 0; i < source.targets(); ++i)
        figure.positions.push_back(source.position(i));
    for (const Direction direction : source.directions()) {
        if (source.limits)
            addBands(figure, source, direction);
        addCurves(figure, source, roleOf(direction),
                  [&](std::size_t i) { return source.mean(i, direction); });
    }
    if (source.bothWays()) {
        addCurves(figure, source, CurveRole::mean,
                  [&](std::size_t i) { return results.targets[i].mean() * source.scale; });
    }
    if (options.readingMarks && std::max(results.positiveRuns, results.negativeRuns) > 1)
        addReadings(figure, source);
    if (options.dimensions)
        addDimensions(figure, source);
    addLegend(figure, source, language);

    figure.x.quantity = language.text(REPORT_TEXT("report", "Target position"));
    figure.x.symbol = QStringLiteral("P");
    figure.x.subscript = QString::fromUtf8(edition.targetLetter);
    figure.x.unit = language.unit(rotary ? Quantity::angle : Quantity::position);
    figure.x.angle = rotary;
    figure.y.quantity = language.text(edition.deviation);
    figure.y.symbol = QStringLiteral("x");
    figure.y.subscript = QStringLiteral("ij");
    figure.y.unit = language.unit(rotary ? Quantity::angularDeviation : Quantity::deviation);
    const Interval positions = rangeOfPositions(figure, rotary);
    const Interval values = rangeOfValues(figure);
    figure = withRanges(std::move(figure), positions, values, language);
    addLimits(figure, test, evaluation, language);
    return figure;
}

CurveFigure withRanges(CurveFigure figure, const Interval &x, const Interval &y, const Language &language) {
    setRange(figure.x, x.from, x.to, mostPositionTicks,
             figure.x.angle ? TickSteps::angles : TickSteps::lengths, language);
    setRange(figure.y, y.from, y.to, mostValueTicks, TickSteps::values, language);
    return figure;
}

} // namespace palmer
