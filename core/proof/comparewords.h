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

} // namespace palmer
