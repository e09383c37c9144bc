// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/tables/resultcolumns.h"
#include "report/words/formula.h"

#include <QString>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace palmer {

/// The results of a test in the order of its edition; those for print on request are left out unless the
/// report asks for them.
[[nodiscard]] std::vector<PrintedResult> printedResults(const Document &document, const Test &test,
                                                        const TestEvaluation &evaluation,
                                                        const Language &language);

/// The rows of a table of them that a rule stands below.
[[nodiscard]] std::vector<std::size_t> rulesBetween(const std::vector<PrintedResult> &results);

/// Where a value stands beside its limit on a scale whose middle is the limit and whose guard band is always
/// equally wide. −1 … 1 is what the scale shows; beyond, an arrow stands for the value.
struct DecisionScale {
    double value = 0; ///< −1 … 1, clamped
    bool below = false;
    bool above = false; ///< outside of the scale
    bool band = false;  ///< the rule has a guard band: from −guard to +guard
    static constexpr double guard = 1.0 / 3;

    bool operator==(const DecisionScale &) const = default;
};

/// With a guard band g the scale shows limit ± 3 g, without one 0 … 2 · limit. Signed values by size, lower
/// limits turned round. Nothing without value, or without a limit above zero (a lower one: below). All in one
/// unit.
[[nodiscard]] std::optional<DecisionScale> decisionScale(const Parameter &parameter);

/// A result as a window lists it.
struct ResultLine {
    QString id; ///< parameterId
    Formula symbol;
    QString name;               ///< short; beside the bidirectional one "unidirectional" is enough
    QString narrowName;         ///< where there is little room
    QString fullName;           ///< the edition's term
    std::vector<QString> cells; ///< by the rows of resultColumns(); of numbers a dash for none
    std::optional<Verdict> verdict;
    std::optional<DecisionScale> scale;
    bool main = true;    ///< bidirectional, G or D; else a detail
    bool isFirst = true; ///< of those that belong together: with a rule above
    /// The verdict of the same quantity in the test of the other role, where the table has one.
    std::optional<Verdict> otherVerdict = {};
    QString otherVerdictWord = {};

    /// By the key of its column.
    [[nodiscard]] const QString &cell(std::string_view key) const;
    [[nodiscard]] const QString &cell(const ResultColumn &column) const;
};

/// The results of one test in short.
struct ResultTable {
    QString unit;
    QString rule;     ///< "ISO 14253-1"
    QString circle;   ///< "MZC", "LSC": of G and G(b); empty for positioning
    QString coverage; ///< of U: "k = 2", "95.45 %", or which has which; empty where there is no U
    std::vector<ResultLine> lines;
    std::optional<Verdict> verdict;
    QString verdictWord;
    bool view = false;        ///< under another edition: no verdicts
    QString viewNote;         ///< says so
    bool provisional = false; ///< readings are still to come, or an outdated simulation decides
    QString edition;
    std::optional<std::size_t> otherTest; ///< of the other role; null: none
    bool otherIsFound = true;             ///< that one is as found, this one as left
};

/// A quantity of a test as found and of the same as left. Points into the evaluations it was made from.
struct QuantityOfRoles {
    const Parameter *found = nullptr;
    const Parameter *left = nullptr;
    QString change; ///< left − found, signed; empty where one has no value
};

/// A test as found and the one as left, side by side.
struct RolesBeside {
    std::size_t found = 0;
    std::size_t left = 0;
    std::vector<QuantityOfRoles> quantities; ///< that both have and the report prints
};

/// `test` is one of the two; null where it has no other (see testAsFound), or one of them is not evaluated
/// under its own edition.
[[nodiscard]] std::optional<RolesBeside> rolesBeside(const EvaluatedDocument &evaluated, std::size_t test,
                                                     const Language &language);

/// What a result is called in a few words where it stands alone: "unidirectional accuracy"; of a path its
/// sense.
[[nodiscard]] Text briefName(const Parameter &parameter, const TestEvaluation &evaluation);

/// What a list calls the parameter below its bidirectional companion: short; the term where there is no
/// shorter one.
[[nodiscard]] Text listedName(const Term &term);

/// The results of a test as it is evaluated, in the order of its edition; those for print on request are left
/// out unless the report asks for them. Empty for tests without edition.
[[nodiscard]] ResultTable resultTable(const EvaluatedDocument &evaluated, std::size_t test,
                                      const Language &language);

/// Tab-separated with a head, as spreadsheets paste it: numbers as the language writes them, without spaces
/// in them and with "-", that a spreadsheet of that language reads as numbers.
[[nodiscard]] QString asTabSeparated(const ResultTable &table, const Language &language);

/// The same as a table of HTML, for texts.
[[nodiscard]] QString asHtml(const ResultTable &table, const Language &language);

} // namespace palmer
