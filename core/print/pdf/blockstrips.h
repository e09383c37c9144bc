// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/strip.h"
#include "report/blocks/report.h"

namespace palmer {

/// The strips of all blocks, in their order, with the gaps between them. `width`: of the text, points;
/// `tallest`: what fits on an empty page. Running heads are strips without height.
[[nodiscard]] Strips blockStrips(const std::vector<Block> &blocks, double width, double tallest);

/// Whether a section begins with it.
[[nodiscard]] bool beginsSection(const Block &block);

/// Whether it is nothing to be read.
[[nodiscard]] bool isMark(const Block &block);

} // namespace palmer
