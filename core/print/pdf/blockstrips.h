// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/strip.h"
#include "report/blocks/report.h"

namespace palmer {

/// Converts all blocks to strips, in order, with the gaps between them. `width`: of the text, points;
/// `tallest`: height of an empty page. Running heads are strips without height.
[[nodiscard]] Strips blockStrips(const std::vector<Block> &blocks, double width, double tallest);

/// True if the block begins a section.
[[nodiscard]] bool beginsSection(const Block &block);

/// True for running heads and page breaks.
[[nodiscard]] bool isMark(const Block &block);

} // namespace palmer
