#pragma once

#include <QString>
#include <optional>
#include <variant>
#include <vector>

namespace palmer {

/// Whose values a part of a figure shows: the approach in the positive (↑) or negative (↓) direction, or the
/// mean of both. What it looks like on screen and paper is the business of who draws.
enum class CurveRole { up, down, mean };

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

    bool operator==(const Dimension &) const = default;
};

/// What stands before a text of the legend.
enum class LegendSample { up, down, mean, readings };

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

/// Curves over positions: the picture of a positioning test.
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

    bool operator==(const CurveFigure &) const = default;
};

/// What can be drawn: content in the units and the language it is shown in, roles instead of colours.
using Figure = std::variant<CurveFigure>;

} // namespace palmer
