// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/rounding.h"

#include "kernel/numerics/poweroften.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace palmer {
namespace {

constexpr int finestDecimals = 4;   // 0.1 nm: finer than any instrument of these tests
constexpr int coarsestDecimals = 1; // 0.1 µm, 0.1″
constexpr int certainDigits = 15;   // every 15-digit decimal survives conversion to double and back

using Buffer = std::array<char, 32>;

} // namespace

Decimal::Decimal(double value, int shift) {
    Buffer buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
    read(buffer.data(), end, shift);
}

Decimal::Decimal(double value, Quantity quantity)
    : Decimal(value, shownUnit(quantity)) {}

Decimal::Decimal(double value, const ShownUnit &unit)
    : Decimal(value, unit.shift) {
    if (unit.factor == 1)
        return;
    Buffer buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value * unit.factor,
                                   std::chars_format::scientific, certainDigits - 1)
                         .ptr;
    read(buffer.data(), end, 0);
}

void Decimal::read(const char *begin, const char *end, int shift) {
    m_negative = *begin == '-';
    begin += m_negative ? 1 : 0;
    const auto exponentMark = std::find(begin, end, 'e');
    m_finite = exponentMark != end;
    m_digits.assign(begin, exponentMark);
    m_point = 0;
    if (!m_finite) {
        m_negative = m_negative && m_digits == "inf"; // the sign of a NaN is not printed
        return;
    }
    std::erase(m_digits, '.');
    m_digits.erase(m_digits.find_last_not_of('0') + 1);
    if (m_digits.empty()) {
        m_negative = false;
        return;
    }
    int exponent = 0;
    std::from_chars(exponentMark + (exponentMark[1] == '+' ? 2 : 1), end, exponent);
    m_point = exponent + 1 + shift;
}

Decimal Decimal::roundedTo(int decimals) const {
    Decimal result = *this;
    if (!m_finite || decimals < 0)
        return result;
    const int kept = m_point + decimals;
    if (kept >= static_cast<int>(m_digits.size()))
        return result;
    const std::string_view digits = m_digits;
    const auto head = digits.substr(0, static_cast<std::size_t>(std::max(kept, 0)));
    // There are no trailing zeros, so a single "5" is an exact tie and a longer tail is above it.
    const auto tail = digits.substr(head.size());
    const bool odd = !head.empty() && (head.back() - '0') % 2 == 1;
    const bool up = kept >= 0 && (tail.front() > '5' || (tail.front() == '5' && (tail.size() > 1 || odd)));
    result.m_digits.assign(head);
    result.m_digits.erase(result.m_digits.find_last_not_of('0') + 1);
    if (up)
        result.addUnit(decimals);
    else if (result.m_digits.empty())
        result = Decimal(0.0);
    return result;
}

void Decimal::addUnit(int decimals) {
    if (m_digits.empty())
        m_point = -decimals;
    const int kept = m_point + decimals;
    m_digits.resize(static_cast<std::size_t>(kept), '0');
    while (!m_digits.empty() && m_digits.back() == '9')
        m_digits.pop_back();
    if (m_digits.empty()) {
        m_digits = "1";
        ++m_point;
    } else {
        ++m_digits.back();
    }
}

Decimal Decimal::uncertaintyTo(int decimals) const {
    Decimal result = roundedTo(decimals);
    if (!m_finite || decimals < 0)
        return result;
    // 20 r < 19 U is never an equality for decimals that differ by less than half a unit, so doubles decide
    // it safely. The common power of ten is omitted to avoid overflow.
    const auto fraction = [](const Decimal &number, int point) {
        double sum = 0;
        for (auto digit = number.m_digits.rbegin(); digit != number.m_digits.rend(); ++digit)
            sum = (sum + (*digit - '0')) / 10;
        return sum * powerOfTen(number.m_point - point);
    };
    if (result.m_digits.empty() ? !m_digits.empty()
                                : 20 * fraction(result, m_point) < 19 * fraction(*this, m_point)) {
        result.m_negative = m_negative;
        result.addUnit(decimals);
    }
    return result;
}

std::string Decimal::fixed(int decimals) const {
    const std::string sign = m_negative ? "-" : "";
    if (!m_finite)
        return sign + m_digits;
    const auto whole = static_cast<std::size_t>(std::max(m_point, 0));
    std::string number = m_digits.substr(0, whole);
    number.append(whole - number.size(), '0');
    if (number.empty())
        number = "0";
    std::string fraction(static_cast<std::size_t>(std::max(-m_point, 0)), '0');
    if (m_digits.size() > whole)
        fraction += m_digits.substr(whole);
    if (m_digits.empty())
        fraction.clear();
    if (decimals >= 0)
        fraction.resize(static_cast<std::size_t>(decimals), '0');
    return sign + (fraction.empty() ? number : number + '.' + fraction);
}

std::string Decimal::rounded(int decimals) const {
    return decimals < 0 ? shortest() : roundedTo(decimals).fixed(decimals);
}

std::string Decimal::roundedUncertainty(int decimals) const {
    return decimals < 0 ? shortest() : uncertaintyTo(decimals).fixed(decimals);
}

std::string Decimal::shortest() const {
    if (!m_finite || m_digits.empty() || (m_point > -6 && m_point <= 21))
        return fixed(-1);
    Decimal mantissa = *this;
    mantissa.m_point = 1;
    return mantissa.fixed(-1) + 'e' + std::to_string(m_point - 1);
}

bool operator<(const Decimal &a, const Decimal &b) {
    const auto sign = [](const Decimal &number) {
        return number.m_digits.empty() ? 0 : number.m_negative ? -1 : 1;
    };
    if (sign(a) != sign(b))
        return sign(a) < sign(b);
    const auto smaller = [](const Decimal &x, const Decimal &y) {
        if (x.m_finite != y.m_finite)
            return x.m_finite;
        if (x.m_point != y.m_point)
            return x.m_point < y.m_point;
        return x.m_digits < y.m_digits; // no trailing zeros: the order of the fractions
    };
    return a.m_negative ? smaller(b, a) : smaller(a, b);
}

int decimalsOfTwoDigits(double expanded, Quantity quantity) {
    if (!(expanded > 0) || !std::isfinite(expanded))
        return decimalsWithoutUncertainty;
    const Decimal shown(expanded, quantity);
    int decimals = 2 - shown.m_point;
    if (shown.uncertaintyTo(decimals).m_point > shown.m_point) // 0.0996 is 0.10, not 0.100
        --decimals;
    return std::clamp(decimals, 0, finestDecimals);
}

int decimalsWithUncertainty(double expanded, Quantity quantity, std::optional<double> resolution) {
    int decimals = decimalsOfTwoDigits(expanded, quantity);
    if (resolution && *resolution > 0 && std::isfinite(*resolution)) {
        const Decimal step(*resolution, quantity);
        decimals = std::min(decimals, (step.m_digits == "1" ? 1 : 0) - step.m_point);
    }
    return std::max(decimals, coarsestDecimals);
}

int limitDecimals(double limit, Quantity quantity, const DisplayUnits &units) {
    constexpr int mostDecimals = 20;
    const ShownUnit unit = shownUnit(quantity, units);
    const Decimal whole(limit, unit);
    const std::string text = whole.shortest();
    double size = 0;
    std::from_chars(text.data(), text.data() + text.size(), size);
    size = std::abs(size);
    if (!(size > 0) || !std::isfinite(size))
        return 0;
    int certain = certainDigits - 1 - static_cast<int>(std::floor(std::log10(size)));
    if (unit.finest >= 0)
        certain = std::min(certain, unit.finest);
    const std::string digits = whole.rounded(std::clamp(certain, 0, mostDecimals));
    const auto point = digits.find('.');
    const auto last = digits.find_last_not_of('0');
    const int count = point == std::string::npos || last <= point ? 0 : static_cast<int>(last - point);
    return std::max(0, count - unit.decimals);
}

} // namespace palmer
