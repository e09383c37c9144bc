// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/layouts/tablereading.h"
#include "import/remark.h"
#include "kernel/measurement/circular.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palmer {

/// Settles the common properties of circular tests: plane, feed, calibrated length, correction to 20 °C,
/// edition. `plane`, `feed`: from the file, or empty.
void resolveCircle(CircularMeasurement &measurement, std::string &edition, std::string_view plane,
                   std::optional<double> feed, Choices &choices, Remarks &remarks);

/// True for words of the choice "layout" that describe points of a circle.
[[nodiscard]] bool isLayoutOfCircles(std::string_view word);

/// Columns of positions along two axes, in the order of the plane.
using AxisColumns = std::pair<std::size_t, std::size_t>;

/// The columns of a table of circles.
struct CircleColumns : LineConditions {
    std::optional<std::size_t> first;     ///< angles or x; null: radial deviations alone
    std::vector<std::size_t> seconds;     ///< radii, radial deviations or y
    std::vector<std::size_t> firsts;      ///< that of each of them; empty: all have the same one
    std::optional<std::size_t> third;     ///< y of nominal points, whose polar angles are those of deviations
    std::optional<AxisColumns> commanded; ///< positions of the programmed path of x and y
    std::optional<std::size_t> senses;    ///< the sense of each line
    std::optional<std::size_t> runs;      ///< the number of the path of each line
    std::string layout;                   ///< a word of the choice

    [[nodiscard]] std::optional<std::size_t> firstOf(std::size_t second) const {
        const auto place = static_cast<std::size_t>(std::ranges::find(seconds, second) - seconds.begin());
        return place < firsts.size() ? std::optional(firsts[place]) : first;
    }
};

/// Columns named after two axes that move: coordinates, otherwise actual or commanded positions.
[[nodiscard]] std::optional<AxisColumns> axisColumns(const TableReading &reading);
/// True if a column could hold positions of the axis that its heading names.
[[nodiscard]] bool isPosition(const TableColumn &column);
/// The sense of the path in a column: the chosen one, otherwise that of its heading.
[[nodiscard]] std::optional<Sense> senseOfColumn(const TableReading &reading, std::size_t column);

/// Settles the roles of the columns and the layout, each with its question. Throws Error for columns that
/// make no circle.
[[nodiscard]] CircleColumns circleColumns(TableReading &reading);
[[noreturn]] void refuseCircleColumns();
/// Keeps the lines and paths of one test where the table has several: other planes, feeds, days, machines, or
/// as found and as left, each with its question.
void keepOneTest(TableReading &reading, CircleColumns &columns);

/// The radius or radial deviation of a line in a column, mm, as it is read.
using RadialOf = std::function<std::optional<double>(std::uint32_t row, std::size_t column)>;
/// Asks for radii and deviations that are not read unless they say the same; the other columns are listed.
void askForUnread(TableReading &reading, const CircleColumns &columns, const RadialOf &radial);

/// Notes the number of paths and points.
void remarkPaths(const CircularMeasurement &measurement, Remarks &remarks);

/// Angles made continuous: no step beyond 180°.
void unwrap(std::vector<double> &degrees);

/// The sense in which a path's angles run.
[[nodiscard]] Sense senseOf(const std::vector<double> &unwrapped);

} // namespace palmer
