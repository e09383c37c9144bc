// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/statedthings.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "kernel/words/text.h"
#include "language/decimals.h"
#include "language/language.h"
#include "report/blocks/report.h"
#include "report/words/formula.h"

#include <span>

namespace palmer {

// Words, symbols and decimals shared by all kinds of reports.

[[nodiscard]] Text verdictText(Verdict verdict);
/// A quantity compared with its limit: "met", "not proven", "exceeded".
[[nodiscard]] Text limitText(Verdict verdict);
/// The same for all limits of a test, in the plural; without a verdict "none agreed" or, if agreed limits do
/// not apply, "no verdict".
[[nodiscard]] Text limitsText(std::optional<Verdict> verdict, bool anyLimit);
[[nodiscard]] Text gradeText(Grade grade);
[[nodiscard]] Text correctionText(CorrectionTo20 correction);
[[nodiscard]] Text cycleText(std::optional<Cycle> cycle, const Edition &edition);
[[nodiscard]] QString arrow(Direction direction);

/// "as found", "as left"; may be empty.
[[nodiscard]] inline Text roleText(TestRole role) {
    return statedWord("role", role);
}

/// "periodic check", "after repair"; may be empty.
[[nodiscard]] inline Text purposeText(Purpose purpose) {
    return statedWord("purpose", purpose);
}

/// The clause of a finding; annexes are named in the language.
[[nodiscard]] QString clauseText(const std::string &clause, const Language &language);

/// "ISO 230-2:2006" after a preposition, with its article if the language uses one. Empty without an edition.
[[nodiscard]] QString standardName(const Language &language, const Edition *edition);

/// "anticlockwise", "clockwise".
[[nodiscard]] Text senseText(Sense sense);

/// Short form if space is scarce or "sense" is already named.
[[nodiscard]] Text shortSenseText(Sense sense);

/// Whether results that depend on temperature hold at 20 °C; notCorrected: true if they do not.
[[nodiscard]] At20 at20(const TestEvaluation &evaluation);
[[nodiscard]] bool notCorrected(const TestEvaluation &evaluation);

/// Returns why a result proves nothing under a rule that demands a proof; empty where its numbers say it.
[[nodiscard]] Text whyNotProven(const Parameter &parameter, const TestEvaluation &evaluation);
inline constexpr Text notProvenWithoutUncertainty =
    REPORT_TEXT("report", "nothing is proven without a measurement uncertainty");

/// Method used for s; `calculation` if there is no s.
[[nodiscard]] DeviationMethod deviationMethod(const TestEvaluation &evaluation);

/// Names of a decision rule.
struct RuleWords {
    Text name; ///< in a column
    Text condition;
    Text inReport;
};
[[nodiscard]] const RuleWords &ruleWords(Rule rule);

/// A rule in these words with its guard band, if it has one: "ISO 14253-1, guard band 0.83 U".
[[nodiscard]] QString ruleWithBand(const DecisionRule &rule, const Text &words, const Language &language);

/// True if a direction has several runs, so that s and the quantities based on it have values.
[[nodiscard]] bool hasScatter(const TestEvaluation &evaluation);

/// A formula as part of a table or sentence.
[[nodiscard]] Phrase phraseOf(const Formula &formula);

/// The symbol with its index as a subscript.
[[nodiscard]] Phrase symbolPhrase(const Symbol &symbol, const std::string &index = {});
[[nodiscard]] Phrase symbolPhrase(const Parameter &parameter);

/// A sentence in which the indices of E_VE, G_f, G(b)_f and of the symbols of these parameters ("FmaxXY",
/// "Fmax,XY", "Fmax_XY") become subscripts.
[[nodiscard]] Phrase withSymbols(const QString &sentence, std::span<const Parameter> parameters);

/// A formula ("α_i·(T_i − 20)", see formulaFrom) with its indices as subscripts.
[[nodiscard]] Phrase phraseFrom(const QString &formula);

/// Targets that rule a parameter: "2↓ – 5↓"; may be empty.
[[nodiscard]] QString rulingText(const Parameter &parameter);

/// Finest resolution of the instruments of the test, in mm or degrees; null if none is stated.
[[nodiscard]] std::optional<double> finestResolution(const Document &document, const Test &test);

/// "Not evaluable: A, R (one run in each direction)."; empty if every limit was evaluated.
[[nodiscard]] QString notEvaluableSentence(const TestEvaluation &evaluation, const Language &language);

/// True if the report shows the parameter; those printed on request only if included.
[[nodiscard]] bool isPrinted(const Parameter &parameter, const ReportHead &head);

/// Coverage of the U of results: k = 2, or the 95.45 % interval of a simulation.
struct CoverageOfResults {
    bool factor = false;            ///< some U have k = 2
    std::vector<QString> simulated; ///< symbols of results with a simulated U

    [[nodiscard]] bool mixed() const { return factor && !simulated.empty(); }
};
/// Coverage of the printed parameters.
[[nodiscard]] CoverageOfResults coverageOf(const TestEvaluation &evaluation, const ReportHead &head);

/// "U (k = 2)", "U (95.45 %)"; "U" if a column contains both, listed by `coverageNote`.
[[nodiscard]] QString uncertaintyHead(const CoverageOfResults &coverage, const Language &language);

/// "k = 2", "95.45 %"; for a mixed column "95.45 % for A, E; k = 2 for the others". Empty without U.
[[nodiscard]] QString coverageNote(const CoverageOfResults &coverage, const Language &language);

/// Letters of an edition for the indices of targets and of runs: "i" and "j", 1988 "j" and "i".
[[nodiscard]] QString letterOfTargets(const Edition &edition);
[[nodiscard]] QString letterOfRuns(const Edition &edition);

/// Returns a formula, written with targets i, in the letters of the edition: "x̄_i↑" → "x̄_j↑". Subscripts
/// "ij" are the same in all.
[[nodiscard]] QString inLettersOf(const Edition &edition, const char *formula);

/// True if a result has a simulated U, whose guard band includes 2 s_U.
[[nodiscard]] bool guardsSimulated(const TestEvaluation &evaluation);

/// True if a quantity per target applies to this test.
[[nodiscard]] bool isShown(const TargetTerm &term, const PositioningResults &results);

/// The row of the edition that defines a parameter; may be null.
[[nodiscard]] const Row *rowOf(const Edition &edition, const Parameter &parameter);

/// Words of a kind of test; %1 is the axis or the axes.
struct KindWords {
    Text name;   ///< as a heading
    Text listed; ///< above its results on the command line
    Text brief;  ///< in a summary; %2 is the radius
    Text budget; ///< explains its uncertainty budget; may be empty
};

[[nodiscard]] const KindWords &kindWords(const Test &test);

} // namespace palmer
