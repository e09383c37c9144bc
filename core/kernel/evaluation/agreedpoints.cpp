#include "kernel/evaluation/agreedpoints.h"

#include <algorithm>

namespace palmer {

const AgreedPoint *agreedPoint(const Test &test, std::string_view point) {
    const auto found = std::ranges::find(test.agreedPoints, point, &AgreedPoint::point);
    return found == test.agreedPoints.end() ? nullptr : &*found;
}

bool isAgreed(const Test &test, std::string_view point) {
    const AgreedPoint *found = agreedPoint(test, point);
    return found && found->state == AgreementState::agreed;
}

void findNotAgreed(const Edition &edition, const Test &test, std::vector<Finding> &findings) {
    for (const AgreementPoint &row : edition.points) {
        const AgreedPoint *point = agreedPoint(test, row.point);
        if (!point || point->state == AgreementState::notAgreed)
            findings.push_back(
                {Grade::recommendation,
                 std::string("agreedPoints.") + row.point,
                 edition.pointsClause,
                 {REPORT_TEXT("report",
                              "To be agreed between supplier/manufacturer and user, not agreed: %1."),
                  {row.name}}});
    }
}

} // namespace palmer
