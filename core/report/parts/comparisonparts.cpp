// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/comparedtests.h"
#include "report/parts/comparedtests.h"
#include "report/parts/parts.h"

#include <algorithm>
#include <iterator>

namespace palmer {

void addStatedComparisons(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    for (const TestPart &part : parts) {
        const auto stated = statedComparison(part.evaluated, part.index);
        if (!stated)
            continue;
        const Writer &write = part.write;
        const PlacedTest before{&part.evaluated, stated->other};
        const PlacedTest after{&part.evaluated, part.index};
        const auto other = std::ranges::find(parts, stated->other, &TestPart::index);
        TestHead head = comparisonHead(part, other == parts.end() ? part : *other);
        // Precedes the break, since the page has a head of its own.
        blocks.emplace_back(PageBreak{});
        blocks.emplace_back(
            RunningHead{head.laboratory, joined({head.title, head.subtitle}, QStringLiteral(" · "))});
        blocks.emplace_back(std::move(head));
        if (VerdictLine line = decisionLine(stated->comparison, write.language()); !line.word.isEmpty())
            blocks.emplace_back(std::move(line));
        std::ranges::move(
            comparisonBlocks(stated->comparison, before, after, write.language(), stated->options.tolerance),
            std::back_inserter(blocks));
        if (stated->options.setUpUntouched)
            blocks.emplace_back(Paragraph{
                write.text(REPORT_TEXT("report",
                                       "Stated: the instrument stood as it had been aligned for the "
                                       "other test.")),
                TextSize::small});
    }
}

} // namespace palmer
