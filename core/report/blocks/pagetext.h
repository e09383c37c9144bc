// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QString>
#include <functional>

namespace palmer {

/// The words of a report as printed, block by block in drawing order. The text of the PDF is compared with
/// it, except for white space and compatibility forms, and tests store it.
///
/// One line for each line of a paragraph, for a table row (cells from left to right, separated by two spaces)
/// and for a label with its value; a table head is a line of titles and a line of units; a dash replaces a
/// missing value. Side by side: the whole left column, then the right one. Figures give their words in a
/// fixed order: both axes with title and ticks, dimensions, legend; painters may draw them in another.
/// Repeated parts are not included (running heads, footers, the head of a continued table), nor marks and
/// pictures. Page numbers of anchors that are not filled in yet are dashes.
[[nodiscard]] QString pageText(const Report &report);

/// Calls `take` for each line of one block, without its '\n': a table may have a million.
void eachPageLine(const Block &block, const std::function<void(const QString &)> &take);

/// The words of one block; lines end in '\n'.
[[nodiscard]] QString pageText(const Block &block);

} // namespace palmer
