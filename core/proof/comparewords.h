// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/verification.h"

#include <functional>

namespace palmer {

/// A word of a page and where it stands, points from the top left corner.
struct PrintedWord {
    QString text;
    QRectF area;
};

using PrintedWords = std::vector<PrintedWord>;

/// What differs between the words of a page as printed and as they follow, both in the order of reading:
/// each run of other words is one difference, with the words around it. None: the words are the same.
[[nodiscard]] std::vector<Difference> compareWords(const PrintedWords &printed, const PrintedWords &follows,
                                                   int page);

/// What differs between two files of results (JSON), with the path of each value. `sameProgram`: the
/// program's own name counts as a value, and so do the bytes. A file that is no JSON is one difference.
/// Numbers that another processor rounds otherwise (by 10⁻⁹ of themselves, or 10⁻¹²) are the same.
[[nodiscard]] std::vector<Difference> compareResults(const QByteArray &printed, const QByteArray &follows,
                                                     bool sameProgram);

} // namespace palmer
