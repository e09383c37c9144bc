// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/arctable.h"

#include "editing/pastedtable.h"
#include "kernel/words/shortest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

/// The double of the decimal that was written: a change of unit may miss it by the last bit, which a table
/// that shows all digits would tell.
void tidy(std::vector<double> &values) {
    constexpr double grid = 1e10; // finer than anyone writes millimetres or degrees
    constexpr double lastBits = 4 * std::numeric_limits<double>::epsilon();
    for (double &value : values) {
        const double decimal = std::round(value * grid) / grid;
        if (std::abs(decimal - value) <= lastBits * std::abs(value))
            value = decimal;
    }
}

void giveSense(Arc &arc, Sense sense) {
    if (arc.sense == sense)
        return;
    std::ranges::reverse(arc.angles);
    std::ranges::reverse(arc.radialDeviations);
    arc.sense = sense;
}

} // namespace

ArcTable readArcTable(const std::string &text, const CircularMeasurement &circle,
                      const ImportOptions &answers, std::optional<Sense> sense, const ImportOptions &usual) {
    // The test says already what a file would have to say.
    ImportOptions known{{"kind", "circular"},
                        {"plane", "XY"},
                        {"nominalRadius", shortest(circle.nominalRadius)},
                        {"angleReference", "polar"},
                        {"sign", "actualMinusTarget"}};
    for (const auto &[key, word] : answers)
        known[key] = word;
    Imported imported = readPastedTable(text, known, usual);
    ArcTable result{std::move(std::get<CircularMeasurement>(imported.test->measurement).arcs), 0,
                    std::move(imported.choices), std::move(imported.questions), std::move(imported.remarks)};
    for (Arc &arc : result.arcs) {
        arc.angleReference =
            known["angleReference"] == "commanded" ? AngleReference::commanded : AngleReference::polar;
        tidy(arc.angles);
        tidy(arc.radialDeviations);
        result.points += arc.angles.size();
        if (sense)
            giveSense(arc, *sense);
    }
    return result;
}

} // namespace palmer
