// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace palmer {

/// The statement of an upper tolerance limit: at least `content` of all values lie below it, and a limit made
/// this way is right with probability `confidence`. Both in (0, 1).
struct Tolerance {
    double content = 0.95;
    double confidence = 0.95;

    bool operator==(const Tolerance &) const = default;
};

/// Returns k of the one-sided tolerance limit mean + k·s of `count` ≥ 2 normal values:
/// k = t'_γ(count − 1; z_p·√count)/√count, t' the quantile of the noncentral t distribution (Boost.Math).
[[nodiscard]] double toleranceFactor(std::size_t count, const Tolerance &tolerance);

} // namespace palmer
