// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/comparewords.h"

namespace palmer {

/// A result or verdict as a line of a report prints it, whatever else stands in that line.
struct PrintedRow {
    QString label;      ///< symbol ("R↑", "G(b)XY"), or what the verdict is about
    QStringList values; ///< value, U, limit, word of the verdict; what there is, in this order

    bool operator==(const PrintedRow &) const = default;
};

/// The results that the pages of a report of another version do not print, where lines, pages and words may
/// stand otherwise: a line prints a row when its label and then its values stand there in their order.
/// A difference is each line that prints a row with one of at least three values changed, and each row that
/// fewer lines print than there are such rows.
[[nodiscard]] std::vector<Difference> compareRows(const std::vector<PrintedWords> &pages,
                                                  const std::vector<PrintedRow> &rows);

} // namespace palmer
