// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/rules.h"
#include "report/blocks/report.h"

#include <QPointF>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QPainter;

namespace palmer {

/// A piece of a column that stays on one page: a heading, a row of a table, a figure. Lengths in points. What
/// it draws it holds, so strips may be kept and copied.
struct Strip {
    double height = 0;
    std::function<void(QPainter &, QPointF topLeft)> draw;
    double gap = 0;       ///< above it, unless it begins a page
    bool section = false; ///< begins a section: its gap may grow, and it needs room below it
    bool title = false;   ///< of a test: stands above its first section
    bool filler = false;  ///< begins a section that may stand before others of its test, to fill a page
    bool verdict = false; ///< ends the results of a test, for which gaps give way
    double least = 0;     ///< of a figure: the height down to which it gives way, too
    std::function<std::function<void(QPainter &, QPointF)>(double height)>
        drawOf;                  ///< of a figure: at a height
    bool withNext = false;       ///< never the last of a page
    double closingRule = 0;      ///< length of the rule below it where its table is split
    std::shared_ptr<Strip> head; ///< of the table it continues: repeated where it begins a page
    bool pageBreak = false;      ///< nothing but the end of a page
    bool soft = false; ///< of such an end: not of a page that only goes on with what stands before it
    std::optional<RunningHead> running; ///< nothing but the running head from here on
    int block = -1;                     ///< index of the block that it begins
    QString link;                       ///< the anchor it leads to
};

constexpr double sectionGap = 6 * mm; ///< usual gap above a section

using Strips = std::vector<Strip>;

} // namespace palmer
