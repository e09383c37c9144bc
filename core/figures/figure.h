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

/// Whose values a part of a figure shows: the approach in the positive (↑) or negative (↓) direction, the
/// mean of both, or readings at rest. What it looks like on screen and paper is the business of who draws.
enum class CurveRole { up, down, mean, drift };

/// A place in a figure, in the units its axes show.
struct FigurePoint {
    double x = 0;
    double y = 0;
    int target = 0; ///< counted from 1

    bool operator==(const FigurePoint &) const = default;
};

/// Means of targets that follow one another without a gap; a gap begins another curve.
struct Curve {
    CurveRole role = CurveRole::mean;
    std::vector<FigurePoint> points;

    bool operator==(const Curve &) const = default;
};

/// Lower and upper limit of a target, x̄ ± c·s.
struct BandPoint {
    double x = 0;
    double lower = 0;
    double upper = 0;

    bool operator==(const BandPoint &) const = default;
};

/// Limits of targets that follow one another without a gap; a single one is drawn as a whisker.
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

/// Where a dimension stands: in a row beside the plot, or left or right of its own target, in the order
/// given.
enum class DimensionPlace { gutter, leftOfTarget, rightOfTarget };

/// A parameter shown as a dimension between two values (upper ≥ lower), with leaders from the places that
/// rule it.
struct Dimension {
    QString label; ///< the symbol: "A", "R↑"
    QString id;    ///< of the parameter
    double lower = 0;
    double upper = 0;
    double lowerPosition = 0; ///< x where the leader of the lower value starts
    double upperPosition = 0;
    DimensionPlace place = DimensionPlace::gutter;
    QString subscript = {}; ///< of the label: "VE"
    /// What is agreed for it, from the lower value on, and the guard band on either side; without those that
    /// lie beyond what the axis shows.
    std::optional<double> limit = {};
    std::optional<double> guard = {};
    QString limitText = {}; ///< "32 µm"

    bool operator==(const Dimension &) const = default;
};

/// What stands before a text of the legend.
enum class LegendSample { up, down, mean, readings, drift, limit };

struct LegendEntry {
    LegendSample sample = LegendSample::mean;
    QString text;
    bool band = false; ///< the sample shows a band below its line

    bool operator==(const LegendEntry &) const = default;
};

struct Tick {
    double value = 0;
    QString label; ///< as the language writes the number, minus as −

    bool operator==(const Tick &) const = default;
};

/// An axis of a figure: its range and its round ticks (1-2-5; positions also 2.5, angles 15-30-45-60-90), all
/// of which lie in the range.
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

/// Curves over positions or, of a drift test, over time.
struct CurveFigure {
    QString title;
    FigureAxis x;
    FigureAxis y;
    std::vector<Band> bands;
    std::vector<Curve> curves;
    std::vector<ReadingMark> readings;
    std::vector<Dimension> dimensions; ///< those of the gutter from the plot outwards
    std::vector<LegendEntry> legend;
    std::vector<double> positions; ///< of all targets, ascending
    QString note = {};             ///< which limits lie beyond what the axis shows; empty: none

    bool operator==(const CurveFigure &) const = default;
};

/// What a line of a line figure shows; what that looks like is the business of who draws.
enum class LineRole {
    measuredUp,
    measuredDown,
    predictedUp,
    predictedDown,
    machine,
    instrument,
    air,
    counterclockwise,
    clockwise
};

struct FigureLine {
    LineRole role = LineRole::machine;
    QString label; ///< short, at the right end of the line; may be empty
    QString name;  ///< of the legend
    std::vector<QPointF> points;

    bool operator==(const FigureLine &) const = default;
};

/// Lines over one axis: temperatures over time, means before and after a compensation, what a diagnosis
/// leaves over the angle. An axis without quantity has no title, lines without names no legend.
struct LineFigure {
    QString title;
    FigureAxis x;
    FigureAxis y;
    std::vector<FigureLine> lines;

    bool operator==(const LineFigure &) const = default;
};

/// A point of a path about the centre the figure names: angle in degrees from the first axis towards the
/// second, unwrapped; deviation in µm.
struct TracePoint {
    double angle = 0;
    double deviation = 0;

    bool operator==(const TracePoint &) const = default;
};

/// Points of a path that follow one another: all of them, or first, least, greatest, last of each step of
/// the angle, in the order of measurement. A path that leaves the view and comes back is several traces.
struct CircleTrace {
    Sense sense = Sense::counterclockwise;
    bool repetition = false;
    std::vector<TracePoint> points;
    bool synthetic = false;   ///< what sources of a diagnosis make, not measured
    std::optional<int> layer; ///< of several tests over one another: which, from 0

    bool operator==(const CircleTrace &) const = default;
};

/// A place of a path that is marked.
struct TraceMark {
    Sense sense = Sense::counterclockwise;
    TracePoint at;

    bool operator==(const TraceMark &) const = default;
};

/// A point that rules a result: it touches the outer or the inner circle, or is Fmax or Fmin.
struct ContactMark {
    TraceMark mark;
    bool outer = true;

    bool operator==(const ContactMark &) const = default;
};

/// In which sense a path runs, and its index ("XY").
struct SenseArrow {
    Sense sense = Sense::counterclockwise;
    QString index;

    bool operator==(const SenseArrow &) const = default;
};

/// The circles about the named centre that enclose the paths, and what is between them: G or G(b).
struct CircleEnvelope {
    QString label;               ///< "G(b)"
    QString subscript;           ///< "f" of feedback signals
    QString id;                  ///< of the parameter: "G(b)_XY"
    double inner = 0;            ///< deviation, µm
    double outer = 0;            ///< outer ≥ inner
    bool dimension = true;       ///< the distance of the two is the result; else they are Fmin and Fmax
    std::optional<double> limit; ///< width, µm; drawn beside the dimension
    std::optional<double> guard; ///< guard band about that width, µm
    QString limitLabel;          ///< "limit of G(b): 30 µm"

    bool operator==(const CircleEnvelope &) const = default;
};

/// A circle about the nominal one: a division of the scale, or a limit of F.
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
    continued ///< the text goes on
};

struct CircleLegendEntry {
    CircleLegendSample sample = CircleLegendSample::nominal;
    QString text;
    int layer = 0;

    bool operator==(const CircleLegendEntry &) const = default;
};

/// The part of a circle figure in view: what stands in the middle (mm of the figure as a whole, y upwards,
/// from the centre of the circles) and how many times it is enlarged.
struct CircleView {
    double x = 0;
    double y = 0;
    double zoom = 1;

    bool operator==(const CircleView &) const = default;
};

/// Paths with their deviations magnified about the nominal circle: the picture of a circular test. A
/// deviation d (µm) is drawn at plotRadius + magnification·d/1000 mm from the centre.
struct CircleFigure {
    QString title;   ///< "Actual paths": what is drawn
    QString centre;  ///< "about the centre of the minimum zone of G(b)"
    QString caption; ///< "magnification 1 000:1, 5 µm per division"
    QString ratio;   ///< "1 000:1"
    QString firstAxis;
    QString secondAxis;
    QSizeF size;          ///< of the drawing, mm
    double keyHeight = 0; ///< of the legend below it on paper, mm; what is printed is that much higher
    int keyColumns = 3;
    double figureRadius = 0; ///< nothing that deviates is drawn farther out, mm
    QPointF home; ///< what stands in the middle of the whole figure, mm from the centre of the circles
    std::optional<Interval> sector = {}; ///< degrees: the figure shows this part of the circles alone
    double plotRadius = 0;               ///< of the nominal circle, mm
    double magnification = 1;            ///< 1, 2 or 5 times a power of ten
    double division = 0;                 ///< between rings, the length of the scale bar, µm
    QString divisionLabel;               ///< "5 µm"
    double pointStep = 0;                ///< of the traces, mm of the drawing
    CircleView view;
    std::vector<DeviationCircle> rings; ///< ascending; of the whole figure 0 among them
    std::vector<CircleTrace> traces;
    std::vector<TraceMark> starts;
    std::vector<ContactMark> contacts;
    std::vector<SenseArrow> arrows;
    std::optional<CircleEnvelope> envelope;
    std::vector<DeviationCircle> limits; ///< of F
    std::vector<CircleLegendEntry> legend;

    /// Distance from the centre at which a deviation (µm) is drawn, mm.
    [[nodiscard]] double radius(double deviation) const {
        return plotRadius + magnification * deviation / 1000;
    }

    bool operator==(const CircleFigure &) const = default;
};

/// A line of a bar figure: its name at the left, its size as a bar from 0, its numbers at the right.
struct Bar {
    QString id;
    QString name;
    QString subscript;  ///< at the end of the name
    double size = 0;    ///< in the unit of the axis, not negative
    QString value;      ///< "3.60"; a dash where there is none
    QString share;      ///< "54 %", likewise
    bool first = false; ///< what is to be improved first

    bool operator==(const Bar &) const = default;
};

/// Bars below each other on one scale from 0: the contributions to an uncertainty, the largest first.
struct BarFigure {
    QString title;
    QString shareTitle; ///< head of the shares
    QString note;       ///< what is to be improved first; empty: nothing stands out
    FigureAxis x;
    std::vector<Bar> bars;

    bool operator==(const BarFigure &) const = default;
};

/// How often a simulation gave which values: `counts` in equal intervals of `width` from `from` on, in the
/// unit of the axis; width 0: all values are alike.
struct HistogramFigure {
    QString title; ///< "Distribution of A in 120 000 trials"
    FigureAxis x;
    double from = 0;
    double width = 0;
    std::vector<long long> counts;
    Interval coverage;    ///< holds 95.45 % of the values
    double evaluated = 0; ///< from the readings as they are
    double mean = 0;      ///< of the values
    QString evaluatedText;
    QString meanText;
    QString coverageText;

    bool operator==(const HistogramFigure &) const = default;
};

/// How a test of a trend is marked: before or after an adjustment, or neither stated, or of a series that
/// cannot be compared with the first.
enum class TrendMark { asFound, asLeft, noRole, otherSeries };

/// A value with its U at a day; x in calendar years.
struct TrendValue {
    double x = 0;
    double y = 0;
    std::optional<double> expanded = {}; ///< half the length of the bar
    TrendMark mark = TrendMark::asFound;
    bool exceeds = false; ///< clearly over its limit

    bool operator==(const TrendValue &) const = default;
};

/// Something was done to the machine.
struct TrendIntervention {
    double x = 0;
    QString name;
    std::optional<QPointF> found = {}; ///< of an adjustment the values before and after
    std::optional<QPointF> left = {};

    bool operator==(const TrendIntervention &) const = default;
};

/// How a parameter moved over the years, in calendar years and the unit it is shown in.
struct TrendPanel {
    QString symbol;
    QString statement;    ///< "not before March 2028"
    bool isFirst = false; ///< of a page: what is to be watched first
    FigureAxis x;
    FigureAxis y;
    std::vector<TrendValue> values;
    std::vector<std::vector<QPointF>> joined; ///< neighbours of one role between two interventions
    std::vector<std::vector<QPointF>> limits; ///< steps
    std::vector<TrendIntervention> interventions;
    std::vector<BandPoint> band; ///< of the line, 95 %
    std::vector<QPointF> line;   ///< solid up to today
    std::vector<QPointF> later;  ///< dashed
    std::optional<QPointF> notBefore = {};
    double today = 0;

    bool operator==(const TrendPanel &) const = default;
};

/// Trends side by side, of one axis or plane; one alone is drawn with its names and legend.
struct TrendFigure {
    QString title;
    QString label = {}; ///< of the row: "X"
    QString note = {};  ///< below it: "1 000 mm"
    std::vector<TrendPanel> panels;
    std::vector<QString> legend =
        {}; ///< as found, as left, other series, limit, line, intervention, no role; empty: none

    bool operator==(const TrendFigure &) const = default;
};

/// What can be drawn: content in the units and the language it is shown in, roles instead of colours.
using Figure = std::variant<CurveFigure, CircleFigure, LineFigure, BarFigure, HistogramFigure, TrendFigure>;

} // namespace palmer
