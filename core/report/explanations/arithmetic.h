// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringView>
#include <vector>

namespace palmer {

/// What a printed calculation comes to, for whoever prints it with digits enough that it does.
struct Calculation {
    double value = 0;
    std::vector<double> terms; ///< that it is the sum of, or that max or min chooses from
    bool isGrouped = false;    ///< each of them is a calculation: in brackets, or chosen from
};

/// Of numbers with a decimal point, + − · / ( ) |…| max(a; b) min(a; b): what formulas of explanations are
/// made of. Anything else ends it.
[[nodiscard]] Calculation calculated(QStringView text);

} // namespace palmer
