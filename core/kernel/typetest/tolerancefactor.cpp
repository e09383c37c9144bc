// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/typetest/tolerancefactor.h"

#include "kernel/numerics/normalquantile.h"

#include <boost/math/distributions/non_central_t.hpp>
#include <cmath>

namespace palmer {

double toleranceFactor(std::size_t count, const Tolerance &tolerance) {
    const auto n = static_cast<double>(count);
    const boost::math::non_central_t distribution(n - 1, normalQuantile(tolerance.content) * std::sqrt(n));
    return boost::math::quantile(distribution, tolerance.confidence) / std::sqrt(n);
}

} // namespace palmer
