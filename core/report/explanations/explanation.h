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

/// The quantity per target that determines a parameter, for a bar picture.
struct TargetBars {
    Formula title;                             ///< "R_i"
    QString unit;                              ///< unit of the labels
    std::vector<std::optional<double>> values; ///< by target index; mm, rotary: degrees
    std::vector<QString> labels;               ///< the values as text
    std::optional<std::size_t> ruling;         ///< index of the ruling target
};

/// A measured point that rules a circular result.
struct RulingPoint {
    QString path;      ///< "XY"
    double angle = 0;  ///< degrees from the first axis towards the second, −180 … 180
    bool outer = true; ///< farthest from the centre; false: nearest

    bool operator==(const RulingPoint &) const = default;
};

/// Derivation of a parameter, in one language.
struct Explanation {
    QString id; ///< of the parameter
    Formula symbol;
    QString name;                    ///< the edition's term
    Formula formula;                 ///< in symbols
    std::vector<Formula> steps;      ///< with the numbers of this test; the last one ends in the result
    QStringList words;               ///< sentences: what rules it, what weighs, remarks
    QString result;                  ///< "R = 10,26 µm"; empty if there is no value
    QString source;                  ///< "ISO 230-2:2006, 2.17 and 2.19"
    std::vector<Ruling> ruling;      ///< targets (from 1) and directions that rule it
    std::vector<RulingPoint> points; ///< circular tests: points that rule it
    std::optional<TargetBars> bars;
};

/// Explains a parameter of a positioning test: how the edition computes it and how it follows from the
/// statistics of the test; or of a circular test, from its circles. The result is printed as elsewhere
/// (printednumbers.h); inserted numbers have the digits of statistics per target (one more than the
/// readings), or those of the result if it has more. All computations are unrounded. Without a value there
/// are no steps, and the words give the reason. Null if the test has no such parameter. `id` as in
/// parameterId().
[[nodiscard]] std::optional<Explanation> explanation(const EvaluatedDocument &evaluated, std::size_t test,
                                                     std::string_view id, const Language &language);

/// Formula of a parameter in symbols, with the factor of the edition, for the help. Empty if a row has no
/// explanation.
[[nodiscard]] Formula formulaOf(const Edition &edition, const Row &row, const Language &language);

} // namespace palmer
