// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/rules.h"
#include "print/pdf/textblock.h"
#include "report/blocks/report.h"

#include <functional>
#include <memory>
#include <optional>

namespace palmer {

/// Converts a phrase to formatted text. `bold`: everything except muted spans.
[[nodiscard]] RichText richText(const Phrase &phrase, bool bold = false);

/// Placeholder for missing values.
inline const QString thinDash = QStringLiteral("–");

/// The room of a piece of a column that stays on one page: of a heading, a table row, a figure. Lengths in
/// points. Small, for a long report has a hundred thousand of them; what it draws is made when its page is.
struct StripPlace {
    double height = 0;
    double gap = 0;         ///< above it, except at the top of a page
    double least = 0;       ///< least height of a figure
    double closingRule = 0; ///< length of the rule below it if its table is split here
    bool section = false;   ///< begins a section: its gap may grow, and it needs space below
    bool title = false;     ///< title of a test: precedes its first section
    bool filler = false;    ///< begins a section that may be moved forward in its test to fill a page
    bool whole = false;    ///< end of a table that is not split: gaps on the page of a head may shrink for it
    bool inText = false;   ///< a line of a paragraph
    bool drawn = false;    ///< draws anything
    bool lowers = false;   ///< a figure that can be drawn lower
    bool lowered = false;  ///< and is
    bool withNext = false; ///< never the last strip of a page
    bool pageBreak = false;                     ///< only a page break
    bool soft = false;                          ///< page break that is ignored on a page with a running head
    bool narrow = false;                        ///< what follows is closer to the running head
    int block = -1;                             ///< index of the block it begins
    int owner = -1;                             ///< index of its block
    int index = 0;                              ///< among the strips of its block
    std::shared_ptr<const StripPlace> head;     ///< head of its table, repeated at the top of a page
    std::shared_ptr<const RunningHead> running; ///< only sets the running head from here on
    QString link;                               ///< anchor of its link target
};

using StripPlaces = std::vector<StripPlace>;

/// A piece with what it draws, which it owns.
struct Strip : StripPlace {
    std::function<void(QPainter &, QPointF topLeft)> draw;
    std::function<std::function<void(QPainter &, QPointF)>(double height)>
        drawOf; ///< figure: returns `draw` for a height
};

constexpr double sectionGap = 6 * mm; ///< usual gap above a section

using Strips = std::vector<Strip>;

/// Converts all blocks to strips, in order, with the gaps between them. `width`: of the text, points;
/// `tallest`: height of an empty page. Running heads are strips without height.
[[nodiscard]] Strips blockStrips(const std::vector<Block> &blocks, double width, double tallest);

/// A block with its strips, which do not depend on its neighbours: blocks can be moved without measuring them
/// again.
template <class AnyStrip>
struct BlockWith {
    std::shared_ptr<Block> block; ///< shared by copies until one of them changes it
    std::vector<AnyStrip> strips;
    bool narrow = false; ///< measured with smaller text
    bool close = false;  ///< set narrow, with the least gaps
};
using MeasuredBlock = BlockWith<StripPlace>;
using MeasuredBlocks = std::vector<MeasuredBlock>;

/// Moves rows to the right column of one that is levelled, `width` and `tallest` as for its strips.
void levelColumns(SideBySide &both, double width, double tallest);

/// The strips of one block, without what depends on its neighbours. `narrow`: smaller text, less below a
/// running head. They own the block.
[[nodiscard]] Strips measured(const std::shared_ptr<const Block> &block, double width, double tallest,
                              bool narrow = false);

/// The same without what they draw.
[[nodiscard]] StripPlaces placesOf(const Strips &strips);

/// The strips of all blocks with the gaps between them.
[[nodiscard]] StripPlaces joined(const MeasuredBlocks &blocks);

/// The heading of the section that the block begins; null if it begins none.
[[nodiscard]] const Heading *sectionHeading(const Block &block);

/// True if the block begins a section.
[[nodiscard]] bool beginsSection(const Block &block);

/// True for running heads and page breaks.
[[nodiscard]] bool isMark(const Block &block);

/// A table as strips, `width` points wide: its head, then its rows. Numbers are aligned at the decimal mark,
/// the widest fraction of a column at the right edge. Text that is too wide for its column wraps; a row
/// higher than half a page is split between its lines. The rows are made again when they are drawn, which
/// takes less time than the memory of all.
[[nodiscard]] Strips tableStrips(const std::shared_ptr<const Table> &shared, double width);

/// Findings with mark, grade, sentence and clause.
[[nodiscard]] Strips findingStrips(const FindingsBlock &findings, double width);

} // namespace palmer
