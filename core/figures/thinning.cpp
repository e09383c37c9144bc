// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/thinning.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace palmer {

namespace {

constexpr std::size_t mostPoints = 4000; ///< per kind, in an ordinary figure
constexpr std::size_t stepsOfCurves = 400;
constexpr std::size_t stepsOfLimits = 120; ///< four edges and three areas are drawn from them
/// Lines between many gaps are drawn one by one, most of them as the marker of a single target.
constexpr std::size_t fewLines = 500;
constexpr std::size_t partOfMany = 6;    ///< divisor of the steps
constexpr std::size_t mostPlaces = 2500; ///< of marks
/// Grid rows for telling marks apart, with twice as many columns: the first without too many marks is used.
constexpr std::array rowsOfMarks{160, 112, 80, 56, 40, 28, 20};

template <class Line>
std::size_t pointsOf(const std::vector<Line> &lines, CurveRole role) {
    std::size_t count = 0;
    for (const Line &line : lines)
        count += line.role == role ? line.points.size() : 0;
    return count;
}

template <class Line>
bool areOrdinary(const std::vector<Line> &lines) {
    constexpr std::array roles{CurveRole::up, CurveRole::down, CurveRole::mean, CurveRole::drift};
    return std::ranges::all_of(roles, [&](CurveRole role) { return pointsOf(lines, role) <= mostPoints; });
}

/// Points of all lines of one role, joined across gaps.
template <class Line>
auto inARow(const std::vector<Line> &lines, CurveRole role) {
    std::vector<const typename decltype(Line::points)::value_type *> row;
    row.reserve(pointsOf(lines, role));
    for (const Line &line : lines) {
        if (line.role != role)
            continue;
        for (const auto &point : line.points)
            row.push_back(&point);
    }
    return row;
}

template <class Line>
std::size_t stepsFor(const std::vector<Line> &lines, std::size_t steps) {
    return lines.size() <= fewLines ? steps : steps / partOfMany;
}

/// Sorted positions without duplicates.
std::vector<double> sorted(std::vector<double> positions) {
    std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
}

std::vector<double> positionsOfDimensions(const CurveFigure &figure) {
    std::vector<double> positions;
    for (const Dimension &dimension : figure.dimensions)
        positions.insert(positions.end(), {dimension.lowerPosition, dimension.upperPosition});
    return positions;
}

/// Lines reduced to the points that `keeps` accepts; a line with any also keeps its ends, so that none
/// shrinks to a point.
template <class Line>
std::vector<Line> keeping(const std::vector<Line> &lines, auto &&keeps) {
    std::vector<Line> result;
    for (const Line &line : lines) {
        Line kept{line.role, {}};
        bool inside = false;
        for (const auto &point : line.points) {
            const bool keep = keeps(line.role, point);
            inside |= keep;
            if (keep || &point == &line.points.front() || &point == &line.points.back())
                kept.points.push_back(point);
        }
        if (inside)
            result.push_back(std::move(kept));
    }
    return result;
}

std::vector<Curve> thinnedCurves(const CurveFigure &figure) {
    std::vector<const FigurePoint *> kept;
    const std::vector<double> ruling = sorted(positionsOfDimensions(figure));
    const std::size_t steps = stepsFor(figure.curves, stepsOfCurves);
    for (const CurveRole role : {CurveRole::up, CurveRole::down, CurveRole::mean, CurveRole::drift}) {
        const auto row = inARow(figure.curves, role);
        for (const std::size_t place : thinnedPlaces(
                 row.size(), figure.x.from, figure.x.to, steps, [&](std::size_t i) { return row[i]->x; },
                 [&](std::size_t i) { return row[i]->y; }))
            kept.push_back(row[place]);
    }
    std::ranges::sort(kept);
    return keeping(figure.curves, [&](CurveRole, const FigurePoint &point) {
        return std::ranges::binary_search(kept, &point) || std::ranges::binary_search(ruling, point.x);
    });
}

/// Uses the same positions in both directions: the corners of their overlap are those of the figure.
std::vector<Band> thinnedBands(const CurveFigure &figure) {
    std::vector<double> positions = positionsOfDimensions(figure);
    const std::size_t steps = stepsFor(figure.bands, stepsOfLimits);
    for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
        const auto row = inARow(figure.bands, role);
        const auto x = [&](std::size_t i) { return row[i]->x; };
        for (double BandPoint::*limit : {&BandPoint::lower, &BandPoint::upper}) {
            const auto y = [&](std::size_t i) { return row[i]->*limit; };
            for (const std::size_t place : thinnedPlaces(row.size(), figure.x.from, figure.x.to, steps, x, y))
                positions.push_back(x(place));
        }
    }
    positions = sorted(std::move(positions));
    return keeping(figure.bands, [&](CurveRole, const BandPoint &point) {
        return std::ranges::binary_search(positions, point.x);
    });
}

/// Grid of equal cells for marks.
class Places {
public:
    Places(const CurveFigure &figure, int rows)
        : m_figure(figure)
        , m_rows(static_cast<std::size_t>(rows))
        , m_columns(2 * m_rows) {}

    [[nodiscard]] std::size_t count() const { return 2 * m_rows * m_columns; }
    [[nodiscard]] std::size_t columns() const { return 2 * m_columns; }

    /// Column of a mark, separate per direction; null if the mark is outside the axes.
    [[nodiscard]] std::optional<std::size_t> column(const ReadingMark &mark) const {
        const FigureAxis &x = m_figure.x;
        const FigureAxis &y = m_figure.y;
        if (!(mark.x >= x.from && mark.x <= x.to && mark.y >= y.from && mark.y <= y.to))
            return {};
        return 2 * step(mark.x, x, m_columns) + (mark.role == CurveRole::up ? 0 : 1);
    }
    [[nodiscard]] std::size_t place(const ReadingMark &mark, std::size_t column) const {
        return column * m_rows + step(mark.y, m_figure.y, m_rows);
    }

private:
    static std::size_t step(double value, const FigureAxis &axis, std::size_t steps) {
        const double part = (value - axis.from) / (axis.to - axis.from) * static_cast<double>(steps);
        return std::min(static_cast<std::size_t>(std::max(part, 0.0)), steps - 1);
    }

    const CurveFigure &m_figure;
    std::size_t m_rows;
    std::size_t m_columns;
};

/// Index of the first mark in each cell; null if more than `most`.
std::optional<std::vector<std::size_t>> firstInEachPlace(const CurveFigure &figure, const Places &places,
                                                         std::size_t most) {
    std::vector<bool> taken(places.count());
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < figure.readings.size(); ++i) {
        const auto column = places.column(figure.readings[i]);
        if (!column)
            continue;
        const std::size_t place = places.place(figure.readings[i], *column);
        if (taken[place])
            continue;
        if (kept.size() == most)
            return {};
        taken[place] = true;
        kept.push_back(i);
    }
    return kept;
}

/// Adds the indices of the least and greatest mark of each column.
void addExtremes(std::vector<std::size_t> &kept, const CurveFigure &figure, const Places &places) {
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    std::vector<std::array<std::size_t, 2>> extremes(places.columns(), {none, none});
    for (std::size_t i = 0; i < figure.readings.size(); ++i) {
        const auto column = places.column(figure.readings[i]);
        if (!column)
            continue;
        auto &[least, greatest] = extremes[*column];
        least = least == none || figure.readings[i].y < figure.readings[least].y ? i : least;
        greatest = greatest == none || figure.readings[i].y > figure.readings[greatest].y ? i : greatest;
    }
    for (const auto &[least, greatest] : extremes) {
        if (least != none)
            kept.insert(kept.end(), {least, greatest});
    }
}

std::vector<ReadingMark> thinnedReadings(const CurveFigure &figure) {
    std::optional<std::vector<std::size_t>> kept;
    for (const int rows : rowsOfMarks) {
        const Places places(figure, rows);
        const bool last = rows == rowsOfMarks.back();
        kept = firstInEachPlace(figure, places, last ? places.count() : mostPlaces);
        if (!kept)
            continue;
        addExtremes(*kept, figure, places);
        break;
    }
    std::ranges::sort(*kept);
    kept->erase(std::unique(kept->begin(), kept->end()), kept->end());
    std::vector<ReadingMark> marks;
    marks.reserve(kept->size());
    for (const std::size_t i : *kept)
        marks.push_back(figure.readings[i]);
    return marks;
}

} // namespace

bool isOrdinary(const CurveFigure &figure) {
    return figure.readings.size() <= mostPoints && areOrdinary(figure.curves) && areOrdinary(figure.bands);
}

CurveFigure thinned(const CurveFigure &figure) {
    CurveFigure result;
    result.title = figure.title;
    result.x = figure.x;
    result.y = figure.y;
    result.bands = areOrdinary(figure.bands) ? figure.bands : thinnedBands(figure);
    result.curves = areOrdinary(figure.curves) ? figure.curves : thinnedCurves(figure);
    result.readings = figure.readings.size() <= mostPoints ? figure.readings : thinnedReadings(figure);
    result.dimensions = figure.dimensions;
    result.legend = figure.legend;
    result.positions = figure.positions;
    result.note = figure.note;
    return result;
}

} // namespace palmer
