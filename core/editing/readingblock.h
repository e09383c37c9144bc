// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"
#include "kernel/measurement/positioning.h"
#include "kernel/words/message.h"
#include "language/units.h"
#include "tables/choice.h"
#include "tables/table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

// Blocks of cells exchanged with spreadsheets. Columns of the readings table: 0 the target number, 1 its
// position, from 2 on the runs in display order.

inline constexpr std::size_t positionColumnOfBlock = 1;
inline constexpr std::size_t firstRunOfBlock = 2;

/// Meaning of the numbers in a block.
enum class BlockContent {
    deviations,     ///< in the displayed unit of deviations: µm, ″, or the user's choice
    longDeviations, ///< deviations in the unit of positions: mm, °
    positions,      ///< actual positions
};

struct BlockChoices {
    BlockContent content = BlockContent::deviations;
    std::optional<DecimalMark> decimalMark; ///< null: found in the block
    std::optional<Delimiter> delimiter;     ///< null: found in the block
    DisplayUnits units;
    bool unitsOfHeading = true; ///< units in headings override `content`
    ImportOptions answers = {}; ///< to the questions of a table read as a file is
};

/// Where the block is pasted, and into which table.
struct BlockPlace {
    std::size_t row = 0;           ///< of the first line
    std::size_t column = 0;        ///< of the first cell
    std::vector<std::size_t> runs; ///< run indices by column, from firstRunOfBlock on
};

/// A measurement including a block.
struct PastedBlock : Pasted {
    PositioningMeasurement measurement;
    std::size_t readings = 0;      ///< numbers accepted as readings
    std::size_t targets = 0;       ///< numbers accepted as target positions
    std::size_t erased = 0;        ///< readings (or refused texts) erased by empty cells and words for "none"
    std::size_t erasedByWords = 0; ///< of these by words for "none": "n/a", "-", "?"
    std::size_t aside = 0;         ///< cells at an excluded reading: ignored, it keeps value and reason
    std::size_t refused = 0;       ///< cells that are not numbers: kept as text, shown red, missing
    std::size_t left = 0;          ///< cells outside the table, ignored
    Choice<DecimalMark> decimalMark;
    Delimiter delimiter = Delimiter::tab;
    bool hasMarks = false;      ///< the block contains a decimal mark
    const Unit *unit = nullptr; ///< of the readings, from a heading; null: as chosen, or several
};

/// Pastes a block into a measurement: lines of cells separated by tabs, as every spreadsheet copies them, or
/// by what readTable recognises. Empty cells and words for "none" make a reading missing; an excluded reading
/// is unchanged. Lines above the first number are headings, whose units are used, "P (mm)"; a column without
/// one has the unit of the readings to its left. A block that begins with the target positions (or also their
/// numbers) may be pasted at the first reading: these columns are recognised and skipped. If a heading names
/// the target column, the block is read as a file is: each reading goes to its target, each run to the next
/// column of its direction; doubts about a file become questions, and then nothing is pasted. At the columns
/// of number and position the block may set targets, also more than there are; they must ascend. Cells
/// without a place are counted and reported, never moved. Throws what readTable throws, and Error for units
/// without conversion.
[[nodiscard]] PastedBlock pasteBlock(PositioningMeasurement measurement, std::string text, BlockPlace place,
                                     const BlockChoices &choices);

} // namespace palmer
