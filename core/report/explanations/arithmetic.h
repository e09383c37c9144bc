// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringView>
#include <vector>

namespace palmer {

/// The value of a printed calculation. It tells how many digits the calculation has to be printed with.
struct Calculation {
    double value = 0;
    std::vector<double> terms; ///< that it is the sum of, or that max or min chooses from
    bool isGrouped = false;    ///< each of them is a calculation: in brackets, or chosen from
};

/// Evaluates numbers with a decimal point, + − · / ( ) |…| max(a; b) min(a; b), which is all that the
/// formulas of explanations use. Stops at anything else.
[[nodiscard]] Calculation calculated(QStringView text);

} // namespace palmer
