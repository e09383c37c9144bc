// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/layouts/columnrole.h"
#include "import/question.h"
#include "import/remark.h"
#include "kernel/measurement/machine.h"
#include "kernel/measurement/test.h"
#include "tables/contenterror.h"
#include "tables/table.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// The role a cell of the raw table was read as, for its colour in the assistant.
enum class CellRole : std::uint8_t { ignored, head, position, positive, negative };

/// A sheet of a workbook.
struct ImportSheet {
    std::string name;
    bool isHidden = false;
    bool hasMeasurement = false; ///< a readable table

    bool operator==(const ImportSheet &) const = default;
};

/// The content of a measurement file before it is accepted.
struct Imported {
    std::string format;                ///< word of the choice "format"
    std::vector<ImportChoice> choices; ///< all choices relevant to this file, each with its origin
    std::vector<Question> questions;   ///< to be answered before it is accepted; red ones first
    Remarks remarks;                   ///< problems, assumptions, then notes; no questions
    std::vector<ImportSheet> sheets;   ///< of a workbook, the visible ones first
    std::vector<ImportColumn> columns; ///< of the table, each with its role; empty for other files
    std::vector<ListedTable> tables;   ///< of a text or sheet with several tables
    std::size_t readTable = 0;         ///< index in `tables`
    CellTable table;                   ///< as read, of text files and workbooks
    std::vector<CellRole> roles;       ///< of its cells
    std::string text;                  ///< of text files without tables, as read

    std::optional<Test> test;              ///< null for temperatures
    std::vector<Sensor> sensors;           ///< from the file
    std::optional<double> gradientPerHour; ///< °C/h, maximum over the air sensors with a series
    std::optional<double> seriesStart;     ///< of a dated series: s since 1970, by its own clock
    Machine machine;                       ///< as stated in the file; empty = not stated
    std::vector<Instrument> instruments;   ///< as stated in the file
    std::string operatorName;
    std::optional<Error> refusal; ///< why there is no measurement, though something can be shown
};

} // namespace palmer
