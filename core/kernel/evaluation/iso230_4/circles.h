// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"

#include <functional>
#include <vector>

namespace palmer::iso230_4 {

/// Identifies the circles about the path of a sense.
[[nodiscard]] constexpr CircleOf circleOf(Sense sense) {
    return sense == Sense::counterclockwise ? CircleOf::counterclockwise : CircleOf::clockwise;
}

/// True if both senses were measured: a pair of paths, each with enough points for its own circles. A result
/// from one path and a few points of the other would really be that of the one path.
[[nodiscard]] bool bothMeasured(const std::vector<EvaluatedPath> &paths);

/// Returns the minimum zone circles and the least squares circle of each path and, for a pair, of both (each
/// path with equal weight). Circles that do not exist (too few points, collinear) are left out.
[[nodiscard]] std::vector<CircleResult> circles(const std::vector<EvaluatedPath> &paths);

/// Returns the circle of that kind about one path, or null.
[[nodiscard]] std::optional<CircleResult> circleOfPath(const EvaluatedPath &path, ReferenceCircle kind);

/// Returns only the circles selected by `wanted`.
[[nodiscard]] std::vector<CircleResult>
circles(const std::vector<EvaluatedPath> &paths,
        const std::function<bool(CircleOf of, ReferenceCircle kind)> &wanted);

} // namespace palmer::iso230_4
