// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/editions.h"

#include "kernel/measurement/testfacts.h"

#include <array>
#include <vector>

namespace palmer::iso230_4 {

namespace {

constexpr Text title =
    REPORT_TEXT("report", "Test code for machine tools — Part 4: Circular tests for numerically controlled "
                          "machine tools");

PointRole warmUpPoint(const Test &test) {
    const Conditions *conditions = conditionsOf(test);
    return conditions && conditions->warmUp.specifiedBy == SpecifiedBy::maker ? PointRole::notApplicable
                                                                              : PointRole::listed;
}

constexpr std::array points2005{
    AgreementPoint{"warmUp", "a", REPORT_TEXT("report", "warm-up"), warmUpPoint},
    AgreementPoint{"testParameters", "b", REPORT_TEXT("report", "test parameters")},
    AgreementPoint{"results", "c", REPORT_TEXT("report", "which of the results are required")},
};

/// The same for editions whose text was not read: no letters.
constexpr auto pointsOfOthers = [] {
    auto result = points2005;
    for (AgreementPoint &point : result)
        point.letter = "";
    return result;
}();

Edition unread(const char *word, const CircularRules &rules) {
    return {
        .word = word, .family = word, .kind = Kind::circular, .points = pointsOfOthers, .circles = &rules};
}

Edition iso2005() {
    return {.word = "ISO 230-4:2005",
            .family = "ISO 230-4:2005",
            .kind = Kind::circular,
            .title = title,
            .isDefault = true,
            .textRead = TextRead::all,
            .points = points2005,
            .pointsClause = "7",
            .parametersClause = "4.4",
            .circles = &rules2005()};
}

} // namespace

std::span<const Edition> editions() {
    static const std::vector<Edition> table{
        unread("ISO 230-4:1996", rules1996()),
        iso2005(),
        unread("ISO 230-4:2022", rules2022()),
    };
    return table;
}

} // namespace palmer::iso230_4
