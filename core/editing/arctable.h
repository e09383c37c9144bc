// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/measurement/circular.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// The paths of a table, with what was understood and assumed.
struct ArcTable {
    std::vector<Arc> arcs;
    std::size_t points = 0;
    std::vector<ImportChoice> choices; ///< as they were settled: layout, unit …
    std::vector<Question> questions;   ///< to be answered before the paths are taken, as of an imported file
    Remarks remarks;
};

/// Reads paths typed or copied from a spreadsheet for a circle of that plane and nominal radius, as a file is
/// read. `answers`: choices of the import and answers to its questions; `usual`: what holds where neither
/// they nor the table say it. A `sense` that the angles contradict turns the order of the points. Throws
/// Error with line and column where there are no points.
[[nodiscard]] ArcTable readArcTable(const std::string &text, const CircularMeasurement &circle,
                                    const ImportOptions &answers = {},
                                    std::optional<Sense> sense = std::nullopt,
                                    const ImportOptions &usual = {});

} // namespace palmer
