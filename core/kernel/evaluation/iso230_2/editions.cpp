// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/editions.h"

#include <vector>

namespace palmer::iso230_2 {

namespace {

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
            .rows = rows1988(),
            .targetTerms = targetTerms1988(),
            .textRead = TextRead::all,
            .requirements = requirements1988(),
            .resultsClause = "6.1, 6.2, 6.3",
            .points = points1988(),
            .pointsClause = "8"};
}

/// 1997 and its aliases: arithmetic and names of 2006; clauses unknown.
Edition iso1997(const char *word) {
    return {.word = word,
            .family = "ISO 230-2:1997",
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows2006WithoutClauses(),
            .targetTerms = targetTerms2006WithoutClauses(),
            .requirements = requirements1997(),
            .points = points1997()};
}

Edition iso2006() {
    return {.word = "ISO 230-2:2006",
            .family = "ISO 230-2:2006",
            .title = title2006,
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows2006(),
            .targetTerms = targetTerms2006(),
            .textRead = TextRead::part,
            .stepCycleByAgreement = true,
            .requirements = requirements2006(),
            .points = points1997()};
}

Edition aliasOf2006(const char *word) {
    return {.word = word,
            .family = "ISO 230-2:2006",
            .c = 2,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rows2006WithoutClauses(),
            .targetTerms = targetTerms2006WithoutClauses(),
            .requirements = requirements2014(),
            .points = points1997()};
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
            .requirements = requirements2014(),
            .points = points1997()};
}

Edition aliasOf2014(const char *word) {
    return iso2014(word, false, rows2014WithoutClauses(), targetTerms2014WithoutClauses());
}

/// Bands and s as in its own texts: six sigma, so c = 3.
Edition vdi3441() {
    return {.word = "VDI/DGQ 3441:1977",
            .family = "VDI/DGQ 3441:1977",
            .c = 3,
            .standardCycle = standardCycle2006,
            .stepCycle = stepCycle2006,
            .rows = rowsVdi3441(),
            .targetTerms = targetTermsVdi3441(),
            .requirements = requirementsVdi3441()};
}

} // namespace

std::span<const Edition> editions() {
    static const std::vector<Edition> table{
        iso1988("ISO 230-2:1988"),
        iso1997("ISO 230-2:1997"),
        iso2006(),
        iso2014("ISO 230-2:2014", true, rows2014(), targetTerms2014()),
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
