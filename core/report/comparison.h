// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "language/language.h"
#include "report/words/formula.h"

#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// One parameter in all columns.
struct ComparisonRow {
    QString id; ///< parameterId
    Formula symbol;
    QString name;
    QStringList values;      ///< one a column; a dash for no value, empty where the column does not know it
    QStringList differences; ///< to the first column, signed; empty where there is none to tell
    QStringList reasons;     ///< sentences: why columns differ, or that they do not

    [[nodiscard]] QString reason() const { return reasons.join(u' '); }

    bool operator==(const ComparisonRow &) const = default;
};

/// Results side by side, in one language and one unit.
struct ResultComparison {
    QString unit;
    QStringList columns; ///< what each column shows; the first is what the others are compared with
    std::vector<ComparisonRow> rows;
    QStringList notes;

    bool operator==(const ResultComparison &) const = default;
};

/// Editions worth comparing with that of a test: one a family, its own first. Empty for drift tests.
[[nodiscard]] std::vector<std::string> editionsToCompare(const Test &test);

/// The same readings under several editions (words), in that order. Reasons say what the editions do
/// otherwise: factor c, way to s, parameters they have or have not; never a verdict.
[[nodiscard]] ResultComparison compareEditions(const EvaluatedDocument &evaluated, std::size_t test,
                                               const std::vector<std::string> &editions,
                                               const Language &language);

/// A test of this or another file.
struct ComparedTest {
    EvaluatedDocument evaluated;
    std::size_t test = 0;
    QString name;
};

/// Whether two tests can be compared: of one kind, and positioning tests of one kind of motion.
[[nodiscard]] bool isComparable(const Test &a, const Test &b);

/// The parameters of several tests, all under the edition of the first, with the differences to it. What
/// cannot be compared with the first is left out, with a note.
[[nodiscard]] ResultComparison compareTests(const std::vector<ComparedTest> &tests, const Language &language);

/// One curve of a test, in the units that are shown: the mean deviations over the target positions, a gap
/// begins another line; or a path of a circle, its radial deviations over the angle.
struct ComparisonCurve {
    QString name;
    std::size_t test = 0;       ///< the how many'th of the tests shown: curves of one look alike
    std::optional<Sense> sense; ///< of a path
    std::vector<std::vector<FigurePoint>> lines;
};

struct ComparisonFigure {
    FigureAxis x;
    FigureAxis y;
    std::vector<ComparisonCurve> curves;
};

/// For one picture, those of the kind of the first. Positioning tests: the means x̄ of both directions, or of
/// the one that was measured. Circular tests: the first path of each sense, unwrapped, about its least
/// squares centre; of very many points the extremes. Without any, no curves.
[[nodiscard]] ComparisonFigure comparisonFigure(const std::vector<ComparedTest> &tests,
                                                const Language &language);

/// Tab-separated with a head, for spreadsheets: numbers as the language writes them, without spaces.
[[nodiscard]] QString asTabSeparated(const ResultComparison &comparison);

} // namespace palmer
