// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/remark.h"
#include "kernel/measurement/circular.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

class TableReading;

/// Settles the common properties of circular tests: plane, feed, calibrated length, correction to 20 °C,
/// edition. `plane`, `feed`: from the file, or empty.
void resolveCircle(CircularMeasurement &measurement, std::string &edition, std::string_view plane,
                   std::optional<double> feed, Choices &choices, Remarks &remarks);

/// True for words of the choice "layout" that describe points of a circle.
[[nodiscard]] bool isLayoutOfCircles(std::string_view word);

/// The columns of a table of circles.
struct CircleColumns {
    std::optional<std::size_t> first;  ///< angles or x; null: radial deviations alone
    std::vector<std::size_t> seconds;  ///< radii, radial deviations or y
    std::optional<std::size_t> third;  ///< y of nominal points, whose polar angles are those of deviations
    std::optional<std::size_t> senses; ///< the sense of each line
    std::optional<std::size_t> runs;   ///< the number of the path of each line
    std::string layout;                ///< a word of the choice
    bool isSure = false;               ///< neither asked nor chosen
};

/// Settles the roles of the columns and the layout, each with its question. Throws Error for columns that
/// make no circle.
[[nodiscard]] CircleColumns circleColumns(TableReading &reading);
[[noreturn]] void refuseCircleColumns();

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
