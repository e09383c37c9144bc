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

/// The value of a parameter: NaN where a statistic it needs is missing.
struct Outcome {
    double value = 0;
    std::array<std::optional<Ruling>, 2> ruling;
};

/// What a parameter needs of the test to be listed: bits, joined with |. Scatter: two runs of a direction;
/// byRange: s by the range method.
enum Need : unsigned { upward = 1, downward = 2, bothWays = 3, scatter = 4, byRange = 8 };

/// One parameter of an edition of ISO 230-2: what it is called, what it needs, how it is computed from the
/// statistics per target and the factor c.
struct Row {
    Term term;
    unsigned needs = 0;
    Outcome (*value)(std::span<const TargetStatistics>, double c) = nullptr;
    bool dependsOnTemperature = false; ///< wrong away from 20 °C unless corrected
};

/// A quantity per target: what the heads of tables and the help call it.
struct TargetTerm {
    const char *id = nullptr; ///< "mean+", "mean", "reversal", "s", "R+", "R", …
    Symbol symbol;
    Text name = {};
    const char *clause = "";
    unsigned needs = 0;
    Weight weight = Weight::main; ///< detail: beside the readings only where one direction was measured
    const char *largest = "";     ///< id of the parameter that is its largest: "R+"
};

struct PositioningCase; // a test and all that is known of it: positioningcase.h
struct CircularCase;    // likewise: iso230_4/circularcase.h

/// Whether a point to be agreed applies to a test, or to none.
enum class PointRole { listed, inRow, notApplicable };

/// A point to be agreed between supplier/manufacturer and user.
struct AgreementPoint {
    const char *point = nullptr;  ///< word of the file format
    const char *letter = nullptr; ///< as the standard letters it; empty where no letters are printed
    Text name = {};
    /// Listed with its agreement, asked for by a row of the requirements, or without object.
    PointRole (*role)(const Test &) = nullptr; ///< null: always listed
    bool needsReason = false;                  ///< "not applicable" holds with a text only
};

/// How much of the text of an edition was read: what Palmer can cite.
enum class TextRead { all, part, none };

using Requirement = RequirementOf<PositioningCase>;

/// What an edition of ISO 230-4 computes and asks for; see iso230_4/circularcase.h.
struct CircularRules;

/// How targets are chosen where they can be chosen freely. 1988: P = (N + r)·p with p the largest cyclic
/// pitch. Later editions: P_i = (i − 1)·p + r with p the nominal interval.
enum class TargetRule { pitches1988, nominalInterval };

/// One edition of a standard. Aliases share everything with their family but word and title.
struct Edition {
    const char *word = nullptr;   ///< what the file says: "ISO 230-2:2006"
    const char *family = nullptr; ///< word of the edition whose rules these are; verdicts hold within it
    Kind kind = Kind::positioning;
    Text title = {}; ///< the standard's own title; empty where the designation stands alone
    Text deviation = REPORT_TEXT("report", "Positional deviation");
    Text deviations = REPORT_TEXT("report", "positional deviations");
    Text deviationsOfAxis = REPORT_TEXT("report", "Positional deviations of the %1 axis");
    Text environment = REPORT_TEXT("report", "Environment");
    Text unloaded = REPORT_TEXT("report", "machine unloaded");
    Text agreedBetween = REPORT_TEXT("report", "between supplier/manufacturer and user");
    bool isDefault = false;   ///< of its kind: where none is named
    double c = 0;             ///< factor of s (ISO 230-2)
    bool rangeMethod = false; ///< s by the range method allowed
    Text standardCycle = {};  ///< what the measuring cycles are called (ISO 230-2)
    Text stepCycle = {};
    TargetRule targetRule = TargetRule::nominalInterval;
    std::span<const Row> rows = {};
    std::span<const TargetTerm> targetTerms = {};
    TextRead textRead = TextRead::none;
    bool stepCycleByAgreement = false; ///< its results are acceptance results by written agreement only
    std::span<const Requirement> requirements = {}; ///< in the order of the printed standard
    const char *resultsClause = "";                 ///< that asks for the results; empty where none was read
    std::span<const AgreementPoint> points = {};
    const char *pointsClause = "";
    const char *parametersClause = "";      ///< of the test parameters of a circular test
    const CircularRules *circles = nullptr; ///< of ISO 230-4; null for ISO 230-2
};

/// All editions in the order they are offered in.
[[nodiscard]] std::span<const Edition *const> editions();

/// Those for a kind of test; empty where none judges it.
[[nodiscard]] std::span<const Edition *const> editionsOf(Kind kind);

/// Their words in that order, for a sentence that says which there are: "ISO 230-2:1988, ISO 230-2:1997".
[[nodiscard]] std::string wordsOf(std::span<const Edition *const> list);

/// The edition of that word, or null.
[[nodiscard]] const Edition *findEdition(std::string_view word);

/// That of the kind where none is named.
[[nodiscard]] const Edition &defaultEdition(Kind kind);

/// The parameters of an edition in its order.
[[nodiscard]] std::vector<const Term *> termsOf(const Edition &edition);

/// Whether any edition of the kind has a parameter of this id (without axis index): a key of `limits`.
[[nodiscard]] bool isParameter(Kind kind, std::string_view id);

/// Whether any edition of the kind has this point to agree.
[[nodiscard]] bool isAgreementPoint(Kind kind, std::string_view point);

} // namespace palmer
