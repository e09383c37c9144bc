// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/passes.h"
#include "import/layouts/positioningcolumns.h"
#include "import/layouts/tablereading.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palmer {

/// A pass with the cells of its readings, for the colours, and the direction and number stated by the table.
struct PlacedPass {
    std::optional<Direction> direction;
    unsigned number = 0; ///< of the run, from 1; 0: not stated
    Pass pass;
    std::vector<std::uint32_t> cells; ///< of the table

    void add(TableReading &reading, std::uint32_t row, double position, std::size_t column) {
        PassReading &added = pass.readings.emplace_back(); // built in place, as a copy is slower
        added.position = position;
        added.line = reading.row(row).line;
        const auto value = reading.number(row, column);
        added.value = value.value_or(0);
        added.isMissing = !value;
        if (column < reading.row(row).count)
            cells.push_back(reading.row(row).first + static_cast<std::uint32_t>(column));
    }
};

/// Content of a positioning table before units and signs are settled.
struct FoundPasses : FoundForm {
    std::vector<PlacedPass> passes;
    bool isBlockwise = false;
    bool isByLine = false;                                                ///< one pass per line
    std::optional<std::pair<std::string, std::string>> unclearCodes = {}; ///< read as ↑ and ↓, for no reason
};

/// Settles the directions of all passes: as stated by the table or chosen, otherwise guessed with a question.
void resolveDirections(FoundPasses &found, TableReading &reading);

/// Orders the passes by run numbers that count both directions, otherwise alternating directions, with a
/// remark if the table has another order.
[[nodiscard]] std::vector<Pass> inOrder(std::vector<PlacedPass> placed, TableReading &reading);

/// The direction in the titles above a block.
struct BlockDirection {
    std::optional<Direction> stated; ///< from a title with nothing else
    std::optional<Direction> hint;   ///< among other words: used only next to a block with the opposite
};
[[nodiscard]] BlockDirection directionOfBlock(const TableReading &reading, const TableBlock &block);

/// Reads targets down and runs across, or one reading per line.
[[nodiscard]] FoundPasses readTargetsDown(TableReading &reading);
/// Reads one run per line with targets across.
[[nodiscard]] FoundPasses readRunsDown(TableReading &reading);

} // namespace palmer
