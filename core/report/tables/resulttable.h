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

/// The results of a test in the order of its edition; those printed on request are omitted unless the report
/// includes them.
[[nodiscard]] std::vector<PrintedResult> printedResults(const Document &document, const Test &test,
                                                        const TestEvaluation &evaluation,
                                                        const Language &language);

/// The rows that are followed by a rule.
[[nodiscard]] std::vector<std::size_t> rulesBetween(const std::vector<PrintedResult> &results);

/// Position of a value on a scale centred on the limit, with a guard band of constant width. The scale covers
/// −1 … 1; an arrow replaces values beyond it.
struct DecisionScale {
    double value = 0; ///< −1 … 1, clamped
    bool below = false;
    bool above = false; ///< beyond the scale
    bool band = false;  ///< the rule has a guard band, from −guard to +guard
    static constexpr double guard = 1.0 / 3;

    bool operator==(const DecisionScale &) const = default;
};

/// With a guard band g the scale covers limit ± 3 g, otherwise 0 … 2 · limit. Signed values by magnitude,
/// lower limits mirrored. Null without a value or a limit above zero (lower limits: below zero). All in the
/// same unit.
[[nodiscard]] std::optional<DecisionScale> decisionScale(const Parameter &parameter);

/// A result as listed in the window.
struct ResultLine {
    QString id; ///< parameterId
    Formula symbol;
    QString name;               ///< short; "unidirectional" below the bidirectional one
    QString narrowName;         ///< for narrow tables
    QString fullName;           ///< the edition's term
    std::vector<QString> cells; ///< in the order of resultColumns(); a dash for missing numbers
    std::optional<Verdict> verdict;
    QString reason; ///< why nothing is proven; empty where the numbers say it
    std::optional<DecisionScale> scale;
    bool main = true;    ///< bidirectional, G or D; otherwise a detail
    bool isFirst = true; ///< first of its group, with a rule above
    /// Verdict of the same quantity in the test of the other role, if the table has one.
    std::optional<Verdict> otherVerdict = {};
    QString otherVerdictWord = {};

    /// The cell with the key of its column.
    [[nodiscard]] const QString &cell(std::string_view key) const;
    [[nodiscard]] const QString &cell(const ResultColumn &column) const;
};

/// Short results of one test.
struct ResultTable {
    QString unit;
    QString rule;     ///< "ISO 14253-1"
    QString circle;   ///< "MZC", "LSC": for G and G(b); empty for positioning
    QString coverage; ///< of U: "k = 2", "95.45 %", or a list of both; empty if there is no U
    std::vector<ResultLine> lines;
    std::optional<Verdict> verdict;
    QString verdictWord;
    bool view = false;        ///< under another edition, without verdicts
    QString viewNote;         ///< statement of that
    bool provisional = false; ///< readings are incomplete, or an outdated simulation decides
    QString edition;
    std::optional<std::size_t> otherTest; ///< test of the other role; may be null
    bool otherIsFound = true;             ///< true: the other test is as found, this one as left
};

/// A quantity of a test as found and the test as left. Points into their evaluations.
struct QuantityOfRoles {
    const Parameter *found = nullptr;
    const Parameter *left = nullptr;
    QString change; ///< left − found, signed; empty unless both have a value
};

struct RolesBeside {
    std::size_t found = 0;
    std::size_t left = 0;
    std::vector<QuantityOfRoles> quantities; ///< printed quantities that both tests have
};

/// `test` is one of the two. Null if there is no other one (see testAsFound), or one of them is not evaluated
/// under its own edition.
[[nodiscard]] std::optional<RolesBeside> rolesBeside(const EvaluatedDocument &evaluated, std::size_t test,
                                                     const Language &language);

/// Short name of a result outside of lists: "unidirectional accuracy"; for a path its sense.
[[nodiscard]] Text briefName(const Parameter &parameter, const TestEvaluation &evaluation);

/// Short name of a parameter in a list below its bidirectional companion; its term if there is no shorter
/// name.
[[nodiscard]] Text listedName(const Term &term);

/// The results of a test as evaluated, in the order of its edition; those printed on request are omitted
/// unless the report includes them. Empty for tests without edition.
[[nodiscard]] ResultTable resultTable(const EvaluatedDocument &evaluated, std::size_t test,
                                      const Language &language);

/// Tab-separated with a heading row, for spreadsheets: numbers in the format of the language, but without
/// spaces and with "-", so that they are read as numbers.
[[nodiscard]] QString asTabSeparated(const ResultTable &table, const Language &language);

/// The same as an HTML table, for text documents.
[[nodiscard]] QString asHtml(const ResultTable &table, const Language &language);

} // namespace palmer
