// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/quantity.h"
#include "language/units.h"

#include <optional>
#include <string>

namespace palmer {

/// The one way from a stored number to the digits that are shown.
///
/// Meaning: the shortest decimal number that reads back as the stored double, with its point shifted into the
/// unit the quantity is shown in. All rounding is done on these digits, half to even, so 0.00125 mm is 1.2 µm
/// although no double is exactly 0.00125. Degrees become arc seconds by a product, not by a shift: of that
/// product the 15 digits are kept that a double holds for certain.
/// Validity: every double. NaN and infinities print as "nan", "inf", "-inf" and order as the doubles they are
/// would order against zero; no result hides them.
class Decimal {
public:
    /// value · 10^shift.
    explicit Decimal(double value, int shift = 0);
    /// A number in the base unit of its quantity, in the unit it is shown in.
    Decimal(double value, Quantity quantity);
    /// The same in a unit of the user's choice.
    Decimal(double value, const ShownUnit &unit);

    /// Rounded half to even, with exactly `decimals` digits after the point (< 0: the shortest form).
    /// Point ".", sign "-", no grouping; "-0" never appears.
    [[nodiscard]] std::string rounded(int decimals) const;
    /// As an expanded uncertainty: like rounded(), but up where rounding down would lose more than 5 %.
    [[nodiscard]] std::string roundedUncertainty(int decimals) const;
    /// All digits; with an exponent ("1.5e300") from 1e21 on and below 1e-6.
    [[nodiscard]] std::string shortest() const;

    /// Order of the exact decimals.
    friend bool operator<(const Decimal &a, const Decimal &b);
    bool operator==(const Decimal &) const = default;

private:
    friend int decimalsWithUncertainty(double expanded, Quantity quantity, std::optional<double> resolution);

    void read(const char *begin, const char *end, int shift);
    [[nodiscard]] Decimal roundedTo(int decimals) const;
    [[nodiscard]] Decimal uncertaintyTo(int decimals) const;
    [[nodiscard]] std::string fixed(int decimals) const;
    void addUnit(int decimals); // away from zero, of the last place shown

    bool m_negative = false;
    bool m_finite = true;
    int m_point = 0;      // the number is 0.m_digits · 10^m_point
    std::string m_digits; // neither leading nor trailing zeros; empty for zero; "inf", "nan"
};

/// Digits after the point for a result and its expanded uncertainty, both in the base unit of `quantity`:
/// two significant digits of U, not finer than the resolution of the instrument (the last place shown is not
/// smaller than it), and, which goes before both, not coarser than 0.1 µm (0.1″). At most 4.
/// A U that is zero, negative or not finite says nothing: 1, as without U.
[[nodiscard]] int decimalsWithUncertainty(double expanded, Quantity quantity,
                                          std::optional<double> resolution = std::nullopt);

/// Digits after the point for a limit, counted in the default unit of the quantity: as entered. Only the
/// digits count that a double holds for certain, so that a limit which came through another unit is no
/// 1.0000000000000002.
[[nodiscard]] int limitDecimals(double limit, Quantity quantity, const DisplayUnits &units = {});

/// Digits after the point for a result without U: 0.1 µm (0.1″).
inline constexpr int decimalsWithoutUncertainty = 1;

} // namespace palmer
