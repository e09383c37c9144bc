// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <optional>
#include <vector>

namespace palmer {

/// What a circle figure is about, and hence about which centre it is drawn.
enum class CircleSubject {
    circularDeviation, ///< about the centre of G or G(b)
    radialDeviation,   ///< F
};

/// All evaluated points of a path about the centre of a figure, in the order of measurement.
struct PathProfile {
    Sense sense = Sense::counterclockwise;
    std::string index; ///< "XY"
    bool repetition = false;
    std::size_t arc = 0;                  ///< index in the measurement
    std::vector<double> angles;           ///< degrees, unwrapped
    std::vector<double> deviations;       ///< distance from the centre − nominal radius (+ C for F), µm
    std::vector<std::size_t> source;                 ///< of each point: its index in the arc; rising
    bool ordered = true;                  ///< the angles never turn back
    std::optional<double> sampleInterval; ///< s
    bool synthetic = false;               ///< what sources of a diagnosis make, not measured
    std::optional<int> layer = {};        ///< of several tests over one another: which, from 0

    /// Results are of it.
    [[nodiscard]] bool isEvaluated() const { return !repetition && !synthetic; }
    [[nodiscard]] TracePoint operator[](std::size_t i) const { return {angles[i], deviations[i]}; }

    bool operator==(const PathProfile &) const = default;
};

/// The profile as it can be drawn: of every `step` degrees the first, least, greatest and last point, in the
/// order of measurement, extremes exact; all points where fewer than that lie in a step. Steps follow the
/// largest angle reached so far, so that a point that falls back does not open one again. Only steps that
/// overlap `visible` (degrees, at most 360, in any turn) are kept, and one more on either side; none given:
/// all. step > 0.
[[nodiscard]] std::vector<CircleTrace> decimated(const PathProfile &profile, double step,
                                                 std::optional<Interval> visible = std::nullopt);

} // namespace palmer
