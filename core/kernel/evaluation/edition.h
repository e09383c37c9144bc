// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"
#include "kernel/evaluation/requirement.h"
#include "kernel/evaluation/statistics.h"
#include "kernel/measurement/test.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace palmer {

/// Value of a parameter: NaN if a statistic it needs is missing.
struct Outcome {
    double value = 0;
    std::array<std::optional<Ruling>, 2> ruling;
};

/// Conditions for listing a parameter: bits, combined with |. scatter: two runs in a direction; byRange: s by
/// the range method.
enum Need : unsigned { upward = 1, downward = 2, bothWays = 3, scatter = 4, byRange = 8 };

/// Computation of a parameter from the statistics per target and the factor c: for one test, and for four at
/// once, identical per lane to the last bit; the values must exist in all of them.
struct ParameterFormula {
    Outcome (*one)(std::span<const TargetStatistics>, double c) = nullptr;
    Lanes (*four)(std::span<const TargetStatisticsOf<Lanes>>, double c) = nullptr;

    Outcome operator()(std::span<const TargetStatistics> targets, double c) const { return one(targets, c); }
};

/// One parameter of an edition of ISO 230-2: its names, the conditions it needs, and its computation.
struct Row {
    Term term;
    unsigned needs = 0;
    const ParameterFormula *value = nullptr;
    bool dependsOnTemperature = false; ///< wrong away from 20 °C unless corrected
};

/// A quantity per target, with its names in table headings and help.
struct TargetTerm {
    const char *id = nullptr; ///< "mean+", "mean", "reversal", "s", "R+", "R", …
    Symbol symbol;
    Text name = {};
    const char *clause = "";
    unsigned needs = 0;
    Weight weight = Weight::main; ///< detail: shown with the readings only if one direction was measured
    const char *largest = "";     ///< id of the parameter that is its maximum: "R+"
};

struct PositioningCase; // a test with its results and surroundings: positioningcase.h
struct CircularCase;    // likewise: iso230_4/circularcase.h

/// How a point to be agreed is treated in a test.
enum class PointRole { listed, inRow, notApplicable };

/// A point to be agreed between supplier/manufacturer and user.
struct AgreementPoint {
    const char *point = nullptr;  ///< key in the file format
    const char *letter = nullptr; ///< letter in the standard; empty if letters are not printed
    Text name = {};
    /// Listed with its agreement, covered by a row of the requirements, or not applicable.
    PointRole (*role)(const Test &) = nullptr; ///< null: always listed
    bool needsReason = false;                  ///< "not applicable" is valid only with a text
};

/// How much of the text of an edition was read and can be cited.
enum class TextRead { all, part, none };

using Requirement = RequirementOf<PositioningCase>;

/// Parameters and requirements of an edition of ISO 230-4; see iso230_4/circularcase.h.
struct CircularRules;

/// How targets are chosen if the choice is free. 1988: P = (N + r)·p with p the largest cyclic pitch. Later
/// editions: P_i = (i − 1)·p + r with p the nominal interval.
enum class TargetRule { pitches1988, nominalInterval };

/// One edition of a standard. Aliases differ from their family only in word and title.
struct Edition {
    const char *word = nullptr;   ///< in the file: "ISO 230-2:2006"
    const char *family = nullptr; ///< word of the edition whose rules apply; verdicts are valid within it
    Kind kind = Kind::positioning;
    Text title = {}; ///< the standard's own title; empty if only the designation is used
    Text deviation = REPORT_TEXT("report", "Positional deviation");
    Text deviations = REPORT_TEXT("report", "positional deviations");
    Text deviationsOfAxis = REPORT_TEXT("report", "Positional deviations of the %1 axis");
    Text environment = REPORT_TEXT("report", "Environment");
    Text unloaded = REPORT_TEXT("report", "machine unloaded");
    Text agreedBetween = REPORT_TEXT("report", "between supplier/manufacturer and user");
    bool isDefault = false;   ///< of its kind
    double c = 0;             ///< factor of s (ISO 230-2)
    bool rangeMethod = false; ///< s by the range method allowed
    Text standardCycle = {};  ///< names of the measuring cycles (ISO 230-2)
    Text stepCycle = {};
    TargetRule targetRule = TargetRule::nominalInterval;
    const char *targetLetter = "i"; ///< index of the targets in symbols
    const char *runLetter = "j";    ///< index of the runs of a direction
    std::span<const Row> rows = {};
    std::span<const TargetTerm> targetTerms = {};
    TextRead textRead = TextRead::none;
    bool stepCycleByAgreement = false; ///< results are acceptance results only by written agreement
    std::span<const Requirement> requirements = {}; ///< in the order of the printed standard
    const char *resultsClause = "";                 ///< asks for the results; empty if none was read
    std::span<const AgreementPoint> points = {};
    const char *pointsClause = "";
    const char *parametersClause = "";      ///< of the test parameters of a circular test
    const CircularRules *circles = nullptr; ///< of ISO 230-4; null for ISO 230-2
};

/// Returns all editions in the order they are offered.
[[nodiscard]] std::span<const Edition *const> editions();

/// Returns the editions for a kind of test; empty if none judges it.
[[nodiscard]] std::span<const Edition *const> editionsOf(Kind kind);

/// Returns their words in that order, for a sentence: "ISO 230-2:1988, ISO 230-2:1997".
[[nodiscard]] std::string wordsOf(std::span<const Edition *const> list);

/// Returns the edition with this word, or null.
[[nodiscard]] const Edition *findEdition(std::string_view word);

/// Returns the default edition of the kind.
[[nodiscard]] const Edition &defaultEdition(Kind kind);

/// Returns the parameters of an edition in its order.
[[nodiscard]] std::vector<const Term *> termsOf(const Edition &edition);

/// True if any edition of the kind has a parameter with this id (without axis index): a key of `limits`.
[[nodiscard]] bool isParameter(Kind kind, std::string_view id);

/// True if any edition of the kind has this point to agree.
[[nodiscard]] bool isAgreementPoint(Kind kind, std::string_view point);

} // namespace palmer
