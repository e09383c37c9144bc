// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/accordance.h"

#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/requirement.h"

#include <algorithm>

namespace palmer {

bool countsForAccordance(const Finding &finding, bool wasRead) {
    return wasRead ? finding.source == Source::text && finding.grade == Grade::requirement
                   : finding.source == Source::practice && finding.state.has_value();
}

RequirementCounts countRequirements(std::span<const Finding> findings) {
    RequirementCounts counts;
    for (const Finding &finding : findings) {
        const bool unmet = finding.state == State::unmet;
        if (finding.source == Source::practice)
            counts.departures += unmet ? 1 : 0;
        else if (countsForAccordance(finding, true))
            ++(unmet ? counts.unmet : counts.undeclared);
    }
    return counts;
}

int countOpenInPractice(std::span<const Finding> findings) {
    return static_cast<int>(std::ranges::count_if(findings, [](const Finding &finding) {
        return finding.source == Source::practice && finding.state == State::undeclared;
    }));
}

Lack lackOf(const Finding &finding) {
    if (!finding.missing)
        return Lack::none;
    const bool ofConditions =
        finding.subject == Subject::conditions || finding.subject == Subject::namedInstruments;
    const bool isUsual = finding.source == Source::laboratory || finding.grade == Grade::note;
    return ofConditions && isUsual ? Lack::usual : Lack::required;
}

Accordance accordanceOf(std::span<const Finding> findings, const Edition *edition) {
    if (!edition || edition->textRead == TextRead::none)
        return Accordance::notChecked;
    const RequirementCounts counts = countRequirements(findings);
    if (counts.unmet > 0)
        return Accordance::no;
    if (counts.undeclared > 0)
        return Accordance::notShown;
    return edition->textRead == TextRead::part ? Accordance::partly : Accordance::yes;
}

Text missingText(Source source, std::optional<State> state) {
    if (source == Source::laboratory)
        return REPORT_TEXT("report", "Laboratory practice, not stated%2: %1.");
    return state == State::undeclared ? REPORT_TEXT("report", "Not declared%2: %1.")
                                      : REPORT_TEXT("report", "Not stated in the report%2: %1.");
}

} // namespace palmer
