#include "kernel/evaluation/iso230_4/editions.h"

#include "kernel/evaluation/iso230_4/rules.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palmer::iso230_4 {

namespace {

constexpr Text title =
    REPORT_TEXT("report", "Test code for machine tools — Part 4: Circular tests for numerically controlled "
                          "machine tools");

constexpr std::array<std::string_view, 9> quantities{"G", "G(b)", "F",  "Fmax", "Fmin",
                                                     "D", "H",    "Gf", "G(b)f"};

constexpr std::array points{
    AgreementPoint{"warmUp", "a", REPORT_TEXT("report", "warm-up")},
    AgreementPoint{"testParameters", "b", REPORT_TEXT("report", "test parameters")},
    AgreementPoint{"results", "c", REPORT_TEXT("report", "which of the results are required")},
};

Edition edition(const char *word, const char *statementsClause, const char *pointsClause,
                const CircularRules &rules) {
    return {.word = word,
            .family = word,
            .kind = Kind::circular,
            .title = title,
            .statementsClause = statementsClause,
            .points = points,
            .pointsClause = pointsClause,
            .circles = &rules};
}

} // namespace

std::span<const Edition> editions() {
    static const std::vector<Edition> table{
        edition("ISO 230-4:1996", "", "", rules1996()),
        edition("ISO 230-4:2005", "4.4", "7", rules2005()),
        edition("ISO 230-4:2022", "", "", rules2022()),
    };
    return table;
}

bool isQuantity(std::string_view id) {
    return std::ranges::find(quantities, id) != quantities.end();
}

} // namespace palmer::iso230_4
