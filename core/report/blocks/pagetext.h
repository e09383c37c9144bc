// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QString>

namespace palmer {

/// The words of a report as its pages carry them, block by block in the order they are drawn: what the text
/// of the PDF is compared with, white space and compatibility forms apart, and what tests store.
///
/// One line for each line of a paragraph, for a row of a table (cells from left to right, two spaces between
/// them) and for a label with its value; the head of a table is a line of titles and a line of units; a
/// dash stands where a value is missing. Side by side: all of the left, then all of the right. Figures give
/// their words in a fixed order: both axes with title and ticks, dimensions, legend; their painter may draw
/// these in another. What pages repeat is no part of it: running heads, footers, the head of a table that
/// continues; nor are marks and pictures. Pages of anchors that are not put in yet are dashes.
[[nodiscard]] QString pageText(const Report &report);

/// The words of one block; lines end in '\n'.
[[nodiscard]] QString pageText(const Block &block);

} // namespace palmer
