// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"

#include <functional>
#include <vector>

namespace palmer::iso230_4 {

/// The circles about the path of a sense.
[[nodiscard]] constexpr CircleOf circleOf(Sense sense) {
    return sense == Sense::counterclockwise ? CircleOf::counterclockwise : CircleOf::clockwise;
}

/// Both senses were measured: a pair of paths, each of as many points as circles of its own need. A result of
/// both from a path and a few points would be that of the one path.
[[nodiscard]] bool bothMeasured(const std::vector<EvaluatedPath> &paths);

/// The minimum zone circles and the least squares circle of each path and, of a pair, of both together (each
/// path with equal weight). Those that do not exist (too few points, collinear) are left out.
[[nodiscard]] std::vector<CircleResult> circles(const std::vector<EvaluatedPath> &paths);

/// The circle of that kind about one path; null where there is none.
[[nodiscard]] std::optional<CircleResult> circleOfPath(const EvaluatedPath &path, ReferenceCircle kind);

/// Those of them alone that `wanted` asks for.
[[nodiscard]] std::vector<CircleResult>
circles(const std::vector<EvaluatedPath> &paths,
        const std::function<bool(CircleOf of, ReferenceCircle kind)> &wanted);

} // namespace palmer::iso230_4
