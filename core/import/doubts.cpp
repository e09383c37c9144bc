// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/question.h"

#include "tables/contenterror.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr double largestLength = 1;  // mm
constexpr double largestAngle = 0.1; // °
constexpr double largestRatio = 100; // of the spread of a run to that of the others

struct ReadingRange {
    std::size_t readings = 0;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    [[nodiscard]] double farthest() const {
        return readings > 0 ? std::max(std::abs(low), std::abs(high)) : 0;
    }
    [[nodiscard]] double spread() const { return readings > 1 ? high - low : 0; }
};

ReadingRange rangeOf(const Run &run) {
    ReadingRange range;
    for (const auto &value : run.deviations) {
        if (!value)
            continue;
        ++range.readings;
        range.low = std::min(range.low, *value);
        range.high = std::max(range.high, *value);
    }
    return range;
}

void questionSize(double largest, bool angular, Remarks &remarks) {
    if (largest > (angular ? largestAngle : largestLength))
        remarks.problem(
            "large", REPORT_TEXT("report", "Deviations up to %1: are unit, content and decimal mark right?"),
            Number{largest, angular ? Quantity::angle : Quantity::position, 2});
}

bool equalTargets(const PositioningMeasurement &measurement, const Run &run) {
    std::size_t readings = 0;
    bool same = true;
    bool opposite = true;
    for (std::size_t i = 0; i < run.deviations.size(); ++i) {
        if (!run.deviations[i])
            continue;
        if (!same && !opposite)
            return false;
        // In any unit: 100 µm at 100 mm.
        const double value = *run.deviations[i];
        const auto equals = [&](double target) {
            return value == target || value == target / 1000 || std::abs(value * 3600 - target) < 1e-9;
        };
        same &= equals(measurement.targets[i]);
        opposite &= equals(-measurement.targets[i]);
        ++readings;
    }
    return readings > 2 && (same || opposite);
}

void question(const PositioningMeasurement &measurement, Remarks &remarks) {
    std::vector<double> spreads;
    double largest = 0;
    for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
        const ReadingRange range = rangeOf(measurement.runs[j]);
        largest = std::max(largest, range.farthest());
        spreads.push_back(range.spread());
        if (range.readings > 1 && range.farthest() == 0)
            remarks.problem("zeros",
                            REPORT_TEXT("report", "All readings of run %1 are zero: was it measured at all?"),
                            counted(j + 1));
        else if (equalTargets(measurement, measurement.runs[j]))
            remarks.problem(
                "equalsTargets",
                REPORT_TEXT("report", "The deviations of run %1 equal the targets: is it a run at all?"),
                counted(j + 1));
    }
    questionSize(largest, measurement.axis.motion == Motion::rotary, remarks);
    std::vector<double> sorted = spreads;
    std::ranges::sort(sorted);
    const double usual = sorted.size() > 1 ? sorted[(sorted.size() - 1) / 2] : 0;
    for (std::size_t j = 0; j < spreads.size() && usual > 0; ++j) {
        if (spreads[j] > largestRatio * usual)
            remarks.problem("spread",
                            REPORT_TEXT("report", "Run %1 spreads a "
                                                  "hundred times as far as the others: is it one of them?"),
                            counted(j + 1));
    }
}

void questionValues(const std::vector<double> &values, bool angular, Remarks &remarks) {
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    if (values.size() > 1 && largest == 0)
        remarks.problem("zeros",
                        REPORT_TEXT("report", "All readings are zero: was anything measured at all?"));
    questionSize(largest, angular, remarks);
}

void question(const CircularMeasurement &measurement, Remarks &remarks) {
    std::vector<double> values;
    for (const Arc &arc : measurement.arcs)
        values.insert(values.end(), arc.radialDeviations.begin(), arc.radialDeviations.end());
    questionValues(values, false, remarks);
}

void question(const DriftMeasurement &measurement, Remarks &remarks) {
    questionValues(measurement.deviations, measurement.axis.motion == Motion::rotary, remarks);
}

} // namespace

void questionNumbers(const Test &test, Remarks &remarks) {
    std::visit([&](const auto &measurement) { question(measurement, remarks); }, test.measurement);
}

} // namespace palmer
