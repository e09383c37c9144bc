// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/measurement/circular.h"
#include "tables/choice.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// What the columns of a table of points are.
enum class ArcContent {
    angleDeviation, ///< angle and radial deviation
    angleRadius,    ///< angle and distance from the centre
    xy,             ///< coordinates of the plane
    deviations,     ///< radial deviations alone, at equal steps of the angle
};

/// What is known of a table of points before it is read; what is left open is recognised or guessed, each
/// guess with a remark.
struct ArcTableChoices {
    std::optional<ArcContent> content;
    std::optional<DecimalMark> decimalMark;
    std::optional<std::string> unit; ///< of radii, deviations, coordinates: "um", "mm" … (import/units.h)
    std::optional<Sense> sense;      ///< of all paths; null: as the angles run (deviations: counterclockwise)
    AngleReference angleReference = AngleReference::polar;
    double startAngle = 0; ///< degrees, of deviations without angles
    double arc = 360;      ///< degrees from the first point to the last, of deviations without angles
    ImportOptions answers; ///< to further questions, by their id
};

/// The paths of a table, with what was understood and assumed.
struct ArcTable {
    std::vector<Arc> arcs;
    std::size_t points = 0;
    Choice<ArcContent> content;
    Choice<DecimalMark> decimalMark;
    Choice<std::string> unit;
    std::vector<Question> questions; ///< to be answered before the paths are taken, as of an imported file
    std::vector<Remark> remarks;
};

/// Reads paths typed or copied from a spreadsheet, as the import of tables does (headings, units, several
/// columns of paths, a path there and back), for a circle of that plane and nominal radius. A single column
/// of numbers is deviations: n of them stand at start ± i·arc/(n − 1). A stated sense the angles contradict
/// turns the order of the points. Throws Error with line and column where there are no points.
[[nodiscard]] ArcTable readArcTable(const std::string &text, const CircularMeasurement &circle,
                                    const ArcTableChoices &choices);

} // namespace palmer
