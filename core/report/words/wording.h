// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/statedthings.h"
#include "kernel/evaluation/testevaluation.h"
#include "language/decimals.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <span>

namespace palmer {

// What several kinds of reports say alike: words, symbols, and with how many decimals numbers are printed.

[[nodiscard]] Text verdictText(Verdict verdict);
/// How one quantity stands to its limit: "met", "not proven", "exceeded".
[[nodiscard]] Text limitText(Verdict verdict);
/// How those of a test stand to theirs: the same in the plural, without a verdict "none agreed" or, where
/// limits were agreed that do not hold, "no verdict".
[[nodiscard]] Text limitsText(std::optional<Verdict> verdict, bool anyLimit);
[[nodiscard]] Text gradeText(Grade grade);
[[nodiscard]] Text correctionText(CorrectionTo20 correction);
[[nodiscard]] Text cycleText(std::optional<Cycle> cycle, const Edition &edition);
[[nodiscard]] QString arrow(Direction direction);

/// "as found", "as left"; empty where it is not stated.
[[nodiscard]] inline Text roleText(TestRole role) {
    return statedWord("role", role);
}

/// "periodic check", "after repair"; empty where it is not stated.
[[nodiscard]] inline Text purposeText(Purpose purpose) {
    return statedWord("purpose", purpose);
}

/// The clause of a finding; an annex as the language calls it.
[[nodiscard]] QString clauseText(const std::string &clause, const Language &language);

/// "ISO 230-2:2006" as it stands after a preposition: with its article where the language has one. Empty
/// without an edition.
[[nodiscard]] QString standardName(const Language &language, const Edition *edition);

/// "anticlockwise", "clockwise".
[[nodiscard]] Text senseText(Sense sense);

/// The same where "sense" stands already, or room is scarce.
[[nodiscard]] Text shortSenseText(Sense sense);

/// Results that depend on the temperature do not hold at 20 °C.
[[nodiscard]] At20 at20(const TestEvaluation &evaluation);
[[nodiscard]] bool notCorrected(const TestEvaluation &evaluation);

/// How s was computed; by calculation where there is none.
[[nodiscard]] DeviationMethod deviationMethod(const TestEvaluation &evaluation);

/// What a decision rule is called.
struct RuleWords {
    Text name; ///< in a column
    Text condition;
    Text inReport;
};
[[nodiscard]] const RuleWords &ruleWords(Rule rule);

/// Several runs of a direction: s and what is made of it have a value.
[[nodiscard]] bool hasScatter(const TestEvaluation &evaluation);

/// The symbol with its index set lower.
[[nodiscard]] Phrase symbolPhrase(const Symbol &symbol, const std::string &index = {});

/// A sentence in which the symbols of these parameters ("FmaxXY", "Fmax,XY", "Fmax_XY") have their indices
/// set lower.
[[nodiscard]] Phrase withSymbols(const QString &sentence, std::span<const Parameter> parameters);

/// A formula ("α_i·(T_i − 20)", see formulaFrom) with its indices set lower.
[[nodiscard]] Phrase phraseFrom(const QString &formula);

/// "2↓ – 5↓": the targets that rule a parameter; empty where none does.
[[nodiscard]] QString rulingText(const Parameter &parameter);

/// The quantities a positioning test speaks in.
[[nodiscard]] Quantity positionQuantity(const PositioningMeasurement &measurement);
[[nodiscard]] Quantity deviationQuantity(const PositioningMeasurement &measurement);

/// The finest step any instrument of the test shows, in mm or degrees; null where none is stated.
[[nodiscard]] std::optional<double> finestResolution(const Document &document, const Test &test);

/// "Not evaluable: A, R (one run in each direction)."; empty where every limit was evaluated.
[[nodiscard]] QString notEvaluableSentence(const TestEvaluation &evaluation, const Language &language);

/// Whether the parameter stands on the report: those on request only if asked for.
[[nodiscard]] bool isPrinted(const Parameter &parameter, const ReportHead &head);

/// What the U of results stand for: k = 2, or the 95.45 % interval of a simulation.
struct CoverageOfResults {
    bool factor = false;            ///< some have k = 2
    std::vector<QString> simulated; ///< symbols of those that a simulation gave

    [[nodiscard]] bool mixed() const { return factor && !simulated.empty(); }
};
/// Of the parameters that are printed.
[[nodiscard]] CoverageOfResults coverageOf(const TestEvaluation &evaluation, const ReportHead &head);

/// "U (k = 2)", "U (95.45 %)"; "U" where a column holds both and `coverageNote` says which.
[[nodiscard]] QString uncertaintyHead(const CoverageOfResults &coverage, const Language &language);

/// "k = 2", "95.45 %"; of a mixed column "95.45 % for A, E; k = 2 for the others". Empty where there is no U.
[[nodiscard]] QString coverageNote(const CoverageOfResults &coverage, const Language &language);

/// Some result has a simulated U, whose guard band carries 2 s_U.
[[nodiscard]] bool guardsSimulated(const TestEvaluation &evaluation);

/// Whether a quantity per target says anything about this test.
[[nodiscard]] bool isShown(const TargetTerm &term, const PositioningResults &results);

/// The row of the edition that a parameter comes from; null for none.
[[nodiscard]] const Row *rowOf(const Edition &edition, const Parameter &parameter);

} // namespace palmer
