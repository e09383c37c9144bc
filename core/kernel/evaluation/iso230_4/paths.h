// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"

#include <optional>
#include <vector>

/// The paths of a circular test: the evaluated parts of the measured arcs (ISO 230-4).
namespace palmer::iso230_4 {

/// Returns the evaluated part of an arc in unwrapped degrees: as stated, otherwise all of it, or the middle
/// 360° of a longer one. Null for an arc without points.
[[nodiscard]] std::optional<Interval> evaluatedRange(const Arc &arc);

/// Returns the axes in the order in which a path of that sense crosses their positive ends (3.8):
/// counterclockwise first second, clockwise second first.
[[nodiscard]] std::string axisIndex(const Plane &plane, Sense sense);

struct Paths {
    std::vector<EvaluatedPath> evaluated; ///< the first of each sense, in the order of measurement
    std::vector<std::size_t> repetitions;
    std::optional<Point> centringError; ///< if an arc has commanded angles, mm
};

/// Returns the paths of a test. Points with polar angles: x = (R + d)·cos θ, y = (R + d)·sin θ. Points with
/// commanded angles are rebuilt from one centring error fitted to all commanded arcs of the test.
[[nodiscard]] Paths paths(const CircularMeasurement &measurement);

/// Returns one arc as evaluated, also a repetition; with commanded angles its points are rebuilt from the
/// centring error of the test.
[[nodiscard]] EvaluatedPath evaluatedPath(const CircularMeasurement &measurement, std::size_t arc,
                                          const std::optional<Point> &centringError);

} // namespace palmer::iso230_4
