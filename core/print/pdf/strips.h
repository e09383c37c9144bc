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

/// A piece of a column that stays on one page: a heading, a table row, a figure. Lengths in points. It owns
/// what it draws, so strips may be stored and copied.
struct Strip {
    double height = 0;
    std::function<void(QPainter &, QPointF topLeft)> draw;
    double gap = 0;       ///< above it, except at the top of a page
    bool section = false; ///< begins a section: its gap may grow, and it needs space below
    bool title = false;   ///< title of a test: precedes its first section
    bool filler = false;  ///< begins a section that may be moved forward in its test to fill a page
    bool whole = false;   ///< end of a table that is not split: gaps on the page of a head may shrink for it
    double least = 0;     ///< least height of a figure
    std::function<std::function<void(QPainter &, QPointF)>(double height)>
        drawOf;                         ///< figure: returns `draw` for a height
    bool withNext = false;              ///< never the last strip of a page
    double closingRule = 0;             ///< length of the rule below it if its table is split here
    std::shared_ptr<Strip> head;        ///< head of its table, repeated at the top of a page
    bool pageBreak = false;             ///< only a page break
    bool soft = false;                  ///< page break that is ignored on a page with a running head
    std::optional<RunningHead> running; ///< only sets the running head from here on
    bool narrow = false;                ///< what follows is closer to the running head
    int block = -1;                     ///< index of the block it begins
    QString link;                       ///< anchor of its link target
};

constexpr double sectionGap = 6 * mm; ///< usual gap above a section

using Strips = std::vector<Strip>;

/// Converts all blocks to strips, in order, with the gaps between them. `width`: of the text, points;
/// `tallest`: height of an empty page. Running heads are strips without height.
[[nodiscard]] Strips blockStrips(const std::vector<Block> &blocks, double width, double tallest);

/// A block with its strips, which do not depend on its neighbours: blocks can be moved without measuring them
/// again.
struct MeasuredBlock {
    Block block;
    Strips strips;
    bool close = false; ///< set narrow, with the least gaps
};
using MeasuredBlocks = std::vector<MeasuredBlock>;

/// Moves rows to the right column of one that is levelled, `width` and `tallest` as for its strips.
void levelColumns(SideBySide &both, double width, double tallest);

/// The strips of one block, without what depends on its neighbours. `narrow`: smaller text, less below a
/// running head.
[[nodiscard]] Strips measured(const Block &block, double width, double tallest, bool narrow = false);

/// The strips of all blocks with the gaps between them.
[[nodiscard]] Strips joined(const MeasuredBlocks &blocks);

/// The heading of the section that the block begins; null if it begins none.
[[nodiscard]] const Heading *sectionHeading(const Block &block);

/// True if the block begins a section.
[[nodiscard]] bool beginsSection(const Block &block);

/// True for running heads and page breaks.
[[nodiscard]] bool isMark(const Block &block);

/// A table as strips, `width` points wide: its head, then its rows. Numbers are aligned at the decimal mark,
/// the widest fraction of a column at the right edge. Text that is too wide for its column wraps; a row
/// higher than half a page is split between its lines.
[[nodiscard]] Strips tableStrips(const Table &table, double width);

/// Findings with mark, grade, sentence and clause.
[[nodiscard]] Strips findingStrips(const FindingsBlock &findings, double width);

} // namespace palmer
