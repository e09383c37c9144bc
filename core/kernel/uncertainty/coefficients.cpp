// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/coefficients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double ofMean(int n) {
    return n >= 1 ? 1.0 / n : infinite;
}

double ofScatter(int n) {
    return n >= 2 ? 1.0 / (n - 1) : infinite;
}

/// Returns `of` for the ruling direction, or the sum over both.
template <double (*of)(int)>
double over(const RulingReadings &end) {
    if (end.approach)
        return of(*end.approach == Direction::positive ? end.positive : end.negative);
    return of(end.positive) + of(end.negative);
}

double bothScatters(const RulingReadings &end) {
    return ofScatter(end.positive) + ofScatter(end.negative);
}

/// (x̄ + c·s) − (x̄ + c·s)'; if both ends have the same target and direction, 2c·s remains.
double limits(const Rulers &r, double c) {
    if (r.sameTarget && r.upper.approach && r.upper.approach == r.lower.approach)
        return 4 * c * c * over<ofScatter>(r.upper);
    return over<ofMean>(r.upper) + over<ofMean>(r.lower) +
           c * c * (over<ofScatter>(r.upper) + over<ofScatter>(r.lower));
}

/// x̄ − x̄'.
double means(const Rulers &r, double) {
    return over<ofMean>(r.upper) + over<ofMean>(r.lower);
}

/// x̄_i − x̄_j, each the mean of the means of both directions.
double meansOfBoth(const Rulers &r, double) {
    return (over<ofMean>(r.upper) + over<ofMean>(r.lower)) / 4;
}

/// c·s↑ + c·s↓ + |B|, or 2c·s if one direction rules.
double repeatability(const Rulers &r, double c) {
    if (r.upper.approach)
        return 4 * c * c * over<ofScatter>(r.upper);
    return over<ofMean>(r.upper) + c * c * over<ofScatter>(r.upper);
}

/// Mean of R_i↑ or R_i↓ over the targets, on the safe side: as if one target and direction ruled.
double meanRepeatability(const Rulers &r, double c) {
    return 4 * c * c * std::max(ofScatter(r.upper.positive), ofScatter(r.upper.negative));
}

/// x̄↑ − x̄↓.
double reversal(const Rulers &r, double) {
    return over<ofMean>(r.upper);
}

/// c·(s↑ + s↓).
double scatterOfBoth(const Rulers &r, double c) {
    return c * c * bothScatters(r.upper);
}

/// (x̄ + c·(s↑ + s↓)/2) − (x̄ + c·(s↑ + s↓)/2)' (VDI), with the largest and smallest mean x̄ of a target; if
/// both ends have the same target, c·(s↑ + s↓) of the scatter remains.
double vdiLimits(const Rulers &r, double c) {
    const double scatters =
        r.sameTarget ? bothScatters(r.upper) : (bothScatters(r.upper) + bothScatters(r.lower)) / 4;
    return over<ofMean>(r.upper) + over<ofMean>(r.lower) + c * c * scatters;
}

// clang-format off
constexpr std::array table{
    //            id        S
    Coefficients{"A",      true,  limits},
    Coefficients{"A+",     true,  limits},
    Coefficients{"A-",     true,  limits},
    Coefficients{"E",      true,  means},
    Coefficients{"E+",     true,  means},
    Coefficients{"E-",     true,  means},
    Coefficients{"M",      true,  meansOfBoth},
    Coefficients{"R",      false, repeatability},
    Coefficients{"R+",     false, repeatability},
    Coefficients{"R-",     false, repeatability},
    Coefficients{"UPR",    false, repeatability},
    Coefficients{"r",      false, meanRepeatability},
    Coefficients{"r+",     false, meanRepeatability},
    Coefficients{"r-",     false, meanRepeatability},
    Coefficients{"B",      false, reversal},
    Coefficients{"Bmean",  false, reversal}, // safe side
    Coefficients{"P",      true,  vdiLimits},
    Coefficients{"Pa",     true,  meansOfBoth},
    Coefficients{"Psmax",  false, scatterOfBoth},
    Coefficients{"Psmean", false, scatterOfBoth}, // safe side
    Coefficients{"Umax",   false, reversal},
    Coefficients{"Umean",  false, reversal}, // safe side
};
// clang-format on

} // namespace

const Coefficients *coefficients(std::string_view id) {
    const auto found = std::ranges::find(table, id, [](const Coefficients &row) { return row.id; });
    return found == table.end() ? nullptr : &*found;
}

std::optional<double> combined(const Coefficients &row, double systematic, double environmental,
                               const Rulers &rulers, double c) {
    const double factor = row.ofEnvironment(rulers, c);
    if (!std::isfinite(factor))
        return std::nullopt;
    const double s = row.systematic ? systematic : 0;
    return std::sqrt(s * s + factor * environmental * environmental);
}

} // namespace palmer
