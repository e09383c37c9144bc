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
    QStringList values;      ///< one per column; a dash for no value, empty: no such parameter
    QStringList differences; ///< from the first column, signed; may be empty
    QStringList reasons;     ///< sentences: why columns differ, or that they do not

    [[nodiscard]] QString reason() const { return reasons.join(u' '); }

    bool operator==(const ComparisonRow &) const = default;
};

/// Results side by side, in one language and unit.
struct ResultComparison {
    QString unit;
    QStringList columns; ///< content of each column; the first is the reference
    std::vector<ComparisonRow> rows;
    QStringList notes;

    bool operator==(const ResultComparison &) const = default;
};

/// Editions worth comparing with that of a test: one per family, its own first. Empty for drift tests.
[[nodiscard]] std::vector<std::string> editionsToCompare(const Test &test);

/// The same readings under several editions (words), in that order. The reasons name the differences of the
/// editions: factor c, formula of s, parameters they have or lack; never a verdict.
[[nodiscard]] ResultComparison compareEditions(const EvaluatedDocument &evaluated, std::size_t test,
                                               const std::vector<std::string> &editions,
                                               const Language &language);

/// A test of this or another file.
struct ComparedTest {
    EvaluatedDocument evaluated;
    std::size_t test = 0;
    QString name;
};

/// True if two tests can be compared: same kind, and for positioning tests the same kind of motion.
[[nodiscard]] bool isComparable(const Test &a, const Test &b);

/// The parameters of several tests, all under the edition of the first, with the differences from it. Tests
/// that cannot be compared with the first are left out, with a note.
[[nodiscard]] ResultComparison compareTests(const std::vector<ComparedTest> &tests, const Language &language);

/// One curve of a test, in displayed units: mean deviations over target positions, interrupted by gaps; or a
/// path of a circle, radial deviations over the angle.
struct ComparisonCurve {
    QString name;
    std::size_t test = 0;       ///< index among the displayed tests; its curves have the same style
    std::optional<Sense> sense; ///< for a path
    std::vector<std::vector<FigurePoint>> lines;
};

struct ComparisonFigure {
    FigureAxis x;
    FigureAxis y;
    std::vector<ComparisonCurve> curves;
};

/// Figure of all tests of the same kind as the first. Positioning tests: the means x̄ of both directions, or
/// of the measured one. Circular tests: the first path of each sense, unwrapped, about its least squares
/// centre; long paths are reduced to their extremes. May have no curves.
[[nodiscard]] ComparisonFigure comparisonFigure(const std::vector<ComparedTest> &tests,
                                                const Language &language);

/// Tab-separated with a heading row, for spreadsheets: numbers in the format of the language, without spaces.
[[nodiscard]] QString asTabSeparated(const ResultComparison &comparison);

} // namespace palmer
