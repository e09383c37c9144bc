// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/headings.h"
#include "import/layouts/tablebody.h"
#include "import/remark.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/conditions.h"

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// The recognised statements in the comments and first lines of a table.
struct FileNotes {
    std::string axis;
    std::string plane;               ///< "XY"
    SaidUnit unit;                   ///< of the readings: "unit: µm", "Deviations in nm", "all values x 0.1"
    SaidUnit positionUnit;           ///< "Positions in inches"
    std::optional<std::string> date; ///< YYYY-MM-DD
    std::string dateText;            ///< a date that cannot be read in one way, as written
    std::optional<std::string> time; ///< HH:MM
    std::string days;                ///< several dates in one line above the columns
    const Edition *edition = nullptr; ///< "Standard: ISO 230-2:1988"
    bool isOfInstrument = false; ///< the last label named the instrument: a serial number below is its own
    std::string operatorName;
    std::string machine;
    std::string serialNumber;
    SaidSign sign;                     ///< "Deviation = actual - target"
    std::optional<double> radius;      ///< mm
    std::optional<double> feed;        ///< mm/min
    std::optional<double> airPressure; ///< hPa
    std::optional<double> airHumidity; ///< %, relative
    std::vector<Sensor> sensors;       ///< named temperatures
    QuotedLines used;
    QuotedLines unused;

    /// True if there is no statement of the machine, the operator, the day or the surroundings.
    [[nodiscard]] bool saysNothing() const {
        return machine.empty() && serialNumber.empty() && operatorName.empty() && !date && dateText.empty() &&
               !time && sensors.empty() && !airPressure && !airHumidity && !feed;
    }
};

/// True if a row is a label with its value, such as "Date" followed by "05.03.2024": words before at most one
/// number that are understood or end with a colon.
[[nodiscard]] bool isLabelledValue(const CellTable &table, const TableRow &row);

/// The facts stated around the table of a test. `axis`: the one chosen, where the file has tables of several;
/// what stands above the others is not used.
[[nodiscard]] FileNotes notesOf(const CellTable &table, const TableBody &body, std::string_view axis);

/// The facts stated on a sheet without a table; lines that say something else are not listed.
[[nodiscard]] FileNotes notesOf(const CellTable &sheet);

} // namespace palmer
