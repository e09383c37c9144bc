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
        const PlacedTest before{&part.evaluated, stated->before};
        const PlacedTest after{&part.evaluated, stated->after};
        const auto partOf = [&](std::size_t test) -> const TestPart & {
            const auto found = std::ranges::find(parts, test, &TestPart::index);
            return found == parts.end() ? part : *found;
        };
        TestHead head = comparisonHead(partOf(stated->after), partOf(stated->before));
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
