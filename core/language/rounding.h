// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/quantity.h"
#include "language/units.h"

#include <optional>
#include <string>

namespace palmer {

/// The only way from a stored number to the digits shown.
///
/// Meaning: the shortest decimal that reads back as the stored double, with its point shifted into the unit
/// shown for the quantity. All rounding is done on these digits, half to even, so 0.00125 mm is 1.2 µm
/// although no double is exactly 0.00125. Degrees are multiplied to arc seconds, not shifted: of the product
/// only the 15 digits that a double holds reliably are kept.
/// Validity: every double. NaN and infinities print as "nan", "inf", "-inf" and are ordered like the doubles
/// compared with zero; no result hides them.
class Decimal {
public:
    /// Represents value · 10^shift.
    explicit Decimal(double value, int shift = 0);
    /// Converts a number in the base unit of its quantity to the unit shown.
    Decimal(double value, Quantity quantity);
    /// The same for a unit chosen by the user.
    Decimal(double value, const ShownUnit &unit);

    /// Returns the number rounded half to even with exactly `decimals` decimals (< 0: the shortest form).
    /// Point ".", sign "-", no grouping; "-0" never appears.
    [[nodiscard]] std::string rounded(int decimals) const;
    /// For an expanded uncertainty: like rounded(), but up if rounding down would lose more than 5 %.
    [[nodiscard]] std::string roundedUncertainty(int decimals) const;
    /// Returns all digits; with an exponent ("1.5e300") from 1e21 and below 1e-6.
    [[nodiscard]] std::string shortest() const;

    /// Order of the exact decimals.
    friend bool operator<(const Decimal &a, const Decimal &b);
    bool operator==(const Decimal &) const = default;

private:
    friend int decimalsOfTwoDigits(double expanded, Quantity quantity);
    friend int decimalsWithUncertainty(double expanded, Quantity quantity, std::optional<double> resolution);

    void read(const char *begin, const char *end, int shift);
    [[nodiscard]] Decimal roundedTo(int decimals) const;
    [[nodiscard]] Decimal uncertaintyTo(int decimals) const;
    [[nodiscard]] std::string fixed(int decimals) const;
    void addUnit(int decimals); // away from zero, in the last place shown

    bool m_negative = false;
    bool m_finite = true;
    int m_point = 0;      // the number is 0.m_digits · 10^m_point
    std::string m_digits; // neither leading nor trailing zeros; empty for zero; "inf", "nan"
};

/// Returns the decimals for a result and its expanded uncertainty, both in the base unit of `quantity`: two
/// significant digits of U, not finer than the resolution of the instrument (the last place shown is not
/// smaller than it), and, with priority over both, not coarser than 0.1 µm (0.1″). At most 4. A U that is
/// zero, negative or not finite is ignored: 1, as without U.
[[nodiscard]] int decimalsWithUncertainty(double expanded, Quantity quantity,
                                          std::optional<double> resolution = std::nullopt);

/// Returns the decimals for a result and its expanded uncertainty that leave U two significant digits, above
/// 99 more: from 0 to 4.
[[nodiscard]] int decimalsOfTwoDigits(double expanded, Quantity quantity);

/// Returns the decimals for a limit, in the default unit of the quantity: as entered. Only digits that a
/// double holds reliably count, so that a limit converted from another unit is not shown as
/// 1.0000000000000002.
[[nodiscard]] int limitDecimals(double limit, Quantity quantity, const DisplayUnits &units = {});

/// Decimals for a result without U: 0.1 µm (0.1″).
inline constexpr int decimalsWithoutUncertainty = 1;

} // namespace palmer
