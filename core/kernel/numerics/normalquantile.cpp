// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/normalquantile.h"

#include "kernel/numerics/normalquantilecoefficients.h"

#include <array>
#include <cmath>

namespace palmer {

namespace {

using namespace normalquantile;

/// For |p − ½| ≤ 0.425; q = p − ½.
template <class Value>
Value central(const Value &q) {
    const Value r = centreHalfWidth * centreHalfWidth - q * q;
    return q * polynomial(centreAbove, r) / polynomial(centreBelow, r);
}

/// For all other p; `p` is the smaller of p and 1 − p, the result has no sign.
double outer(double p) {
    constexpr double border = 5;
    const double r = std::sqrt(-std::log(p));
    if (r <= border)
        return polynomial(middleAbove, r - middleOffset) / polynomial(middleBelow, r - middleOffset);
    return polynomial(tailAbove, r - border) / polynomial(tailBelow, r - border);
}

} // namespace

double normalQuantile(double p) {
    const double q = p - 0.5;
    if (std::abs(q) <= centreHalfWidth)
        return central(q);
    return std::copysign(outer(q < 0 ? p : 1 - p), q);
}

Lanes normalQuantileOfSymmetric(const Lanes &q) {
    const Lanes half = q / 2;
    const Lanes all = central(half);
    std::array<double, Lanes::count> values = all.values();
    for (int lane = 0; lane < Lanes::count; ++lane) {
        const double at = half[lane];
        if (std::abs(at) > centreHalfWidth)
            values[static_cast<std::size_t>(lane)] = std::copysign(outer(0.5 - std::abs(at)), at);
    }
    return Lanes::from(values);
}

} // namespace palmer
