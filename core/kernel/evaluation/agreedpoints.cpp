// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/agreedpoints.h"

#include "kernel/words/characters.h"

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

std::vector<const AgreementPoint *> furtherPoints(const Edition &edition, const Test &test) {
    std::vector<const AgreementPoint *> result;
    for (const AgreedPoint &stated : test.agreedPoints) {
        if (std::ranges::find(edition.points, stated.point, &AgreementPoint::point) != edition.points.end())
            continue;
        for (const Edition *other : editionsOf(edition.kind)) {
            const auto found = std::ranges::find(other->points, stated.point, &AgreementPoint::point);
            if (found == other->points.end())
                continue;
            result.push_back(&*found);
            break;
        }
    }
    return result;
}

PointRole roleOf(const AgreementPoint &point, const Test &test) {
    const PointRole byRule = point.role ? point.role(test) : PointRole::listed;
    const AgreedPoint *stated = agreedPoint(test, point.point);
    if (!stated)
        return byRule;
    if (stated->state == AgreementState::notApplicable && !(point.needsReason && isBlank(stated->text)))
        return PointRole::notApplicable;
    return byRule == PointRole::inRow ? byRule : PointRole::listed;
}

void findNotAgreed(const Edition &edition, const Test &test, std::vector<Finding> &findings) {
    const bool read = *edition.pointsClause != 0;
    for (const AgreementPoint &row : edition.points) {
        if (roleOf(row, test) != PointRole::listed || isAgreed(test, row.point))
            continue;
        Finding finding;
        finding.grade = read ? Grade::recommendation : Grade::note;
        finding.source = read ? Source::text : Source::practice;
        finding.subject = Subject::agreedPoints;
        finding.clause = edition.pointsClause;
        finding.id = finding.keys.emplace_back(std::string("agreedPoints.") + row.point);
        finding.name = row.name;
        finding.letter = row.letter;
        finding.missing = true;
        const AgreedPoint *stated = agreedPoint(test, row.point);
        const bool declared = stated && stated->state == AgreementState::notAgreed;
        if (read)
            finding.message.text =
                declared ? REPORT_TEXT("report", "To be agreed (clause %3), not agreed%2: %1.")
                         : REPORT_TEXT("report", "To be agreed (clause %3), not declared%2: %1.");
        else
            finding.message.text = declared ? REPORT_TEXT("report", "To be agreed, not agreed%2: %1.")
                                            : REPORT_TEXT("report", "To be agreed, not declared%2: %1.");
        finding.message.arguments = {row.name, std::string()};
        if (read)
            finding.message.arguments.emplace_back(finding.clause);
        findings.push_back(std::move(finding));
    }
}

} // namespace palmer
