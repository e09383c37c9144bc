// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/verification.h"

#include <functional>

namespace palmer {

/// A word of a page and its area, points from the top left corner.
struct PrintedWord {
    QString text;
    QRectF area;
};

using PrintedWords = std::vector<PrintedWord>;

/// Differences between the words of a page as printed and as they follow from the data, both in reading
/// order: one per run of differing words, with the words around it. Empty if they are equal.
[[nodiscard]] std::vector<Difference> compareWords(const PrintedWords &printed, const PrintedWords &follows,
                                                   int page);

/// Differences between two result files (JSON), with the path of each value. `sameProgram`: also compare the
/// program name and the bytes. A file that is not JSON is one difference. Numbers that another processor
/// rounds differently (by 10⁻⁹ relative, or 10⁻¹²) are equal.
[[nodiscard]] std::vector<Difference> compareResults(const QByteArray &printed, const QByteArray &follows,
                                                     bool sameProgram);

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
