// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/evaluation/parameter.h"
#include "language/language.h"

#include <QString>
#include <optional>

namespace palmer {

/// The numbers of a result as every table and sentence prints them: value and U with the same decimals, the
/// limit as entered. Of value and U the one or the other has more digits where it takes them for the printed
/// numbers, compared by the decision rule with its factor as printed, to give the verdict that the unrounded
/// ones give. Of a simulated U the rule compares with U + 2s, s that of U.
struct PrintedNumbers {
    int decimals = 1;            ///< of the value, counted in the default unit
    int uncertaintyDecimals = 1; ///< likewise of U
    QString value;               ///< empty where there is none, as below
    QString uncertainty;         ///< likewise without a value
    QString limit;               ///< as entered
    QString alignedLimit;        ///< filled up to the decimals of the value
    QString reach; ///< the end of the guard band beyond the limit: limit + g, of a lower limit limit − g
};

[[nodiscard]] PrintedNumbers printedNumbers(const Parameter &parameter, const DecisionRule &rule,
                                            std::optional<double> resolution, const Language &language);

/// By the rule of its test and the finest of its instruments.
[[nodiscard]] PrintedNumbers printedNumbers(const Parameter &parameter, const Test &test,
                                            const Document &document, const Language &language);

/// A number that is printed (of the above) and its unit, joined as the language does.
[[nodiscard]] QString withUnit(const QString &number, Quantity quantity, const Language &language);

/// `decimals` of the above alone, counted in the default unit of the quantity. `resolution`: the finest of
/// the instruments (mm, rotary: degrees).
[[nodiscard]] int parameterDecimals(const Parameter &parameter, const DecisionRule &rule,
                                    std::optional<double> resolution, const DisplayUnits &units = {});

/// A size of the arithmetic, above 0: no more than `digits` significant digits and `mostDecimals` decimals,
/// and never 0: "<0.01" for what is smaller than the last of them.
[[nodiscard]] QString significant(double size, int digits, int finest, const Language &language);

/// "limit of F" where the limit is not that of the parameter itself; else nothing.
[[nodiscard]] QString limitNote(const Parameter &parameter, const Language &language);

} // namespace palmer
