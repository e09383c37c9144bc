// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/compare.h"

#include <algorithm>
#include <cstdint>

namespace palmer {

namespace {

constexpr std::size_t around = 4;             ///< words of context on each side
constexpr std::size_t mostCells = 16'000'000; ///< in the table of common words
constexpr qsizetype longestText = 300;        ///< in a difference

/// A range of words in each of the two sequences.
struct Gap {
    std::size_t printedFrom = 0, printedTo = 0;
    std::size_t followsFrom = 0, followsTo = 0;
};

bool same(const PrintedWord &a, const PrintedWord &b) {
    return a.text == b.text;
}

/// The runs of words outside the longest common subsequence.
class WordAlignment {
public:
    WordAlignment(const PrintedWords &printed, const PrintedWords &follows)
        : m_printed(printed)
        , m_follows(follows) {
        std::size_t begin = 0;
        while (begin < std::min(printed.size(), follows.size()) && same(printed[begin], follows[begin]))
            ++begin;
        std::size_t endPrinted = printed.size();
        std::size_t endFollows = follows.size();
        while (endPrinted > begin && endFollows > begin &&
               same(printed[endPrinted - 1], follows[endFollows - 1])) {
            --endPrinted;
            --endFollows;
        }
        align({begin, endPrinted, begin, endFollows});
    }

    [[nodiscard]] const std::vector<Gap> &gaps() const { return m_gaps; }

private:
    void add(const Gap &gap) {
        if (gap.printedFrom < gap.printedTo || gap.followsFrom < gap.followsTo)
            m_gaps.push_back(gap);
    }

    void align(const Gap &middle) {
        const std::size_t rows = middle.printedTo - middle.printedFrom;
        const std::size_t columns = middle.followsTo - middle.followsFrom;
        if (rows == 0 || columns == 0 || (rows + 1) * (columns + 1) > mostCells) {
            add(middle);
            return;
        }
        // common[i][j]: length of the common subsequence from row i and column j on.
        std::vector<std::uint32_t> common((rows + 1) * (columns + 1), 0);
        const auto cell = [&](std::size_t i, std::size_t j) -> std::uint32_t & {
            return common[i * (columns + 1) + j];
        };
        const auto equal = [&](std::size_t i, std::size_t j) {
            return same(m_printed[middle.printedFrom + i], m_follows[middle.followsFrom + j]);
        };
        for (std::size_t i = rows; i-- > 0;) {
            for (std::size_t j = columns; j-- > 0;)
                cell(i, j) = equal(i, j) ? cell(i + 1, j + 1) + 1 : std::max(cell(i + 1, j), cell(i, j + 1));
        }
        Gap gap{middle.printedFrom, middle.printedFrom, middle.followsFrom, middle.followsFrom};
        for (std::size_t i = 0, j = 0; i < rows || j < columns;) {
            if (i < rows && j < columns && equal(i, j)) {
                add(gap);
                ++i;
                ++j;
                gap = {middle.printedFrom + i, middle.printedFrom + i, middle.followsFrom + j,
                       middle.followsFrom + j};
            } else if (j >= columns || (i < rows && cell(i + 1, j) >= cell(i, j + 1))) {
                gap.printedTo = middle.printedFrom + ++i;
            } else {
                gap.followsTo = middle.followsFrom + ++j;
            }
        }
        add(gap);
    }

    const PrintedWords &m_printed;
    const PrintedWords &m_follows;
    std::vector<Gap> m_gaps;
};

QString textOf(const PrintedWords &words, std::size_t from, std::size_t to) {
    QString text;
    for (std::size_t i = from; i < to && text.size() < longestText; ++i)
        text += (i == from ? QString() : QStringLiteral(" ")) + words[i].text;
    if (text.size() > longestText)
        text = text.left(longestText) + u'…';
    return text;
}

QRectF areaOf(const PrintedWords &words, std::size_t from, std::size_t to) {
    QRectF area;
    for (std::size_t i = from; i < to; ++i)
        area |= words[i].area;
    return area;
}

} // namespace

std::vector<Difference> compareWords(const PrintedWords &printed, const PrintedWords &follows, int page) {
    std::vector<Difference> result;
    const WordAlignment alignment(printed, follows);
    for (const Gap &gap : alignment.gaps()) {
        const bool stands = gap.printedFrom < gap.printedTo;
        const std::size_t before = gap.followsFrom - std::min(gap.followsFrom, around);
        const std::size_t after = std::min(gap.followsTo + around, follows.size());
        result.push_back({page,
                          stands ? areaOf(printed, gap.printedFrom, gap.printedTo)
                                 : areaOf(follows, gap.followsFrom, gap.followsTo),
                          textOf(printed, gap.printedFrom, gap.printedTo),
                          textOf(follows, gap.followsFrom, gap.followsTo),
                          textOf(follows, before, after),
                          {}});
    }
    return result;
}

} // namespace palmer
