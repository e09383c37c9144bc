// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"

#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// A piece of a formula. `approach`: direction of the number or symbol, for renderers with colours.
struct FormulaSpan {
    QString text;
    bool subscript = false;
    bool strong = false; ///< an inserted number or a result
    std::optional<Direction> approach = std::nullopt;

    bool operator==(const FormulaSpan &) const = default;
};

/// One line of a formula.
struct Formula {
    std::vector<FormulaSpan> spans;

    /// Plain text, without typography: "R11 = max(2·1,85 + …)".
    [[nodiscard]] QString plain() const;
    Formula &operator+=(const Formula &other);

    bool operator==(const Formula &) const = default;
};

/// Parses a formula: "_" makes the following letters and digits (or the text in braces) a subscript.
[[nodiscard]] Formula formulaFrom(const QString &source);

/// Subscript of a symbol: "i", "XY", "max,XY".
[[nodiscard]] QString lowerPart(const Symbol &symbol, const std::string &index);

/// A symbol as a formula: "R↑", "x̄" with subscript "i" and "↑".
[[nodiscard]] Formula symbolFormula(const Symbol &symbol, const std::string &index = {});
[[nodiscard]] Formula symbolFormula(const Parameter &parameter);

} // namespace palmer
