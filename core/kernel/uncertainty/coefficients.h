#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace palmer {

/// How the contributions combine to the U of a parameter of ISO 230-2 (GUM, after the model of ISO 230-2:2006
/// Annex A): with c the factor of s and n the runs of the ruling target,
///     U² = (systematic ? S² : 0) + (ofMeans/n + ofScatter·c²/(n − 1))·U_EVE²,
/// S² the squares of all contributions but that of the environmental variation. Derived: a mean of n readings
/// has 1/√n of the uncertainty of one, s has 1/√(n − 1), and both are uncorrelated.
struct Coefficients {
    const char *id;
    bool systematic;
    double ofMeans;
    double ofScatter;
};

/// The one table of them.
[[nodiscard]] std::span<const Coefficients> coefficientTable();

/// The row of a parameter; null for an id that is none. `oneDirectionRules`: R is as large as it is because
/// of R_i↑ or R_i↓, not of both together with B_i.
[[nodiscard]] const Coefficients *coefficients(std::string_view id, bool oneDirectionRules = false);

/// U from S, U_EVE (both k = 2, one unit), n ≥ 1 and c. Null where s is needed and n < 2.
[[nodiscard]] std::optional<double> combined(const Coefficients &row, double systematic, double environmental,
                                             int n, double c);

} // namespace palmer
