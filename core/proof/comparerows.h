// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/comparewords.h"

namespace palmer {

/// A result or verdict as printed in a line of a report, which may contain more.
struct PrintedRow {
    QString label;      ///< symbol ("R↑", "G(b)XY"), or subject of the verdict
    QStringList values; ///< value, U, limit, word of the verdict, as far as present, in this order

    bool operator==(const PrintedRow &) const = default;
};

/// Finds the results that a report made by another version does not print. Lines, pages and words may be
/// arranged differently: a line prints a row if it contains its label followed by its values in order. A
/// difference is a line that prints a row of at least three values with one changed, or a row that is printed
/// in fewer lines than it occurs.
[[nodiscard]] std::vector<Difference> compareRows(const std::vector<PrintedWords> &pages,
                                                  const std::vector<PrintedRow> &rows);

} // namespace palmer
