// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "import/choices.h"
#include "import/layouts/columnrole.h"
#include "import/question.h"
#include "import/remark.h"
#include "kernel/measurement/machine.h"
#include "kernel/measurement/test.h"
#include "tables/table.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// What a cell of the raw table was read as: how the assistant colours it.
enum class CellRole : std::uint8_t { ignored, head, position, positive, negative };

/// A sheet of a workbook.
struct ImportSheet {
    std::string name;
    bool isHidden = false;
    bool hasMeasurement = false; ///< a table that can be read

    bool operator==(const ImportSheet &) const = default;
};

/// What a measurement file says, before anything is accepted.
struct Imported {
    std::string format;                ///< word of the choice "format"
    std::vector<ImportChoice> choices; ///< all that matter for this file, each with how it came about
    std::vector<Question> questions;   ///< to be answered before it is accepted; red ones first
    std::vector<Remark> remarks;       ///< problems, assumptions, then notes; none of them is a question
    std::vector<ImportSheet> sheets;   ///< of a workbook, the visible ones first
    std::vector<ImportColumn> columns; ///< of the table, each with its role; none for other files
    std::vector<ListedTable> tables;   ///< of a text or sheet that has several
    std::size_t readTable = 0;         ///< of them
    CellTable table;                   ///< as read, of text files and workbooks
    std::vector<CellRole> roles;       ///< of its cells
    std::string text;                  ///< of text files that are no tables: what was read

    std::optional<Test> test;              ///< null for temperatures
    std::vector<Sensor> sensors;           ///< from the file
    std::optional<double> gradientPerHour; ///< °C/h, the largest of the sensors of the air with a series
    std::optional<double> seriesStart;     ///< of a dated series: s since 1970, by its own clock
    Machine machine;                       ///< what the file says of it; empty = not stated
    std::vector<Instrument> instruments;   ///< likewise
    std::string operatorName;
    std::optional<Error> refusal; ///< why there is no measurement, though something can be shown
};

} // namespace palmer
