// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/queries.h"
#include "report/blocks/report.h"

#include <QByteArray>

namespace palmer {

/// A test as one line of JSON: the keys of `evaluate --json` that the register has, and where it stands. What
/// depends on this register alone is not in it: the same files give the same bytes.
[[nodiscard]] QByteArray listedTestJson(const ListedTest &listed);

/// Rows of CSV, one a parameter, for programs: as `evaluate --table csv`, with what tells machines apart.
[[nodiscard]] QByteArray listedTestsCsvHead();
[[nodiscard]] QByteArray listedTestCsv(const ListedTest &listed);

/// Tests of a machine in a table to be read: a row each, with the main results.
[[nodiscard]] Report composeList(const QString &title, const std::vector<ListedTest> &tests,
                                 const Language &language);

/// A result and its U with as many decimals as it prints; a dash where there is none.
struct ShownResult {
    QString value;
    QString uncertainty; ///< empty: none
};
[[nodiscard]] ShownResult shownResult(const RegisteredResult &result, bool angular, const Language &language);

/// The symbol of a result without typography: "G(b)XY", "A↑".
[[nodiscard]] QString plainSymbolOf(const std::string &resultId);

} // namespace palmer
