// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/diagnosisfigure.h"

#include "figures/curvefield.h"
#include "figures/thinning.h"
#include "figures/ticks.h"
#include "kernel/diagnosis/sourcewords.h"
#include "kernel/diagnosis/traces.h"
#include "kernel/numerics/angles.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace palmer {

namespace {

constexpr double micrometres = 1000; ///< per millimetre
QString nameOf(Sense sense, const std::string &index, const Language &language) {
    return language.sentence(sense == Sense::counterclockwise ? REPORT_TEXT("report", "anticlockwise, %1")
                                                              : REPORT_TEXT("report", "clockwise, %1"),
                             {index});
}

QString measuredName(const EvaluatedPath &path, const Language &language) {
    return language.sentence(path.sense == Sense::counterclockwise
                                 ? REPORT_TEXT("report", "measured, anticlockwise %1")
                                 : REPORT_TEXT("report", "measured, clockwise %1"),
                             {path.index});
}

LineRole roleOf(Sense sense) {
    return sense == Sense::counterclockwise ? LineRole::counterclockwise : LineRole::clockwise;
}

/// The evaluated paths as measured.
std::vector<Points> measuredPaths(const CircularResults &results) {
    std::vector<Points> paths;
    for (const EvaluatedPath &path : results.paths)
        paths.push_back(path.points);
    return paths;
}

/// Sets the range of a value axis to `bounds` with a margin; at least ± least about their middle.
void setValues(FigureAxis &axis, const Bounds &bounds, double least, double mostTicks,
               const Language &language) {
    constexpr double room = 0.06;
    Interval range{-least, least};
    if (bounds.lowest <= bounds.highest) {
        const double middle = (bounds.lowest + bounds.highest) / 2;
        const double half = std::max(least, (bounds.highest - bounds.lowest) * (0.5 + room));
        range = {middle - half, middle + half};
    }
    setRange(axis, range.from, range.to, mostTicks, TickSteps::values, language);
}

/// Keeps the extremes in each of `parts` equal parts of 0 … `to`.
void thin(std::vector<QPointF> &points, double to, std::size_t parts) {
    if (points.size() <= 4 * parts)
        return;
    std::vector<QPointF> kept;
    for (const std::size_t i : thinnedPlaces(
             points.size(), 0, to, parts, [&](std::size_t k) { return points[k].x(); },
             [&](std::size_t k) { return points[k].y(); }))
        kept.push_back(points[i]);
    points = std::move(kept);
}

/// Splits the points of an arc into lines of at most one turn, at each passage through 0°.
void addTurns(LineFigure &figure, LineRole role, const QString &name, const std::vector<double> &angles,
              const std::vector<double> &curve, double scale, std::size_t mostPoints) {
    FigureLine line{role, {}, name, {}};
    double turn = 0;
    const auto close = [&] {
        if (mostPoints > 0)
            thin(line.points, fullTurn, mostPoints);
        if (!line.points.empty())
            figure.lines.push_back(std::move(line));
        line = {role, {}, {}, {}};
    };
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double now = std::floor(angles[i] / fullTurn);
        if (i > 0 && now != turn)
            close();
        turn = now;
        line.points.emplace_back(angles[i] - now * fullTurn, curve[i] * scale);
    }
    close();
}

/// Sets the range 0° … 360° and marks the ends of the axes.
void setAngles(FigureAxis &axis, const Plane &plane, const Language &language) {
    constexpr double quarter = 90;
    axis.angle = true;
    axis.unit = language.unit(Quantity::angle);
    axis.from = 0;
    axis.to = fullTurn;
    axis.step = quarter;
    const std::array<std::string, 4> ends{"+" + plane.first, "+" + plane.second, "−" + plane.first,
                                          "−" + plane.second};
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const double angle = static_cast<double>(k) * quarter;
        axis.ticks.push_back({angle, language.quantity(angle, Quantity::angle, 0) + QStringLiteral(" (") +
                                         QString::fromStdString(ends[k]) + u')'});
    }
    axis.ticks.push_back({fullTurn, language.quantity(fullTurn, Quantity::angle, 0)});
}

} // namespace

std::vector<std::size_t> prevailingSources(const DiagnosedTest &test) {
    const std::vector<DiagnosedPart> parts = rankedParts(test.diagnosis);
    const std::size_t count = prevailingParts(test.circle, test.diagnosis);
    std::vector<std::size_t> sources;
    for (std::size_t i = 0; i < count; ++i)
        sources.insert(sources.end(), parts[i].sources.begin(), parts[i].sources.end());
    return sources;
}

CircleFigure diagnosisFigure(const DiagnosedTest &test, std::span<const std::size_t> chosen,
                             const Language &language, const DiagnosisFigureOptions &options) {
    const CircularResults &results = test.results();
    const FittedCircle fitted = fittedCircle(test.circle, test.diagnosis);
    std::vector<PathProfile> profiles =
        profilesAbout(test.measurement(), results, measuredPaths(results), fitted.centre, fitted.radius);
    if (!chosen.empty()) {
        auto made =
            profilesAbout(test.measurement(), results, syntheticPath(test.circle, test.diagnosis, chosen),
                          fitted.centre, fitted.radius);
        for (PathProfile &profile : made) {
            profile.synthetic = true;
            profiles.push_back(std::move(profile));
        }
    }
    CircleFigureOptions drawn;
    drawn.size = options.size;
    drawn.fillFrame = true;
    CircleFigure figure = pathsFigure(profiles, test.measurement().plane, language, drawn);
    figure.title = language.text(REPORT_TEXT("report", "Measured and synthetic path"));
    figure.centre = language.text(REPORT_TEXT("report", "about the fitted centre and radius"));
    std::vector<CircleLegendEntry> legend;
    for (const EvaluatedPath &path : results.paths) {
        figure.arrows.push_back({path.sense, QString::fromStdString(path.index)});
        legend.push_back({path.sense == Sense::counterclockwise ? CircleLegendSample::counterclockwise
                                                                : CircleLegendSample::clockwise,
                          measuredName(path, language)});
    }
    for (const QString &text : options.synthetic)
        legend.push_back({&text == &options.synthetic.front() ? CircleLegendSample::synthetic
                                                              : CircleLegendSample::continued,
                          text});
    setLegend(figure, std::move(legend), options.columns);
    return figure;
}

CircleFigure diagnosisFigure(const DiagnosedTest &test, const Language &language) {
    const std::vector<std::size_t> chosen = prevailingSources(test);
    DiagnosisFigureOptions options;
    options.size = CircleFigureOptions().size;
    options.columns = 1;
    constexpr qsizetype namesOfLine = 3;
    QStringList names;
    for (const std::size_t i : chosen)
        names << language.sentence(sourceName(test.diagnosis.sources[i]));
    for (qsizetype i = 0; i < names.size(); i += namesOfLine) {
        QString line = names.mid(i, namesOfLine).join(QStringLiteral(", "));
        if (i + namesOfLine < names.size())
            line += u',';
        options.synthetic << (i > 0 ? line
                                    : language.sentence(REPORT_TEXT("report", "synthetic: %1"),
                                                        {line.toStdString()}));
    }
    return diagnosisFigure(test, chosen, language, options);
}

LineFigure residualFigure(const DiagnosedTest &test, const Language &language, std::size_t mostPoints) {
    constexpr double mostTicks = 4;
    constexpr double leastHalf = 0.02e-3; // mm
    const double scale = unitScale(Quantity::deviation, language.units());
    const double least = leastHalf * scale;
    LineFigure figure;
    figure.title = language.text(REPORT_TEXT("report", "Rest"));
    const auto curves = unexplained(test.circle, test.diagnosis);
    Bounds values;
    for (std::size_t a = 0; a < curves.size(); ++a) {
        const DiagnosedArc &arc = test.circle.arcs[a];
        addTurns(figure, roleOf(arc.sense), nameOf(arc.sense, test.results().paths[a].index, language),
                 arc.angles, curves[a], scale, mostPoints);
        for (const double value : curves[a])
            values.include(value * scale);
    }
    setAngles(figure.x, test.measurement().plane, language);
    figure.y.quantity = language.text(REPORT_TEXT_FOR("report", "rest", "what no source explains"));
    figure.y.unit = language.unit(Quantity::deviation);
    setValues(figure.y, values, least, mostTicks, language);
    return figure;
}

LineFigure spectrumFigure(const DiagnosedTest &test, const Language &language, std::size_t mostPoints) {
    constexpr double mostTicks = 8;
    constexpr double fewestWaves = 20;
    constexpr double standsOut = 0.1; // fraction of the largest amplitude
    const double scale = unitScale(Quantity::deviation, language.units());
    LineFigure figure;
    figure.title = language.text(REPORT_TEXT("report", "Spectrum of the rest"));
    const auto curves = unexplained(test.circle, test.diagnosis);
    double largest = 0;
    for (std::size_t a = 0; a < curves.size(); ++a) {
        const DiagnosedArc &arc = test.circle.arcs[a];
        FigureLine line{
            roleOf(arc.sense), {}, nameOf(arc.sense, test.results().paths[a].index, language), {}};
        for (const SpectralLine &wave : spectrum(test.circle, a, curves[a])) {
            line.points.emplace_back(wave.perTurn, wave.amplitude * scale);
            largest = std::max(largest, line.points.back().y());
        }
        if (!line.points.empty())
            figure.lines.push_back(std::move(line));
    }
    double last = fewestWaves;
    for (const FigureLine &line : figure.lines) {
        for (const QPointF &point : line.points) {
            if (point.y() >= standsOut * largest)
                last = std::max(last, point.x());
        }
    }
    figure.x.quantity = language.text(REPORT_TEXT("report", "waves a turn"));
    figure.x.symbol = QStringLiteral("n");
    setRange(figure.x, 0, scaleEnd(last), mostTicks, TickSteps::values, language);
    for (FigureLine &line : figure.lines) {
        if (mostPoints == 0)
            break;
        std::erase_if(line.points, [&](const QPointF &point) { return point.x() > figure.x.to; });
        thin(line.points, figure.x.to, mostPoints);
    }
    figure.y.quantity = language.text(REPORT_TEXT("report", "amplitude"));
    figure.y.unit = language.unit(Quantity::deviation);
    setRange(figure.y, 0, scaleEnd(largest), 4, TickSteps::values, language);
    return figure;
}

namespace {

/// Indices of the tests in order of increasing feed.
std::vector<std::size_t> byFeed(std::span<const DiagnosedTest> tests) {
    std::vector<std::size_t> places(tests.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::ranges::stable_sort(places, {}, [&](std::size_t i) { return tests[i].circle.feed.value_or(0); });
    return places;
}

} // namespace

std::vector<PathProfile> profilesAtFeeds(std::span<const DiagnosedTest> tests) {
    std::vector<PathProfile> profiles;
    int layer = 0;
    for (const std::size_t i : byFeed(tests)) {
        const DiagnosedTest &test = tests[i];
        const CircularResults &results = test.results();
        for (PathProfile &profile :
             profilesAbout(test.measurement(), results, measuredPaths(results),
                           fittedCircle(test.circle, test.diagnosis).centre, test.circle.nominalRadius)) {
            profile.layer = layer;
            profiles.push_back(std::move(profile));
        }
        ++layer;
    }
    return profiles;
}

CircleFigure feedsFigure(std::span<const DiagnosedTest> tests, std::span<const PathProfile> profiles,
                         const Language &language, const CircleFigureOptions &options) {
    CircleFigure figure = pathsFigure(profiles, tests.front().measurement().plane, language, options);
    figure.title = language.text(REPORT_TEXT("report", "Circles at several feeds"));
    figure.centre = language.text(REPORT_TEXT("report", "each about its own fitted centre"));
    std::vector<CircleLegendEntry> legend;
    int layer = 0;
    for (const std::size_t i : byFeed(tests)) {
        const double feed = tests[i].measurement().feed.value_or(0);
        legend.push_back({CircleLegendSample::layer, language.quantity(feed, Quantity::feed), layer++});
    }
    setLegend(figure, std::move(legend), 3);
    return figure;
}

LineFigure overFeedFigure(std::span<const DiagnosedTest> tests, InfluenceId source, PlaneAxis axis,
                          const Language &language) {
    const InfluenceId id = source == InfluenceId::commonLag     ? InfluenceId::radius
                           : source == InfluenceId::lagMismatch ? InfluenceId::scaleMismatch
                                                                : source;
    constexpr double mostTicks = 5;
    constexpr double room = 0.06;
    LineFigure figure;
    FigureLine value{LineRole::counterclockwise, {}, {}, {}};
    FigureLine lower{LineRole::measuredDown, {}, {}, {}};
    FigureLine upper{LineRole::measuredDown, {}, {}, {}};
    const bool inMicrometres = influence(id).unit == std::string_view("µm");
    const double scale = inMicrometres ? unitScale(Quantity::micrometres, language.units()) : 1;
    Bounds values;
    Bounds feeds;
    for (const std::size_t i : byFeed(tests)) {
        const SourceEstimate *estimate = tests[i].diagnosis.find(id, axis);
        const double feed = tests[i].measurement().feed.value_or(0);
        feeds.include(feed);
        if (!estimate)
            continue;
        if (figure.title.isEmpty())
            figure.title = language.sentence(sourceName(*estimate));
        if (!estimate->value || !estimate->u)
            continue;
        const double shown = shownParameter(id, *estimate->value) * scale;
        const double half = shownExpanded(*estimate).value_or(0) * scale;
        value.points.emplace_back(feed, shown);
        lower.points.emplace_back(feed, shown - half);
        upper.points.emplace_back(feed, shown + half);
        for (const double edge : {shown - half, shown + half})
            values.include(edge);
    }
    if (!value.points.empty()) {
        value.name = figure.title;
        upper.name = language.text(REPORT_TEXT("report", "95 % interval"));
        figure.lines = {value, upper, lower};
    }
    figure.x.quantity = language.text(REPORT_TEXT_FOR("report", "Feed", "contouring"));
    figure.x.symbol = QStringLiteral("F");
    figure.x.unit = language.unit(Quantity::feed);
    const double span = feeds.lowest <= feeds.highest ? feeds.highest : 1;
    setRange(figure.x, 0, span * (1 + room), mostTicks, TickSteps::values, language);
    figure.y.quantity = figure.title;
    figure.y.unit =
        inMicrometres ? language.unit(Quantity::micrometres) : QString::fromUtf8(influence(id).unit);
    setValues(figure.y, values, std::numeric_limits<double>::min(), mostTicks, language);
    return figure;
}

} // namespace palmer
