// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"
#include "kernel/words/message.h"

#include <QByteArrayView>
#include <QStringView>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// A compensation of the systematic deviations of an axis: values added to the commanded position. They are
/// interpolated between the positions and constant beyond them (as in controls), or periodic if there is a
/// period.
struct CompensationTable {
    std::string axis; ///< empty if the table does not state it
    Motion motion = Motion::linear;
    bool perDirection = false;
    std::vector<double> positions;    ///< ascending, mm or degrees
    std::vector<double> forward;      ///< −x̄_i↑, or −x̄_i; mm or degrees
    std::vector<double> reverse;      ///< −x̄_i↓, or −x̄_i
    std::optional<double> period;     ///< degrees; for a table of a full turn
    std::optional<Interval> measured; ///< measured range; null if unknown
    std::optional<Direction> only;    ///< the only measured direction; null: both, or unknown

    [[nodiscard]] double correction(double position, Direction direction) const;
    bool operator==(const CompensationTable &) const = default;
};

/// A table read from a control.
struct FoundTable {
    const char *control = ""; ///< "LinuxCNC", "SINUMERIK", …
    CompensationTable table;
    std::vector<Message> remarks; ///< assumptions, and parts that the control ignores
};

/// Returns the control that a table is for, by its content; null if it is no compensation table. Lines of
/// three numbers and nothing else are a LinuxCNC table only if the file has such an ending (.comp, .com,
/// .cmp, .cal); otherwise they may be a measurement.
[[nodiscard]] const char *controlOfTable(QByteArrayView bytes, QStringView fileName);

/// The table as that control reads it, as far as its rules are public; lines of three numbers are a LinuxCNC
/// table under any name. Throws Error, with line and column if known, if it is no table or its rules are
/// unknown.
[[nodiscard]] FoundTable readControlTable(QByteArrayView bytes, QStringView fileName);

/// Meaning of LinuxCNC values: COMP_FILE_TYPE 0, actual positions, or 1, values to add.
enum class LinuxcncValues { positions, trims };

// One reader per control; the text is UTF-8. They throw Error like readControlTable().

/// usrmotLoadComp: triplets up to the first line that is none; non-ascending ones and those after 256 are
/// ignored.
[[nodiscard]] FoundTable readLinuxcncTable(std::string_view text, LinuxcncValues values);
/// $AA_ENC_COMP, and $AN_CEC of an axis on itself: positive values move the axis in the negative direction.
[[nodiscard]] FoundTable readSinumerikTable(std::string_view text);
/// axeserr.dat. The manufacturer's formula is nominal − actual; `deviations`: actual − nominal.
[[nodiscard]] FoundTable readWeihongTable(std::string_view text, bool deviations);
/// Columns AXISPOS, BACKLASH and the axis.
[[nodiscard]] FoundTable readHeidenhainTable(std::string_view text);

} // namespace palmer
