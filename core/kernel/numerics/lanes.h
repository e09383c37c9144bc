// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>

namespace palmer {

/// Four doubles processed in parallel, to evaluate a formula for four cases at once: per lane the operators
/// do what they do for a double, to the last bit. Uses 16-byte registers, which every processor of the
/// supported architectures has. `larger`, `smaller`, `magnitude`, `squareRoot` and `isMissing` also exist for
/// double, so that one template serves both.
class Lanes {
public:
    using Pair = double __attribute__((vector_size(16)));
    static constexpr int count = 4;

    Lanes() = default;
    Lanes(double value) // NOLINT(google-explicit-constructor): a constant of a formula is the same in all
        : m_low{value, value}
        , m_high{value, value} {}
    Lanes(Pair low, Pair high)
        : m_low(low)
        , m_high(high) {}

    [[nodiscard]] double operator[](int lane) const {
        return lane < 2 ? m_low[lane] : m_high[lane - 2]; // NOLINT: subscripts of vector registers
    }
    [[nodiscard]] std::array<double, count> values() const {
        return {m_low[0], m_low[1], m_high[0], m_high[1]};
    }
    static Lanes from(const std::array<double, count> &values) { return from(values.data()); }
    /// Loads four consecutive doubles.
    static Lanes from(const double *values) {
        return {Pair{values[0], values[1]}, Pair{values[2], values[3]}};
    }

    void store(double *values) const {
        values[0] = m_low[0];
        values[1] = m_low[1];
        values[2] = m_high[0];
        values[3] = m_high[1];
    }

    Lanes &operator+=(const Lanes &b) { return *this = *this + b; }
    friend Lanes operator+(const Lanes &a, const Lanes &b) {
        return {a.m_low + b.m_low, a.m_high + b.m_high};
    }
    friend Lanes operator-(const Lanes &a, const Lanes &b) {
        return {a.m_low - b.m_low, a.m_high - b.m_high};
    }
    friend Lanes operator*(const Lanes &a, const Lanes &b) {
        return {a.m_low * b.m_low, a.m_high * b.m_high};
    }
    friend Lanes operator/(const Lanes &a, const Lanes &b) {
        return {a.m_low / b.m_low, a.m_high / b.m_high};
    }
    friend Lanes larger(const Lanes &a, const Lanes &b) {
        return {a.m_low > b.m_low ? a.m_low : b.m_low, a.m_high > b.m_high ? a.m_high : b.m_high};
    }
    friend Lanes smaller(const Lanes &a, const Lanes &b) {
        return {a.m_low < b.m_low ? a.m_low : b.m_low, a.m_high < b.m_high ? a.m_high : b.m_high};
    }
    friend Lanes magnitude(const Lanes &a) { return {withoutSign(a.m_low), withoutSign(a.m_high)}; }
    friend Lanes squareRoot(const Lanes &a) { return {root(a.m_low), root(a.m_high)}; }

    /// True if the reading is missing in the first lane, and thus in all.
    friend bool isMissing(const Lanes &a) { return std::isnan(a.m_low[0]); }

    /// Converts one 32-bit integer per lane to double.
    using Integers = std::int32_t __attribute__((vector_size(16)));
    static Lanes of(Integers integers) {
        const Eigen::Array4i all(integers[0], integers[1], integers[2], integers[3]);
        const Eigen::Array4d values = all.cast<double>();
        return from(values.data());
    }

private:
    static Pair withoutSign(Pair a) {
        using Bits = std::int64_t __attribute__((vector_size(16)));
        constexpr std::int64_t allButSign = 0x7fffffffffffffff;
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the same bits, of vectors
        return reinterpret_cast<Pair>(reinterpret_cast<Bits>(a) & Bits{allButSign, allButSign});
    }
    static Pair root(Pair a) {
        const Eigen::Array2d roots = Eigen::Array2d(a[0], a[1]).sqrt();
        return Pair{roots[0], roots[1]};
    }

    Pair m_low{};
    Pair m_high{};
};

inline double larger(double a, double b) {
    return a > b ? a : b;
}
inline double smaller(double a, double b) {
    return a < b ? a : b;
}
inline double magnitude(double a) {
    return std::abs(a);
}
inline double squareRoot(double a) {
    return std::sqrt(a);
}
inline bool isMissing(double a) {
    return std::isnan(a);
}

} // namespace palmer
