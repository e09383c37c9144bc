#include "kernel/uncertainty/coefficients.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

// clang-format off
constexpr std::array table{
    //            id       S      means  scatter
    Coefficients{"A",      true,  2,     2},
    Coefficients{"A+",     true,  2,     2},
    Coefficients{"A-",     true,  2,     2},
    Coefficients{"E",      true,  2,     0},
    Coefficients{"E+",     true,  2,     0},
    Coefficients{"E-",     true,  2,     0},
    Coefficients{"M",      true,  1,     0},
    Coefficients{"R",      false, 2,     2}, // c·s_i↑ + c·s_i↓ + |B_i|
    Coefficients{"R+",     false, 0,     4},
    Coefficients{"R-",     false, 0,     4},
    Coefficients{"UPR",    false, 0,     4},
    Coefficients{"r",      false, 0,     4}, // safe side: as if one target ruled
    Coefficients{"r+",     false, 0,     4},
    Coefficients{"r-",     false, 0,     4},
    Coefficients{"B",      false, 2,     0},
    Coefficients{"Bmean",  false, 2,     0}, // safe side
    Coefficients{"P",      true,  2,     1},
    Coefficients{"Pa",     true,  1,     0},
    Coefficients{"Psmax",  false, 0,     2},
    Coefficients{"Psmean", false, 0,     2}, // safe side
    Coefficients{"Umax",   false, 2,     0},
    Coefficients{"Umean",  false, 2,     0}, // safe side
};
// clang-format on

constexpr std::string_view repeatability = "R";
constexpr std::string_view repeatabilityOfOneDirection = "R+";

} // namespace

std::span<const Coefficients> coefficientTable() {
    return table;
}

const Coefficients *coefficients(std::string_view id, bool oneDirectionRules) {
    if (oneDirectionRules && id == repeatability)
        id = repeatabilityOfOneDirection;
    const auto found = std::ranges::find(table, id, [](const Coefficients &row) { return row.id; });
    return found == table.end() ? nullptr : &*found;
}

std::optional<double> combined(const Coefficients &row, double systematic, double environmental, int n,
                               double c) {
    if (n < 1 || (row.ofScatter > 0 && n < 2))
        return std::nullopt;
    const double scatter = row.ofScatter > 0 ? row.ofScatter * c * c / (n - 1) : 0;
    const double s = row.systematic ? systematic : 0;
    return std::sqrt(s * s + (row.ofMeans / n + scatter) * environmental * environmental);
}

} // namespace palmer
