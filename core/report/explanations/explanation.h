// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/words/formula.h"

#include <QStringList>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace palmer {

/// What a parameter is made of at each target, for a picture of bars: the quantity its rule looks at.
struct TargetBars {
    Formula title;                             ///< "R_i"
    QString unit;                              ///< of the labels
    std::vector<std::optional<double>> values; ///< by index of the target; mm, rotary: degrees
    std::vector<QString> labels;               ///< of the values
    std::optional<std::size_t> ruling;         ///< index of the target that rules
};

/// A measured point that rules a circular result.
struct RulingPoint {
    QString path;      ///< "XY"
    double angle = 0;  ///< degrees from the first axis towards the second, −180 … 180
    bool outer = true; ///< farthest from the centre; else nearest to it

    bool operator==(const RulingPoint &) const = default;
};

/// Where a parameter comes from, in one language.
struct Explanation {
    QString id; ///< of the parameter
    Formula symbol;
    QString name;                    ///< the edition's term
    Formula formula;                 ///< in symbols
    std::vector<Formula> steps;      ///< with the numbers of this test put in; the last ends in the result
    QStringList words;               ///< sentences: what rules it, what weighs, what to know
    QString result;                  ///< "R = 10,26 µm"; empty without a value
    QString source;                  ///< "ISO 230-2:2006, 2.17 and 2.19"
    std::vector<Ruling> ruling;      ///< targets (from 1) and directions that rule it
    std::vector<RulingPoint> points; ///< of a circular test: those that rule it
    std::optional<TargetBars> bars;
};

/// Explains a parameter of a positioning test: how the edition computes it and how it follows from the
/// statistics of the test; of a circular test, from its circles. The result reads as everywhere
/// (printednumbers.h); what is put in is shown as statistics per target are (one digit more than the
/// readings), or with the digits of the result where it has more. All is computed unrounded. Without a value
/// there are no steps, and the words say why. Nothing where the test has no such parameter. `id` as in
/// parameterId.
[[nodiscard]] std::optional<Explanation> explanation(const EvaluatedDocument &evaluated, std::size_t test,
                                                     std::string_view id, const Language &language);

/// The formula of a parameter in symbols, with the factor of the edition: what the help prints. Empty for a
/// row without explanation.
[[nodiscard]] Formula formulaOf(const Edition &edition, const Row &row, const Language &language);

} // namespace palmer
