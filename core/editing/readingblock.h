// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/question.h"
#include "kernel/measurement/positioning.h"
#include "kernel/measurement/readingplace.h"
#include "kernel/words/message.h"
#include "language/units.h"
#include "tables/choice.h"
#include "tables/table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

// Blocks of cells that come from and go to spreadsheets. Columns of the table of readings: 0 the number of
// the target, 1 its position, from 2 on the runs in the order they are shown.

inline constexpr std::size_t numberColumnOfBlock = 0;
inline constexpr std::size_t positionColumnOfBlock = 1;
inline constexpr std::size_t firstRunOfBlock = 2;

/// What the numbers of a block are.
enum class BlockContent {
    deviations,     ///< in the unit deviations are shown in: µm, ″, or what the user chose
    longDeviations, ///< deviations in the unit of positions: mm, °
    positions,      ///< actual positions
};

struct BlockChoices {
    BlockContent content = BlockContent::deviations;
    std::optional<DecimalMark> decimalMark; ///< null: as the block says
    std::optional<Delimiter> delimiter;     ///< null: as the block says
    DisplayUnits units;
    bool unitsOfHeading = true; ///< what a heading says wins over `content`
    ImportOptions answers = {}; ///< to the questions of a table that is read as a file is
};

/// Where the block is put, and into which table.
struct BlockPlace {
    std::size_t row = 0;           ///< of its first line
    std::size_t column = 0;        ///< of its first cell
    std::vector<std::size_t> runs; ///< the runs by column, from firstRunOfBlock on
};

/// A measurement with a block put in, and what is to be said of it.
struct PastedBlock {
    PositioningMeasurement measurement;
    std::size_t readings = 0; ///< numbers taken as readings
    std::size_t targets = 0;  ///< numbers taken as target positions
    std::size_t erased = 0; ///< readings (or texts in their place) that empty cells and words for "none" took
    std::size_t erasedByWords = 0; ///< of these by words for "none": "n/a", "-", "?"
    std::size_t aside = 0;   ///< cells that met a reading set aside: not taken, it keeps value and reason
    std::size_t refused = 0; ///< cells that are no numbers: kept as they are, shown red, missing
    std::size_t left = 0;    ///< cells outside the table, not taken
    Choice<DecimalMark> decimalMark;
    Delimiter delimiter = Delimiter::tab;
    bool hasMarks = false;           ///< whether there is a decimal mark in the block at all
    const Unit *unit = nullptr;      ///< of the readings, as a heading says; null: as chosen, or several
    std::vector<Question> questions; ///< to be answered first: nothing is put
    std::vector<Message> remarks;
};

/// Puts a block (lines of cells, parted by tabs, as every spreadsheet copies them; or by what readTable
/// recognises) into a measurement. Empty cells and words for "none" make the reading missing; a reading set
/// aside stays as it is. Lines above the first number are headings: of them the units
/// are read, "P (mm)"; a column whose heading says none has that of the readings left of it. A block that
/// begins with the target positions themselves (or with their numbers too) may be put on the first reading:
/// these columns are recognised and left out. Where headings say which column holds the
/// targets, the block is read as a file is: each reading goes to its target, each run into the next column of
/// its direction; what a file would be doubted for is asked, and nothing is put. From the columns of number
/// and position on, the block may bring the targets, also more than there are; they have to ascend. What has
/// no place is counted and said, never put elsewhere. Throws what readTable throws, and an Error for units
/// that numbers are not converted from.
[[nodiscard]] PastedBlock pasteBlock(PositioningMeasurement measurement, std::string text, BlockPlace place,
                                     const BlockChoices &choices);

} // namespace palmer
