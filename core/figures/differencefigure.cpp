// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/differencefigure.h"

#include "figures/curvefield.h"
#include "figures/testfigures.h"
#include "figures/ticks.h"

namespace palmer {

namespace {

/// `scale`: displayed unit per unit of the curve.
void addCurve(CurveFigure &figure, Bounds &values, const ComparedCurve &curve,
              const std::vector<double> &targets, double scale, const Language &language) {
    const CurveRole role = !curve.direction                          ? CurveRole::mean
                           : *curve.direction == Direction::positive ? CurveRole::up
                                                                     : CurveRole::down;
    std::vector<Curve> parts(1, {role, {}});
    std::vector<Band> bands(1, {role, {}});
    bool any = false;
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
        const double x = targets[i];
        if (!curve.values[i]) { // a gap begins another curve
            parts.push_back({role, {}});
            bands.push_back({role, {}});
            continue;
        }
        any = true;
        const double y = *curve.values[i] * scale;
        parts.back().points.push_back({x, y, static_cast<int>(i) + 1});
        values.include(y);
        if (!curve.band[i] || role != CurveRole::mean)
            continue;
        const double half = *curve.band[i] * scale;
        bands.back().points.push_back({x, y - half, y + half});
        values.include(y - half);
        values.include(y + half);
    }
    if (!any)
        return;
    std::erase_if(parts, [](const Curve &part) { return part.points.empty(); });
    std::erase_if(bands, [](const Band &part) { return part.points.empty(); });
    const bool hasBand = !bands.empty();
    figure.curves.insert(figure.curves.end(), parts.begin(), parts.end());
    figure.bands.insert(figure.bands.end(), bands.begin(), bands.end());
    const QString mean = hasBand ? language.text(REPORT_TEXT("report", "x̄ bi-directional ± U for all points"))
                                 : language.text(REPORT_TEXT("report", "x̄ bi-directional"));
    figure.legend.push_back({role == CurveRole::up     ? LegendSample::up
                             : role == CurveRole::down ? LegendSample::down
                                                       : LegendSample::mean,
                             role == CurveRole::up     ? QStringLiteral("x̄↑")
                             : role == CurveRole::down ? QStringLiteral("x̄↓")
                                                       : mean,
                             hasBand});
}

/// The least range of the values: 0.2 µm or arc seconds, in the unit shown.
double leastRange(Quantity quantity, double scale) {
    return 0.2 * scale / unitScale(quantity);
}

} // namespace

CurveFigure differenceFigure(const TestComparison &comparison, const Language &language) {
    const double scale = unitScale(comparison.quantity, language.units());
    const bool rotary = comparison.quantity == Quantity::angularDeviation;
    CurveFigure figure;
    figure.title = language.text(REPORT_TEXT("report", "Difference of the mean deviations"));
    figure.positions = comparison.targets;
    figure.x.quantity = language.text(REPORT_TEXT("report", "Target position"));
    figure.x.symbol = QStringLiteral("P");
    figure.x.subscript = QString::fromUtf8(comparison.edition ? comparison.edition->targetLetter : "i");
    figure.x.unit = language.unit(rotary ? Quantity::angle : Quantity::position);
    figure.x.angle = rotary;
    figure.y.quantity = language.text(REPORT_TEXT("report", "after − before"));
    figure.y.unit = language.unit(comparison.quantity);
    Bounds values;
    for (const ComparedCurve &curve : comparison.curves)
        addCurve(figure, values, curve, comparison.targets, scale, language);
    const Bounds y = values.widened(valueMargin, leastRange(comparison.quantity, scale));
    const double first = comparison.targets.empty() ? 0 : comparison.targets.front();
    const double last = comparison.targets.empty() ? 1 : comparison.targets.back();
    return withRanges(std::move(figure), {first, last > first ? last : first + 1}, {y.lowest, y.highest},
                      language);
}

LineFigure pathDifferenceFigure(const std::vector<ComparedPath> &paths, const Language &language) {
    constexpr double turn = 360; // degrees
    constexpr double mostParts = 8;
    LineFigure figure;
    figure.title = language.text(REPORT_TEXT("report", "Difference of the paths"));
    figure.x.quantity = language.text(REPORT_TEXT("report", "Angle"));
    figure.x.unit = QStringLiteral("°");
    figure.x.angle = true;
    figure.y.quantity = language.text(REPORT_TEXT("report", "after − before"));
    figure.y.unit = language.unit(Quantity::deviation);
    const double scale = unitScale(Quantity::deviation, language.units());
    Bounds values;
    for (const ComparedPath &path : paths) {
        const bool ccw = path.sense == Sense::counterclockwise;
        FigureLine line{
            ccw ? LineRole::counterclockwise : LineRole::clockwise,
            {},
            language.text(ccw ? REPORT_TEXT("report", "anticlockwise") : REPORT_TEXT("report", "clockwise")),
            {}};
        for (const auto &[angle, deviation] : path.points) {
            line.points.emplace_back(angle, deviation * scale);
            values.include(deviation * scale);
        }
        figure.lines.push_back(std::move(line));
    }
    const Bounds y = values.widened(valueMargin, leastRange(Quantity::deviation, scale));
    setRange(figure.x, 0, turn, mostParts, TickSteps::angles, language);
    setRange(figure.y, y.lowest, y.highest, mostParts - 2, TickSteps::values, language);
    return figure;
}

} // namespace palmer
