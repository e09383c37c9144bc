// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"

#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// A piece of a formula. `approach`: the direction the number or symbol belongs to, for who draws in colours.
struct FormulaSpan {
    QString text;
    bool subscript = false;
    bool strong = false; ///< a number put in, a result
    std::optional<Direction> approach = std::nullopt;

    bool operator==(const FormulaSpan &) const = default;
};

/// One line of a formula.
struct Formula {
    std::vector<FormulaSpan> spans;

    /// Without typography: "R11 = max(2·1,85 + …)".
    [[nodiscard]] QString plain() const;

    bool operator==(const Formula &) const = default;
};

/// A formula from its source: "_" sets the letters and digits after it (or what stands in braces) lower.
[[nodiscard]] Formula formulaFrom(const QString &source);

/// What stands lower behind a symbol: "i", "XY", "max,XY".
[[nodiscard]] QString lowerPart(const Symbol &symbol, const std::string &index);

/// A symbol as a formula: "R↑", "x̄" with a lower "i" and "↑".
[[nodiscard]] Formula symbolFormula(const Symbol &symbol, const std::string &index = {});

} // namespace palmer
