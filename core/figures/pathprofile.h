// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <optional>
#include <vector>

namespace palmer {

/// Subject of a circle figure, which decides the centre.
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
    std::vector<std::size_t> source;      ///< of each point: its index in the arc; rising
    bool ordered = true;                  ///< the angles never turn back
    std::optional<double> sampleInterval; ///< s
    bool synthetic = false;               ///< computed from sources of a diagnosis, not measured
    std::optional<int> layer = {};        ///< index of the test in a figure of several tests

    /// True if the results are computed from this path.
    [[nodiscard]] bool isEvaluated() const { return !repetition && !synthetic; }
    [[nodiscard]] TracePoint operator[](std::size_t i) const { return {angles[i], deviations[i]}; }

    bool operator==(const PathProfile &) const = default;
};

/// Reduces a profile for drawing: the first, least, greatest and last point of every `step` degrees, in the
/// order of measurement, extremes exact; all points if a step has fewer. Steps follow the largest angle
/// reached so far, so that a point that falls back does not reopen one. Only steps that overlap `visible`
/// (degrees, at most 360, modulo full turns) are kept, plus one on either side; null: all. step > 0.
[[nodiscard]] std::vector<CircleTrace> decimated(const PathProfile &profile, double step,
                                                 std::optional<Interval> visible = std::nullopt);

} // namespace palmer
