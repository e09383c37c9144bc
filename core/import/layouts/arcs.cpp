// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/arcs.h"

#include "import/choices.h"
#include "kernel/measurement/plane.h"
#include "tables/contenterror.h"

#include <cmath>

namespace palmer {

void resolveCircle(CircularMeasurement &measurement, std::string &edition, std::string_view plane,
                   std::optional<double> feed, Choices &choices, Remarks &remarks) {
    const auto settled = choices.resolve("plane", plane.empty() ? "XY" : plane,
                                         plane.empty() ? Origin::guessed : Origin::recognised);
    const std::optional<Plane> named = planeOf(settled.value);
    if (!named)
        refuseContent(
            REPORT_TEXT("report", "the plane cannot be %1; expected two different axes, for example XY"),
            settled.value);
    measurement.plane = *named;
    if (settled.origin == Origin::guessed)
        remarks.assumption("plane",
                           REPORT_TEXT("report", "Plane: nothing in the file says it; taken as XY."));
    if (feed || choices.isChosen("feed")) {
        const double value = choices.resolveNumber("feed", feed.value_or(0), Origin::recognised).value;
        if (value > 0)
            measurement.feed = value;
    }
    const std::optional<bool> stated = measurement.referenceLength.calibrated;
    const auto calibrated = choices.resolve("calibrated",
                                            !stated   ? "not stated"
                                            : *stated ? "yes"
                                                      : "no",
                                            stated ? Origin::recognised : Origin::guessed);
    if (calibrated.value != "not stated")
        measurement.referenceLength.calibrated = calibrated.value == "yes";
    else
        remarks.assumption(
            "calibrated",
            REPORT_TEXT("report", "Whether the length is calibrated is not stated: F and D need it."));
    edition = choices.resolveEdition(Kind::circular);
}

void remarkPaths(const CircularMeasurement &measurement, Remarks &remarks) {
    std::size_t points = 0;
    for (const Arc &arc : measurement.arcs)
        points += arc.angles.size();
    remarks.note({}, REPORT_TEXT("report", "Understood: paths: %1; points: %2."),
                 counted(measurement.arcs.size()), counted(points));
}

void unwrap(std::vector<double> &degrees) {
    double turn = 0;
    double last = degrees.empty() ? 0 : degrees.front();
    for (double &angle : degrees) {
        const double step = angle - last;
        last = angle;
        if (std::abs(step) > 180)
            turn -= 360 * std::round(step / 360);
        angle += turn;
    }
}

Sense senseOf(const std::vector<double> &unwrapped) {
    const bool falls = !unwrapped.empty() && unwrapped.back() < unwrapped.front();
    return falls ? Sense::clockwise : Sense::counterclockwise;
}

} // namespace palmer
