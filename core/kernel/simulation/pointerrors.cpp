// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/pointerrors.h"

#include "kernel/numerics/normalquantilecoefficients.h"
#include "kernel/numerics/wideregisters.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace palmer {

namespace {

constexpr std::size_t pointsPerStep = 8;
constexpr std::size_t placesPerStep = 4;
constexpr std::size_t tile = 256; ///< points processed together: small enough for the L1 cache
constexpr std::size_t places = tile / 2;
using Tile = std::array<double, tile>;

/// Returns −ln p of a normal number p > 0: the library's cannot be vectorised and differs between systems.
/// Reduction and coefficients of fdlibm (Sun Microsystems 1993): error below one unit in the last place.
[[gnu::always_inline]] inline double minusLogarithm(double p) {
    // p = m·2^k with m about 1, in integer arithmetic: a branch would prevent vectorisation.
    constexpr std::uint64_t rootOfHalf = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t exponents = 0xfff0000000000000;
    constexpr std::uint64_t bias = 1023ULL << 52;
    constexpr std::uint64_t asDouble = 0x4330000000000000; // 2⁵² + the low bits
    const auto bits = std::bit_cast<std::uint64_t>(p);
    const std::uint64_t above = bits - rootOfHalf;
    const double k = std::bit_cast<double>(((above + bias) >> 52) | asDouble) - (0x1p52 + 1023);
    const double f = std::bit_cast<double>(bits - (above & exponents)) - 1;
    const double s = f / (2 + f);
    const double z = s * s;
    const double w = z * z;
    const double even =
        w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
    const double odd =
        z * (6.666666666666735130e-01 +
             w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
    const double half = 0.5 * f * f;
    constexpr double ln2High = 6.93147180369123816490e-01;
    constexpr double ln2Low = 1.90821492927058770002e-10;
    return ((half - (s * (half + (even + odd)) + k * ln2Low)) - f) - k * ln2High;
}

/// The normal deviates of (1 + q)/2: the central formula for all, then the outer 15 % again, gathered so that
/// they are vectorised, too. 32-bit words never reach the last branch of the algorithm.
[[gnu::always_inline]] inline void normals(const Tile &q, Tile &z) {
    using namespace normalquantile;
    for (std::size_t i = 0; i < tile; ++i) {
        const double half = q[i] / 2;
        const double r = centreHalfWidth * centreHalfWidth - half * half;
        z[i] = half * polynomial(centreAbove, r) / polynomial(centreBelow, r);
    }
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what is read is written before
    std::array<std::uint32_t, tile + 1> outer;
    std::size_t count = 0;
    for (std::size_t i = 0; i < tile; ++i) {
        outer[count] = static_cast<std::uint32_t>(i);
        count += std::abs(q[i]) > 2 * centreHalfWidth ? 1 : 0;
    }
    constexpr std::size_t together = 16;
    const std::size_t padded = (count + together - 1) / together * together;
    Tile p;
    for (std::size_t k = 0; k < count; ++k)
        p[k] = 0.5 - std::abs(q[outer[k]] / 2);
    for (std::size_t k = count; k < padded; ++k)
        p[k] = 0.0625;
    for (std::size_t from = 0; from < padded; from += together) {
        for (std::size_t k = from; k < from + together; ++k) {
            const double r = __builtin_sqrt(minusLogarithm(p[k])) - middleOffset;
            p[k] = polynomial(middleAbove, r) / polynomial(middleBelow, r);
        }
    }
    for (std::size_t k = 0; k < count; ++k)
        z[outer[k]] = std::copysign(p[k], q[outer[k]]);
}

/// Converts two words per counter to numbers: the first four points of every step, then its last four.
[[gnu::always_inline]] inline void symmetric(const std::uint32_t *first, const std::uint32_t *second,
                                             Tile &q) {
    for (std::size_t step = 0; step < tile / pointsPerStep; ++step) {
        for (std::size_t k = 0; k < placesPerStep; ++k) {
            q[step * pointsPerStep + k] = RandomDraws::symmetric(first[step * placesPerStep + k]);
            q[step * pointsPerStep + placesPerStep + k] =
                RandomDraws::symmetric(second[step * placesPerStep + k]);
        }
    }
}

/// Plain loops, so that the compiler can vectorise them for the function they are inlined into.
[[gnu::always_inline]] inline void draw(const RandomDraws &draws, long long trial, std::uint32_t place,
                                        const PointErrors &errors, std::span<double> into) {
    std::uint32_t words[4][places]; // NOLINT(modernize-avoid-c-arrays): as fillPlaces takes it
    Tile q;
    Tile z;
    for (std::size_t from = 0; from < into.size(); from += tile, place += places) {
        draws.fillPlaces<places>(trial, place, words);
        Tile e{};
        if (errors.resolution > 0) {
            symmetric(words[2], words[3], q);
            for (std::size_t i = 0; i < tile; ++i)
                e[i] = errors.resolution / 2 * q[i];
        }
        if (errors.noise > 0) {
            symmetric(words[0], words[1], q);
            normals(q, z);
            for (std::size_t i = 0; i < tile; ++i)
                e[i] += errors.noise * z[i];
        }
        const std::size_t count = std::min(tile, into.size() - from);
        std::copy_n(e.begin(), count, into.begin() + static_cast<std::ptrdiff_t>(from));
    }
}

} // namespace

std::uint32_t placesOfPoints(std::size_t points) {
    return static_cast<std::uint32_t>((points / pointsPerStep + 1) * placesPerStep);
}

void drawPointErrorsNarrow(const RandomDraws &draws, long long trial, std::uint32_t place,
                           const PointErrors &errors, std::span<double> into) {
    draw(draws, trial, place, errors, into);
}

void drawPointErrors(const RandomDraws &draws, long long trial, std::uint32_t place,
                     const PointErrors &errors, std::span<double> into) {
    inAvailableRegisters([&](auto)
                             __attribute__((always_inline)) { draw(draws, trial, place, errors, into); });
}

} // namespace palmer
