// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/strip.h"
#include "report/blocks/report.h"

namespace palmer {

/// A table as strips, `width` points wide: its head, then its rows. Numbers are aligned at the decimal mark,
/// the widest fraction of a column at the right edge. Text that is too wide for its column wraps; a row
/// higher than half a page is split between its lines.
[[nodiscard]] Strips tableStrips(const Table &table, double width);

/// Findings with mark, grade, sentence and clause.
[[nodiscard]] Strips findingStrips(const FindingsBlock &findings, double width);

} // namespace palmer
