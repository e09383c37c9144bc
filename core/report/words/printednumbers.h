// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/evaluation/parameter.h"
#include "language/language.h"

#include <QString>
#include <optional>

namespace palmer {

/// The numbers of a result as printed in every table and sentence: value and U with the same decimals, the
/// limit as entered. Value or U gets more digits if needed for the printed numbers, compared by the decision
/// rule with its printed factor, to give the verdict of the unrounded ones. With a simulated U the rule
/// compares with U + 2s, s that of U.
struct PrintedNumbers {
    int decimals = 1;            ///< of the value, in the default unit
    int uncertaintyDecimals = 1; ///< of U, in the default unit
    QString value;               ///< may be empty, like all of the following
    QString uncertainty;         ///< empty without a value
    QString limit;               ///< as entered
    QString reach; ///< end of the guard band beyond the limit: limit + g, for a lower limit limit − g
};

[[nodiscard]] PrintedNumbers printedNumbers(const Parameter &parameter, const DecisionRule &rule,
                                            std::optional<double> resolution, const Language &language,
                                            Rounding rounding = Rounding::palmer);

/// Uses the decision rule of the test, its finest instrument and the rounding of the report.
[[nodiscard]] PrintedNumbers printedNumbers(const Parameter &parameter, const Test &test,
                                            const Document &document, const Language &language);

/// Joins a printed number (see above) and its unit as in the language.
[[nodiscard]] QString withUnit(const QString &number, Quantity quantity, const Language &language);

/// Prints a positive number with at most `digits` significant digits and `finest` decimals, but never as 0:
/// "<0.01" if it is below the last decimal.
[[nodiscard]] QString significant(double size, int digits, int finest, const Language &language);

/// "limit of F" if the limit belongs to another parameter; otherwise empty.
[[nodiscard]] QString limitNote(const Parameter &parameter, const Language &language);

} // namespace palmer
