// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/editions.h"

#include "kernel/evaluation/iso230_2/parameters.h"

#include <array>
#include <vector>

namespace palmer::iso230_2 {

namespace {

constexpr unsigned upOnly = upward | scatter;
constexpr unsigned downOnly = downward | scatter;
constexpr unsigned both = bothWays | scatter;
constexpr auto mainRow = Weight::main;
constexpr auto detail = Weight::detail;
constexpr auto onRequest = Printed::onRequest;
constexpr bool at20 = true;

// clang-format off
constexpr ShortName unidirectionalAccuracy1988{REPORT_TEXT("report", "unidirectional"), REPORT_TEXT_FOR("report", "unidirectional accuracy", "1988"), REPORT_TEXT_FOR("report", "unidir. accuracy", "1988")};
constexpr ShortName unidirectionalAccuracy{REPORT_TEXT("report", "unidirectional"), REPORT_TEXT("report", "unidirectional accuracy"), REPORT_TEXT("report", "unidir. accuracy")};
constexpr ShortName unidirectionalDeviation{REPORT_TEXT_FOR("report", "unidirectional", "masculine"), REPORT_TEXT("report", "unidirectional systematic deviation"), REPORT_TEXT("report", "unidir. systematic dev.")};
constexpr ShortName unidirectionalError{REPORT_TEXT_FOR("report", "unidirectional", "masculine"), REPORT_TEXT("report", "unidirectional systematic error"), REPORT_TEXT("report", "unidir. systematic error")};
constexpr ShortName unidirectionalRepeatability{REPORT_TEXT("report", "unidirectional"), REPORT_TEXT("report", "unidirectional repeatability"), REPORT_TEXT("report", "unidir. repeatability")};

constexpr std::array rows1988{
    Row{{"A", {"A"}, REPORT_TEXT_FOR("report", "accuracy of an axis", "A"), "2.13", "A", {REPORT_TEXT_FOR("report", "accuracy", "1988")}}, both, &accuracy, at20},
    Row{{"A+", {"A↑"}, REPORT_TEXT("report", "accuracy of an axis, unidirectional"), "2.13", "A", unidirectionalAccuracy1988, detail}, upOnly, &accuracyUp, at20},
    Row{{"A-", {"A↓"}, REPORT_TEXT("report", "accuracy of an axis, unidirectional"), "2.13", "A", unidirectionalAccuracy1988, detail}, downOnly, &accuracyDown, at20},
    Row{{"R", {"R"}, REPORT_TEXT("report", "bi-directional repeatability of positioning of an axis"), "2.12", "R", {REPORT_TEXT("report", "repeatability")}}, both, &repeatabilityOfAxis},
    Row{{"R+", {"R↑"}, REPORT_TEXT("report", "unidirectional repeatability of positioning of an axis"), "2.12", "R", unidirectionalRepeatability, detail}, upOnly, &repeatabilityUp},
    Row{{"R-", {"R↓"}, REPORT_TEXT("report", "unidirectional repeatability of positioning of an axis"), "2.12", "R", unidirectionalRepeatability, detail}, downOnly, &repeatabilityDown},
    Row{{"Bmean", {"B̄"}, REPORT_TEXT_FOR("report", "mean reversal value of an axis", "1988"), "6.3", "B", {REPORT_TEXT_FOR("report", "mean reversal value", "1988")}}, bothWays, &meanReversal},
    Row{{"r", {"r̄"}, REPORT_TEXT("report", "mean repeatability"), "7", "r", {}, mainRow, onRequest}, both, &meanRepeatability},
    Row{{"r+", {"r̄↑"}, REPORT_TEXT("report", "mean repeatability"), "7", "r", {}, detail, onRequest}, upOnly, &meanRepeatabilityUp},
    Row{{"r-", {"r̄↓"}, REPORT_TEXT("report", "mean repeatability"), "7", "r", {}, detail, onRequest}, downOnly, &meanRepeatabilityDown},
};

constexpr std::array rows2006{
    Row{{"A", {"A"}, REPORT_TEXT("report", "bi-directional accuracy of positioning of an axis"), "2.24", "A", {REPORT_TEXT("report", "accuracy")}}, both, &accuracy, at20},
    Row{{"A+", {"A↑"}, REPORT_TEXT("report", "unidirectional accuracy of positioning of an axis"), "2.23", "A", unidirectionalAccuracy, detail}, upOnly, &accuracyUp, at20},
    Row{{"A-", {"A↓"}, REPORT_TEXT("report", "unidirectional accuracy of positioning of an axis"), "2.23", "A", unidirectionalAccuracy, detail}, downOnly, &accuracyDown, at20},
    Row{{"E", {"E"}, REPORT_TEXT("report", "bi-directional systematic positional deviation of an axis"), "2.21", "E", {REPORT_TEXT("report", "systematic deviation")}}, bothWays, &systematic, at20},
    Row{{"E+", {"E↑"}, REPORT_TEXT("report", "unidirectional systematic positional deviation of an axis"), "2.20", "E", unidirectionalDeviation, detail}, upward, &systematicUp, at20},
    Row{{"E-", {"E↓"}, REPORT_TEXT("report", "unidirectional systematic positional deviation of an axis"), "2.20", "E", unidirectionalDeviation, detail}, downward, &systematicDown, at20},
    Row{{"M", {"M"}, REPORT_TEXT("report", "range of the mean bi-directional positional deviation of an axis"), "2.22", "M", {REPORT_TEXT("report", "range of x̄")}}, bothWays, &meanRange, at20},
    Row{{"R", {"R"}, REPORT_TEXT("report", "bi-directional repeatability of positioning of an axis"), "2.19", "R", {REPORT_TEXT("report", "repeatability")}}, both, &repeatabilityOfAxis},
    Row{{"R+", {"R↑"}, REPORT_TEXT("report", "unidirectional repeatability of positioning of an axis"), "2.18", "R", unidirectionalRepeatability, detail}, upOnly, &repeatabilityUp},
    Row{{"R-", {"R↓"}, REPORT_TEXT("report", "unidirectional repeatability of positioning of an axis"), "2.18", "R", unidirectionalRepeatability, detail}, downOnly, &repeatabilityDown},
    Row{{"B", {"B"}, REPORT_TEXT("report", "reversal value of an axis"), "2.13", "B", {REPORT_TEXT("report", "reversal value")}}, bothWays, &reversal},
    Row{{"Bmean", {"B̄"}, REPORT_TEXT("report", "mean reversal value of an axis"), "2.14", "B", {REPORT_TEXT("report", "signed mean"), REPORT_TEXT("report", "mean reversal value")}, detail}, bothWays, &meanReversal},
};

/// Only clauses 3.18 to 3.22, 3.26 and 3.27 of 2014 were seen: no others are printed.
constexpr std::array rows2014{
    Row{{"A", {"A"}, REPORT_TEXT("report", "bi-directional positioning accuracy of an axis"), "3.27", "A", {REPORT_TEXT("report", "accuracy")}}, both, &accuracy, at20},
    Row{{"A+", {"A↑"}, REPORT_TEXT("report", "unidirectional positioning accuracy of an axis"), "3.26", "A", unidirectionalAccuracy, detail}, upOnly, &accuracyUp, at20},
    Row{{"A-", {"A↓"}, REPORT_TEXT("report", "unidirectional positioning accuracy of an axis"), "3.26", "A", unidirectionalAccuracy, detail}, downOnly, &accuracyDown, at20},
    Row{{"E", {"E"}, REPORT_TEXT("report", "bi-directional systematic positioning error of an axis"), "", "E", {REPORT_TEXT("report", "systematic error")}}, bothWays, &systematic, at20},
    Row{{"E+", {"E↑"}, REPORT_TEXT("report", "unidirectional systematic positioning error of an axis"), "", "E", unidirectionalError, detail}, upward, &systematicUp, at20},
    Row{{"E-", {"E↓"}, REPORT_TEXT("report", "unidirectional systematic positioning error of an axis"), "", "E", unidirectionalError, detail}, downward, &systematicDown, at20},
    Row{{"M", {"M"}, REPORT_TEXT("report", "mean bi-directional positioning error of an axis"), "", "M", {REPORT_TEXT("report", "range of x̄")}}, bothWays, &meanRange, at20},
    Row{{"R", {"R"}, REPORT_TEXT("report", "bi-directional positioning repeatability of an axis"), "3.22", "R", {REPORT_TEXT("report", "repeatability")}}, both, &repeatabilityOfAxis},
    Row{{"R+", {"R↑"}, REPORT_TEXT("report", "unidirectional positioning repeatability of an axis"), "3.21", "R", unidirectionalRepeatability, detail}, upOnly, &repeatabilityUp},
    Row{{"R-", {"R↓"}, REPORT_TEXT("report", "unidirectional positioning repeatability of an axis"), "3.21", "R", unidirectionalRepeatability, detail}, downOnly, &repeatabilityDown},
    Row{{"UPR", {"UPR"}, REPORT_TEXT("report", "unidirectional positioning repeatability (UPR)"), "", "UPR", {REPORT_TEXT("report", "smaller of R↑, R↓")}}, both, &smallerRepeatability},
    Row{{"B", {"B"}, REPORT_TEXT("report", "reversal error of an axis"), "", "B", {REPORT_TEXT("report", "reversal error")}}, bothWays, &reversal},
    Row{{"Bmean", {"B̄"}, REPORT_TEXT("report", "mean reversal error of an axis"), "", "B", {REPORT_TEXT("report", "signed mean"), REPORT_TEXT("report", "mean reversal error")}, detail}, bothWays, &meanReversal},
};

constexpr std::array rowsVdi3441{
    Row{{"P", {"P"}, REPORT_TEXT("report", "positional uncertainty (VDI: Positionsunsicherheit)"), "", "P", {REPORT_TEXT("report", "positional uncertainty")}}, both, &vdiUncertainty, at20},
    Row{{"Pa", {"Pa"}, REPORT_TEXT("report", "positional deviation (VDI: Positionsabweichung)"), "", "P", {REPORT_TEXT_FOR("report", "positional deviation", "VDI")}}, bothWays, &meanRange, at20},
    Row{{"Psmax", {"Ps", "max"}, REPORT_TEXT("report", "positional scatter (VDI: Positionsstreubreite), largest"), "", "P", {REPORT_TEXT("report", "scatter, largest")}}, both, &vdiScatter},
    Row{{"Psmean", {"P̄s"}, REPORT_TEXT("report", "positional scatter (VDI: Positionsstreubreite), mean"), "", "P", {REPORT_TEXT("report", "scatter, mean")}, detail}, both, &vdiMeanScatter},
    Row{{"Umax", {"U", "max"}, REPORT_TEXT("report", "reversal range (VDI: Umkehrspanne), largest"), "", "U", {REPORT_TEXT("report", "reversal range, largest")}}, bothWays, &reversal},
    Row{{"Umean", {"Ū"}, REPORT_TEXT("report", "reversal range (VDI: Umkehrspanne), mean"), "", "U", {REPORT_TEXT("report", "reversal range, mean")}, detail}, bothWays, &vdiMeanReversal},
};

constexpr std::array targets1988{
    TargetTerm{"mean+", {"x̄", "j", "↑"}, REPORT_TEXT_FOR("report", "mean unidirectional positional deviation at a position", "1988"), "2.6", upward},
    TargetTerm{"mean-", {"x̄", "j", "↓"}, REPORT_TEXT_FOR("report", "mean unidirectional positional deviation at a position", "1988"), "2.6", downward},
    TargetTerm{"mean", {"x̄", "j"}, REPORT_TEXT("report", "mean bi-directional positional deviation at a position"), "", bothWays, detail},
    TargetTerm{"reversal", {"B", "j"}, REPORT_TEXT_FOR("report", "reversal value at a position", "1988"), "2.7", bothWays, mainRow, "B"},
    TargetTerm{"range+", {"W", "j", "↑"}, REPORT_TEXT("report", "range of the positional deviation"), "2.8", upward | byRange},
    TargetTerm{"range-", {"W", "j", "↓"}, REPORT_TEXT("report", "range of the positional deviation"), "2.8", downward | byRange},
    TargetTerm{"s+", {"s", "j", "↑"}, REPORT_TEXT("report", "estimator of the standard deviation"), "2.9", upOnly},
    TargetTerm{"s-", {"s", "j", "↓"}, REPORT_TEXT("report", "estimator of the standard deviation"), "2.9", downOnly},
    TargetTerm{"R+", {"R", "j", "↑"}, REPORT_TEXT_FOR("report", "unidirectional repeatability of positioning at a position", "1988"), "2.10", upOnly, detail, "R+"},
    TargetTerm{"R-", {"R", "j", "↓"}, REPORT_TEXT_FOR("report", "unidirectional repeatability of positioning at a position", "1988"), "2.10", downOnly, detail, "R-"},
    TargetTerm{"R", {"R", "j"}, REPORT_TEXT_FOR("report", "bi-directional repeatability of positioning at a position", "1988"), "2.11", both, mainRow, "R"},
};

constexpr std::array targets2006{
    TargetTerm{"mean+", {"x̄", "i", "↑"}, REPORT_TEXT("report", "mean unidirectional positional deviation at a position"), "2.10", upward},
    TargetTerm{"mean-", {"x̄", "i", "↓"}, REPORT_TEXT("report", "mean unidirectional positional deviation at a position"), "2.10", downward},
    TargetTerm{"mean", {"x̄", "i"}, REPORT_TEXT("report", "mean bi-directional positional deviation at a position"), "2.11", bothWays, detail},
    TargetTerm{"reversal", {"B", "i"}, REPORT_TEXT("report", "reversal value at a position"), "2.12", bothWays, mainRow, "B"},
    TargetTerm{"s+", {"s", "i", "↑"}, REPORT_TEXT("report", "estimator of the unidirectional axis repeatability of positioning at a position"), "2.15", upOnly},
    TargetTerm{"s-", {"s", "i", "↓"}, REPORT_TEXT("report", "estimator of the unidirectional axis repeatability of positioning at a position"), "2.15", downOnly},
    TargetTerm{"R+", {"R", "i", "↑"}, REPORT_TEXT("report", "unidirectional repeatability of positioning at a position"), "2.16", upOnly, detail, "R+"},
    TargetTerm{"R-", {"R", "i", "↓"}, REPORT_TEXT("report", "unidirectional repeatability of positioning at a position"), "2.16", downOnly, detail, "R-"},
    TargetTerm{"R", {"R", "i"}, REPORT_TEXT("report", "bi-directional repeatability of positioning at a position"), "2.17", both, mainRow, "R"},
};

constexpr std::array targets2014{
    TargetTerm{"mean+", {"x̄", "i", "↑"}, REPORT_TEXT("report", "mean unidirectional positioning deviation at a position"), "", upward},
    TargetTerm{"mean-", {"x̄", "i", "↓"}, REPORT_TEXT("report", "mean unidirectional positioning deviation at a position"), "", downward},
    TargetTerm{"mean", {"x̄", "i"}, REPORT_TEXT("report", "mean bi-directional positioning deviation at a position"), "", bothWays, detail},
    TargetTerm{"reversal", {"B", "i"}, REPORT_TEXT("report", "reversal error at a position"), "", bothWays, mainRow, "B"},
    TargetTerm{"s+", {"s", "i", "↑"}, REPORT_TEXT("report", "estimator for unidirectional axis positioning repeatability at a position"), "3.18", upOnly},
    TargetTerm{"s-", {"s", "i", "↓"}, REPORT_TEXT("report", "estimator for unidirectional axis positioning repeatability at a position"), "3.18", downOnly},
    TargetTerm{"R+", {"R", "i", "↑"}, REPORT_TEXT("report", "unidirectional positioning repeatability at a position"), "3.19", upOnly, detail, "R+"},
    TargetTerm{"R-", {"R", "i", "↓"}, REPORT_TEXT("report", "unidirectional positioning repeatability at a position"), "3.19", downOnly, detail, "R-"},
    TargetTerm{"R", {"R", "i"}, REPORT_TEXT("report", "bi-directional positioning repeatability at a position"), "3.20", both, mainRow, "R"},
};

constexpr std::array targetsVdi3441{
    TargetTerm{"mean+", {"x̄", "i", "↑"}, REPORT_TEXT("report", "mean unidirectional positional deviation at a position"), "", upward},
    TargetTerm{"mean-", {"x̄", "i", "↓"}, REPORT_TEXT("report", "mean unidirectional positional deviation at a position"), "", downward},
    TargetTerm{"mean", {"x̄", "i"}, REPORT_TEXT("report", "mean bi-directional positional deviation at a position"), "", bothWays, detail},
    TargetTerm{"U", {"U", "i"}, REPORT_TEXT("report", "reversal range (VDI: Umkehrspanne) at a position"), "", bothWays, mainRow, "Umax"},
    TargetTerm{"s+", {"s", "i", "↑"}, REPORT_TEXT("report", "estimator of the unidirectional axis repeatability of positioning at a position"), "", upOnly},
    TargetTerm{"s-", {"s", "i", "↓"}, REPORT_TEXT("report", "estimator of the unidirectional axis repeatability of positioning at a position"), "", downOnly},
    TargetTerm{"Ps", {"Ps", "i"}, REPORT_TEXT("report", "positional scatter (VDI: Positionsstreubreite) at a position"), "", both, mainRow, "Psmax"},
};
// clang-format on

template <std::size_t n>
constexpr std::array<Row, n> withoutClauses(std::array<Row, n> rows) {
    for (Row &row : rows)
        row.term.clause = "";
    return rows;
}

template <std::size_t n>
constexpr std::array<TargetTerm, n> withoutClauses(std::array<TargetTerm, n> rows) {
    for (TargetTerm &term : rows)
        term.clause = "";
    return rows;
}

constexpr auto rows2006WithoutClauses = withoutClauses(rows2006);
constexpr auto rows2014WithoutClauses = withoutClauses(rows2014);
constexpr auto targets2006WithoutClauses = withoutClauses(targets2006);
constexpr auto targets2014WithoutClauses = withoutClauses(targets2014);

constexpr Text title1988 =
    REPORT_TEXT("report", "Acceptance code for machine tools — Part 2: Determination of accuracy and "
                          "repeatability of positioning of numerically controlled machine tools");
constexpr Text title2006 =
    REPORT_TEXT("report", "Test code for machine tools — Part 2: Determination of accuracy and "
                          "repeatability of positioning numerically controlled axes");

constexpr Text standardCycle1988 = REPORT_TEXT_FOR("report", "linear cycle", "1988");
constexpr Text stepCycle1988 = REPORT_TEXT_FOR("report", "pilgrim step cycle", "1988");
constexpr Text standardCycle2006 = REPORT_TEXT("report", "standard test cycle");
constexpr Text stepCycle2006 = REPORT_TEXT("report", "step cycle");

Edition iso1988(const char *word) {
    return {.word = word,
            .family = "ISO 230-2:1988",
            .title = title1988,
            .environment = REPORT_TEXT_FOR("report", "Environment", "1988"),
            .unloaded = REPORT_TEXT_FOR("report", "machine unloaded", "1988"),
            .agreedBetween = REPORT_TEXT_FOR("report", "between supplier/manufacturer and user", "1988"),
            .c = 3,
            .rangeMethod = true,
            .standardCycle = standardCycle1988,
            .stepCycle = stepCycle1988,
            .targetRule = TargetRule::pitches1988,
            .targetLetter = "j",
            .runLetter = "i",
            .rows = rows1988,
            .targetTerms = targets1988,
            .textRead = TextRead::all,
            .requirements = demandsOf("ISO 230-2:1988").requirements,
            .resultsClause = "6.1, 6.2, 6.3",
            .points = demandsOf("ISO 230-2:1988").points,
            .pointsClause = "8"};
}

/// 1997 and its aliases: arithmetic and names of 2006; clauses unknown.
Edition iso1997(const char *word) {
    return {.word = word,
            .family = "ISO 230-2:1997",
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows2006WithoutClauses,
            .targetTerms = targets2006WithoutClauses,
            .requirements = demandsOf("ISO 230-2:1997").requirements,
            .points = demandsOf("ISO 230-2:1997").points};
}

Edition iso2006() {
    return {.word = "ISO 230-2:2006",
            .family = "ISO 230-2:2006",
            .title = title2006,
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows2006,
            .targetTerms = targets2006,
            .textRead = TextRead::part,
            .stepCycleByAgreement = true,
            .requirements = demandsOf("ISO 230-2:2006").requirements,
            .points = demandsOf("ISO 230-2:2006").points};
}

Edition aliasOf2006(const char *word) {
    return {.word = word,
            .family = "ISO 230-2:2006",
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows2006WithoutClauses,
            .targetTerms = targets2006WithoutClauses,
            .requirements = demandsOf("ISO 230-2:2014").requirements,
            .points = demandsOf("ISO 230-2:2014").points};
}

Edition iso2014(const char *word, bool isDefault, std::span<const Row> rows,
                std::span<const TargetTerm> targetTerms) {
    return {.word = word,
            .family = "ISO 230-2:2014",
            .deviation = REPORT_TEXT("report", "Positioning deviation"),
            .deviations = REPORT_TEXT("report", "positioning deviations"),
            .deviationsOfAxis = REPORT_TEXT("report", "Positioning deviations of the %1 axis"),
            .isDefault = isDefault,
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows,
            .targetTerms = targetTerms,
            .requirements = demandsOf("ISO 230-2:2014").requirements,
            .points = demandsOf("ISO 230-2:2014").points};
}

Edition aliasOf2014(const char *word) {
    return iso2014(word, false, rows2014WithoutClauses, targets2014WithoutClauses);
}

/// Bands and s as in its own texts: six sigma, so c = 3.
Edition vdi3441() {
    return {.word = "VDI/DGQ 3441:1977",
            .family = "VDI/DGQ 3441:1977",
            .c = 3,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rowsVdi3441,
            .targetTerms = targetsVdi3441,
            .requirements = demandsOf("VDI/DGQ 3441:1977").requirements};
}

} // namespace

std::span<const Edition> editions() {
    static const std::vector<Edition> table{
        iso1988("ISO 230-2:1988"),
        iso1997("ISO 230-2:1997"),
        iso2006(),
        iso2014("ISO 230-2:2014", true, rows2014, targets2014),
        vdi3441(),
        iso1997("GB/T 17421.2-2000"),
        aliasOf2006("GB/T 17421.2-2016"),
        aliasOf2014("GB/T 17421.2-2023"),
        aliasOf2006("JIS B 6190-2:2008"),
        aliasOf2014("JIS B 6190-2:2016"),
        aliasOf2014("GOST ISO 230-2-2016"),
    };
    return table;
}

} // namespace palmer::iso230_2
