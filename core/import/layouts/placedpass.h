// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/passes.h"
#include "import/layouts/tablereading.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// A pass with the cells its readings stand in, for the colours, and what the table says of it.
struct PlacedPass {
    std::optional<Direction> direction;
    unsigned number = 0; ///< of the run, from 1; 0: not stated
    Pass pass;
    std::vector<std::uint32_t> cells; ///< of the table

    void add(TableReading &reading, std::uint32_t row, double position, std::size_t column) {
        PassReading &added = pass.readings.emplace_back(); // in its place: each copy waited for its parts
        added.position = position;
        added.line = reading.row(row).line;
        const auto value = reading.number(row, column);
        added.value = value.value_or(0);
        added.isMissing = !value;
        if (column < reading.row(row).count)
            cells.push_back(reading.row(row).first + static_cast<std::uint32_t>(column));
    }
};

/// What is found in a table of a positioning test, before units and signs.
struct FoundPasses {
    std::vector<PlacedPass> passes;
    std::string content; ///< "deviations", "positions", or empty
    std::string sign;    ///< proven by the table, or empty
    SaidUnit unit = {};
    SaidUnit positionUnit = {};
    bool hasHints = false;  ///< directions come from letters, abbreviations or titles
    bool hasSenses = false; ///< directions come from senses of rotation
    bool isBlockwise = false;
    bool isByLine = false; ///< a pass a line
};

/// The directions of all passes: what the table says, else the user's choice or a guess with its question.
void settleDirections(FoundPasses &found, TableReading &reading);

/// The order of numbers that count the runs of both directions; else directions in turn, with a remark where
/// the table does not have them so.
[[nodiscard]] std::vector<Pass> inOrder(std::vector<PlacedPass> placed, TableReading &reading);

/// What the titles above a block say of the direction.
struct BlockDirection {
    std::optional<Direction> stated; ///< a title that says nothing else
    std::optional<Direction> hint;   ///< among other words: counts beside a block with the opposite only
};
[[nodiscard]] BlockDirection directionOfBlock(const TableReading &reading, const TableBlock &block);

/// Targets down and runs across, or one reading a line.
[[nodiscard]] FoundPasses readTargetsDown(TableReading &reading);
/// A run a line, targets across.
[[nodiscard]] FoundPasses readRunsDown(TableReading &reading);

} // namespace palmer
