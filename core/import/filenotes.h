// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/headings.h"
#include "import/layouts/tablebody.h"
#include "import/remark.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/conditions.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

inline constexpr double leastRadius = 0.5; ///< mm, of a circle in a statement; less is a result

/// The recognised statements in the comments and first lines of a table.
struct FileNotes {
    std::string axis;
    std::string plane;               ///< "XY"
    SaidUnit unit;                   ///< of the readings: "unit: µm", "Deviations in nm", "all values x 0.1"
    SaidUnit positionUnit;           ///< "Positions in inches"
    SaidUnit timeUnit;               ///< "Time in minutes"
    SaidUnit temperatureUnit;        ///< "Temperature unit: °F"
    SaidUnit generalUnit;            ///< "Unit: mm"
    std::string factor;              ///< "Scale factor 0.1"
    std::optional<double> interval;  ///< s, of readings over time: "Sample interval: 10 s"
    std::optional<std::string> date; ///< YYYY-MM-DD
    std::string dateText;            ///< a date that cannot be read in one way, as written
    std::optional<std::string> time; ///< HH:MM
    std::string days;                ///< several dates in one line above the columns
    const Edition *edition = nullptr; ///< "Standard: ISO 230-2:1988"
    bool isOfInstrument = false; ///< the last label named the instrument: a serial number below is its own
    std::string operatorName;
    std::string machine;
    std::string serialNumber;
    SaidSign sign;                       ///< "Deviation = actual - target"
    std::optional<double> radius;        ///< mm
    std::map<char, double> centre;       ///< of a circle, mm, by the letter of the axis
    std::optional<double> startAngle;    ///< °, of a path without angles
    std::optional<double> overshoot;     ///< °, at each end of a path
    std::optional<double> feed;          ///< mm/min
    std::optional<double> airPressure;   ///< hPa
    std::optional<double> airHumidity;   ///< %, relative
    std::vector<Sensor> sensors;         ///< named temperatures
    std::optional<bool> isCorrectedTo20; ///< by the instrument
    std::optional<bool> isCalibrated;    ///< the length of a ballbar
    std::vector<std::pair<std::size_t, std::string>>
        doubts;        ///< lines that doubt the readings: "run 2 is invalid"
    std::string sheet; ///< the one without a table that is being read
    QuotedLines used;
    QuotedLines unused;
};

/// True if a row is a label with its value, such as "Date" followed by "05.03.2024": words before at most one
/// number that are understood or end with a colon.
[[nodiscard]] bool isLabelledValue(const CellTable &table, const TableRow &row);

/// The axis named above each block of numbers, or above one before it; empty if there is none.
[[nodiscard]] std::vector<std::string> axesOfBlocks(const CellTable &table, const TableBody &body);

/// A sheet of a workbook without a table of its own.
struct CoverSheet {
    std::string name;
    CellTable table;
};

/// The facts stated around the table of a test, and on the sheets without one. `axis`: the one chosen, where
/// the file has tables of several, otherwise that of the table read; what stands above the others is not
/// used.
[[nodiscard]] FileNotes notesOf(const CellTable &table, const TableBody &body, std::string_view axis,
                                const std::vector<CoverSheet> &covers = {});

} // namespace palmer
