// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <optional>
#include <vector>

namespace palmer {

/// Reading of one run at the target, in the unit of the axis.
struct StripReading {
    double value = 0;
    std::size_t run = 0;  ///< index in the measurement
    bool isAside = false; ///< shown, but in no statistic

    bool operator==(const StripReading &) const = default;
};

/// Readings of one direction in the order of measurement, with x̄ and x̄ ± c·s if they exist.
struct StripLane {
    CurveRole role = CurveRole::up;
    std::vector<StripReading> readings;
    std::optional<double> mean;
    std::optional<double> lower;
    std::optional<double> upper;

    bool operator==(const StripLane &) const = default;
};

/// All readings of one target on one scale: shows the scatter and the distance of the directions.
struct TargetStrip {
    FigureAxis axis; ///< deviations, horizontally
    std::vector<StripLane> lanes;
    QString reversal; ///< "B −4,48"; may be empty

    bool operator==(const TargetStrip &) const = default;
};

/// Strip of a target (index from 0) of a positioning test, in µm or arc seconds; readings with the correction
/// to 20 °C if it is applied. `evaluation` is that of `test`, which holds a PositioningMeasurement; otherwise
/// throws std::bad_variant_access.
[[nodiscard]] TargetStrip targetStrip(const Test &test, const TestEvaluation &evaluation, std::size_t target,
                                      const Language &language);

} // namespace palmer
