// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/queries.h"
#include "report/blocks/report.h"

#include <QByteArray>

namespace palmer {

/// Returns a test as one line of JSON: the keys of `evaluate --json` that the register has, and its places.
/// Independent of the register it comes from: the same files give the same bytes.
[[nodiscard]] QByteArray listedTestJson(const ListedTest &listed);

/// CSV rows, one per parameter: like `evaluate --table csv`, plus what is due and, where it was asked for,
/// what has changed since the last test.
[[nodiscard]] QByteArray listedTestsCsvHead(char decimalMark = '.');
[[nodiscard]] QByteArray listedTestCsv(const ListedTest &listed, char decimalMark = '.');

/// Returns what a machine is known by, after its number: "3. Lathe A · Maker · Type · not identified: …".
[[nodiscard]] QString evidenceOf(const ListedMachine &machine, const Language &language);

/// Returns name or type, maker, type and serial number of a machine, as far as stated, each once.
[[nodiscard]] QStringList statedOf(const MachineFields &machine);

/// Returns what was joined with a machine: "joined with 000-018, Lathe B".
[[nodiscard]] QString joinedText(const ListedMachine &machine, const Language &language);

/// Returns a readable table of the tests of a machine: one row each, with the main results.
[[nodiscard]] Report composeList(const QString &title, const std::vector<ListedTest> &tests,
                                 const Language &language);

/// A result and its U with the decimals of the report; a dash if there is none.
struct ShownValue {
    QString value;
    QString uncertainty; ///< empty: none

    /// Returns both: "12.3 ± 0.4".
    [[nodiscard]] QString text() const {
        return uncertainty.isEmpty() ? value : value + QStringLiteral("\u00A0±\u00A0") + uncertainty;
    }
};
[[nodiscard]] ShownValue shownResult(const RegisteredResult &result, bool angular, const Language &language);

/// Returns the symbol of a result without typography: "G(b)XY", "A↑".
[[nodiscard]] QString plainSymbolOf(const std::string &resultId);

} // namespace palmer
