// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/circular.h"

#include <QPointF>
#include <QSizeF>
#include <QString>
#include <optional>
#include <variant>
#include <vector>

namespace palmer {

/// Values that a part of a figure shows: the approach in the positive (↑) or negative (↓) direction, the mean
/// of both, or readings at rest. The renderer decides how they look.
enum class CurveRole { up, down, mean, drift };

/// A point of a figure, in the units of its axes.
struct FigurePoint {
    double x = 0;
    double y = 0;
    int target = 0; ///< from 1

    bool operator==(const FigurePoint &) const = default;
};

/// Means of consecutive targets; a gap begins another curve.
struct Curve {
    CurveRole role = CurveRole::mean;
    std::vector<FigurePoint> points;

    bool operator==(const Curve &) const = default;
};

/// Lower and upper limit at a target, x̄ ± c·s.
struct BandPoint {
    double x = 0;
    double lower = 0;
    double upper = 0;

    bool operator==(const BandPoint &) const = default;
};

/// Limits of consecutive targets; a single one is drawn as a whisker.
struct Band {
    CurveRole role = CurveRole::up;
    std::vector<BandPoint> points;

    bool operator==(const Band &) const = default;
};

/// A single reading; target and run (of its direction) count from 1.
struct ReadingMark {
    CurveRole role = CurveRole::up;
    double x = 0;
    double y = 0;
    int target = 1;
    int run = 1;

    bool operator==(const ReadingMark &) const = default;
};

/// Position of a dimension: in the gutter next to the plot, or left or right of its own target, in the given
/// order.
enum class DimensionPlace { gutter, leftOfTarget, rightOfTarget };

/// A parameter shown as a dimension between two values (upper ≥ lower), with leaders from the positions that
/// rule it.
struct Dimension {
    QString label; ///< symbol: "A", "R↑"
    QString id;    ///< of the parameter
    double lower = 0;
    double upper = 0;
    double lowerPosition = 0; ///< x at which the leader of the lower value starts
    double upperPosition = 0;
    DimensionPlace place = DimensionPlace::gutter;
    QString subscript = {}; ///< index of the label: "VE"
    /// Agreed limit, from the lower value on, and the guard band on either side of it; null if outside the
    /// axis.
    std::optional<double> limit = {};
    std::optional<double> guard = {};
    QString limitText = {}; ///< "32 µm"

    bool operator==(const Dimension &) const = default;
};

/// Sample in front of a legend text.
enum class LegendSample { up, down, mean, readings, drift, limit };

struct LegendEntry {
    LegendSample sample = LegendSample::mean;
    QString text;
    bool band = false; ///< the sample has a band below its line

    bool operator==(const LegendEntry &) const = default;
};

struct Tick {
    double value = 0;
    QString label; ///< number as the language writes it, minus as −

    bool operator==(const Tick &) const = default;
};

/// An axis of a figure: its range and its round ticks (1-2-5; positions also 2.5, angles 15-30-45-60-90), all
/// within the range.
struct FigureAxis {
    QString quantity;  ///< "Target position"
    QString symbol;    ///< "P"
    QString subscript; ///< "i"
    QString unit;      ///< "mm"
    bool angle = false;
    double from = 0;
    double to = 1;
    double step = 0.5;
    std::vector<Tick> ticks;

    bool operator==(const FigureAxis &) const = default;
};

/// Curves over positions or, for a drift test, over time.
struct CurveFigure {
    QString title;
    FigureAxis x;
    FigureAxis y;
    std::vector<Band> bands;
    std::vector<Curve> curves;
    std::vector<ReadingMark> readings;
    std::vector<Dimension> dimensions; ///< gutter: from the plot outwards
    std::vector<LegendEntry> legend;
    std::vector<double> positions; ///< of all targets, ascending
    QString note = {};             ///< names the limits outside the axis; empty: none

    bool operator==(const CurveFigure &) const = default;
};

/// Content of a line of a line figure; the renderer decides how it looks.
enum class LineRole {
    measuredUp,
    measuredDown,
    predictedUp,
    predictedDown,
    machine,
    instrument,
    air,
    counterclockwise,
    clockwise,
    fitted ///< a model through one of the lines
};

struct FigureLine {
    LineRole role = LineRole::machine;
    QString label; ///< short, at the right end of the line; may be empty
    QString name;  ///< in the legend
    std::vector<QPointF> points;
    bool dots = false; ///< the points alone, not joined

    bool operator==(const FigureLine &) const = default;
};

/// A part of the x axis that matters, shaded.
struct FigureBand {
    double from = 0;
    double to = 0;
    QString label; ///< above the plot; may be empty

    bool operator==(const FigureBand &) const = default;
};

/// A range of values within a band, between two dashed lines.
struct FigureSpan {
    double low = 0;
    double high = 0;
    QString label; ///< beside its arrow

    bool operator==(const FigureSpan &) const = default;
};

/// Lines over one axis: temperatures over time, means before and after a compensation, the residual of a
/// diagnosis over the angle. An axis without quantity has no title; lines without names have no legend.
struct LineFigure {
    QString title;
    FigureAxis x;
    FigureAxis y;
    std::vector<FigureLine> lines;
    std::optional<FigureBand> band = {};
    std::optional<FigureSpan> span = {}; ///< only with a band

    bool operator==(const LineFigure &) const = default;
};

/// A point of a path about the centre named in the figure: angle in degrees from the first axis towards the
/// second, unwrapped; deviation in µm.
struct TracePoint {
    double angle = 0;
    double deviation = 0;

    bool operator==(const TracePoint &) const = default;
};

/// Consecutive points of a path: all of them, or first, least, greatest, last of each angle step, in the
/// order of measurement. A path that leaves the view and returns gives several traces.
struct CircleTrace {
    Sense sense = Sense::counterclockwise;
    bool repetition = false;
    std::vector<TracePoint> points;
    bool synthetic = false;   ///< computed from sources of a diagnosis, not measured
    std::optional<int> layer; ///< index of the test in a figure of several tests

    bool operator==(const CircleTrace &) const = default;
};

/// A marked point of a path.
struct TraceMark {
    Sense sense = Sense::counterclockwise;
    TracePoint at;

    bool operator==(const TraceMark &) const = default;
};

/// A point that determines a result: it touches the outer or inner circle, or is Fmax or Fmin.
struct ContactMark {
    TraceMark mark;
    bool outer = true;

    bool operator==(const ContactMark &) const = default;
};

/// Sense in which a path runs, and its index ("XY").
struct SenseArrow {
    Sense sense = Sense::counterclockwise;
    QString index;

    bool operator==(const SenseArrow &) const = default;
};

/// Circles about the named centre that enclose the paths, and their distance: G or G(b).
struct CircleEnvelope {
    QString label;               ///< "G(b)"
    QString subscript;           ///< "f" for feedback signals
    QString id;                  ///< of the parameter: "G(b)_XY"
    double inner = 0;            ///< deviation, µm
    double outer = 0;            ///< outer ≥ inner
    bool dimension = true;       ///< their distance is the result; false: they are Fmin and Fmax
    std::optional<double> limit; ///< width, µm; drawn next to the dimension
    std::optional<double> guard; ///< guard band about that width, µm
    QString limitLabel;          ///< "limit of G(b): 30 µm"

    bool operator==(const CircleEnvelope &) const = default;
};

/// A circle about the nominal one: a ring of the scale, or a limit of F.
struct DeviationCircle {
    double deviation = 0; ///< µm
    QString label;        ///< "+5"

    bool operator==(const DeviationCircle &) const = default;
};

enum class CircleLegendSample {
    counterclockwise,
    clockwise,
    nominal,
    envelope,
    limit,
    centre,
    start,
    contacts,
    repetitions,
    synthetic,
    layer,
    continued ///< continuation line of the text above
};

struct CircleLegendEntry {
    CircleLegendSample sample = CircleLegendSample::nominal;
    QString text;
    int layer = 0;

    bool operator==(const CircleLegendEntry &) const = default;
};

/// Visible part of a circle figure: the point in the middle (mm on the whole figure, y upwards, from the
/// centre of the circles) and the enlargement.
struct CircleView {
    double x = 0;
    double y = 0;
    double zoom = 1;

    bool operator==(const CircleView &) const = default;
};

/// Figure of a circular test: paths with their deviations magnified about the nominal circle. A deviation d
/// (µm) is drawn at plotRadius + magnification·d/1000 mm from the centre.
struct CircleFigure {
    QString title;   ///< content: "Actual paths"
    QString centre;  ///< "about the centre of the minimum zone of G(b)"
    QString caption; ///< "magnification 1 000:1, 5 µm per division"
    QString ratio;   ///< "1 000:1"
    QString firstAxis;
    QString secondAxis;
    QSizeF size;          ///< of the drawing, mm
    double keyHeight = 0; ///< printed height of the legend below the drawing, mm
    int keyColumns = 3;
    double figureRadius = 0;             ///< mm; no deviation is drawn farther out
    QPointF home;                        ///< middle of the whole figure, mm from the centre of the circles
    std::optional<Interval> sector = {}; ///< degrees; if set, the figure shows only this part of the circles
    double plotRadius = 0;               ///< radius of the nominal circle, mm
    double magnification = 1;            ///< 1, 2 or 5 times a power of ten
    double division = 0;                 ///< between rings; length of the scale bar, µm
    QString divisionLabel;               ///< "5 µm"
    double pointStep = 0;                ///< of the traces, mm on the drawing
    CircleView view;
    std::vector<DeviationCircle> rings; ///< ascending; 0 is among them in the whole figure
    std::vector<CircleTrace> traces;
    std::vector<TraceMark> starts;
    std::vector<ContactMark> contacts;
    std::vector<SenseArrow> arrows;
    std::optional<CircleEnvelope> envelope;
    std::vector<DeviationCircle> limits; ///< limits of F
    std::vector<CircleLegendEntry> legend;

    /// Distance from the centre at which a deviation (µm) is drawn, mm.
    [[nodiscard]] double radius(double deviation) const {
        return plotRadius + magnification * deviation / 1000;
    }

    bool operator==(const CircleFigure &) const = default;
};

/// A row of a bar figure: its name on the left, a bar from 0 or a dot, its numbers on the right.
struct Bar {
    QString id;
    QString name;
    QString subscript;                   ///< index at the end of the name
    double size = 0;                     ///< ≥ 0, in the unit of the axis
    QString value;                       ///< "3.60"; a dash if unknown
    QString share;                       ///< "54 %"; a dash if unknown
    bool first = false;                  ///< to be improved first
    std::optional<double> expanded = {}; ///< of a dot: half the length of its error bar
    std::optional<double> limit = {};    ///< agreed: a mark in the row of a dot

    bool operator==(const Bar &) const = default;
};

/// A line across all rows of a bar figure.
struct BarLine {
    double at = 0;
    QString text;        ///< in the legend
    bool chosen = false; ///< solid, otherwise dashed

    bool operator==(const BarLine &) const = default;
};

/// Texts in the legend of dots; empty: not drawn there.
struct DotLegend {
    QString dot;
    QString limit;

    bool operator==(const DotLegend &) const = default;
};

/// Bars below each other on one scale from 0: contributions to an uncertainty, the largest first. Or, with a
/// legend of dots, values with their U as dots, and lines across them: the machines of a type.
struct BarFigure {
    QString title;
    QString shareTitle; ///< heading of the shares
    QString note;       ///< what to improve first; may be empty
    FigureAxis x;
    std::vector<Bar> bars;
    std::vector<BarLine> lines = {};
    std::optional<DotLegend> dots = {};

    bool operator==(const BarFigure &) const = default;
};

/// Distribution of the values of a simulation: `counts` in equal intervals of `width` from `from` on, in the
/// unit of the axis; width 0: all values are equal.
struct HistogramFigure {
    QString title; ///< "Distribution of A in 120 000 trials"
    FigureAxis x;
    double from = 0;
    double width = 0;
    std::vector<long long> counts;
    Interval coverage;    ///< contains 95.45 % of the values
    double evaluated = 0; ///< from the readings themselves
    double mean = 0;      ///< of the simulated values
    QString evaluatedText;
    QString meanText;
    QString coverageText;

    bool operator==(const HistogramFigure &) const = default;
};

/// Mark of a test in a trend: before or after an adjustment, neither stated, or from a series that cannot be
/// compared with the first.
enum class TrendMark { asFound, asLeft, noRole, otherSeries };

/// Value of one day with its U; x in calendar years.
struct TrendValue {
    double x = 0;
    double y = 0;
    std::optional<double> expanded = {}; ///< half the length of the error bar
    TrendMark mark = TrendMark::asFound;
    bool exceeds = false; ///< clearly exceeds its limit

    bool operator==(const TrendValue &) const = default;
};

/// An intervention on the machine.
struct TrendIntervention {
    double x = 0;
    QString name;
    std::optional<QPointF> found = {}; ///< of an adjustment: values before and after
    std::optional<QPointF> left = {};

    bool operator==(const TrendIntervention &) const = default;
};

/// Signs that the legend of trends explains.
enum class TrendSign { asFound, asLeft, otherSeries, limit, line, intervention, noRole };

struct TrendLegendEntry {
    TrendSign sign = TrendSign::asFound;
    QString text;

    bool operator==(const TrendLegendEntry &) const = default;
};

/// Trend of a parameter over the years, in calendar years and the displayed unit.
struct TrendPanel {
    QString symbol;
    QString unitName;     ///< "µm", "arc second": in its head
    QString statement;    ///< "not before March 2028"
    bool isFirst = false; ///< of a page: to be watched first
    FigureAxis x;
    FigureAxis y;
    std::vector<TrendValue> values;
    std::vector<std::vector<QPointF>> joined; ///< polylines of one role between two interventions
    std::vector<std::vector<QPointF>> limits; ///< steps
    std::vector<TrendIntervention> interventions;
    std::vector<BandPoint> band; ///< 95 % band of the line
    std::vector<QPointF> line;   ///< solid, up to today
    std::vector<QPointF> later;  ///< dashed, after today
    std::optional<QPointF> notBefore = {};
    double today = 0;

    bool operator==(const TrendPanel &) const = default;
};

/// Trends side by side, of one axis or plane; a single one is drawn with its names and legend.
struct TrendFigure {
    QString title;
    QString label = {}; ///< row label: "X"
    QString note = {};  ///< below the label: "1 000 mm"
    std::vector<TrendPanel> panels;
    std::vector<TrendLegendEntry> legend = {};

    bool operator==(const TrendFigure &) const = default;
};

/// Anything that can be drawn: content in the displayed units and language, roles instead of colours.
using Figure = std::variant<CurveFigure, CircleFigure, LineFigure, BarFigure, HistogramFigure, TrendFigure>;

} // namespace palmer
