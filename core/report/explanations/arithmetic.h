// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringView>
#include <vector>

namespace palmer {

/// Value of a printed calculation, for finding the digits it must be printed with.
struct Calculation {
    double value = 0;
    std::vector<double> terms; ///< summands, or candidates of max or min
    bool isGrouped = false;    ///< each term is a calculation: in brackets, or a candidate
};

/// Evaluates numbers with a decimal point, + − · / ( ) |…| max(a; b) min(a; b), as used by the formulas of
/// explanations. Stops at anything else.
[[nodiscard]] Calculation calculated(QStringView text);

} // namespace palmer
