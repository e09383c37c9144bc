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

/// A compensation of the systematic deviations of an axis: what is added to the commanded position.
/// Values between the positions are interpolated, those beyond them hold (as controls do); with a period they
/// are repeated instead.
struct CompensationTable {
    std::string axis; ///< empty where the table does not say it
    Motion motion = Motion::linear;
    bool perDirection = false;
    std::vector<double> positions;    ///< ascending, mm or degrees
    std::vector<double> forward;      ///< −x̄_i↑, or −x̄_i; mm or degrees
    std::vector<double> reverse;      ///< −x̄_i↓, or −x̄_i
    std::optional<double> period;     ///< degrees: of a table for a full turn
    std::optional<Interval> measured; ///< where it was measured; null where that is not known
    std::optional<Direction> only;    ///< the one that was measured; null: both, or not known

    [[nodiscard]] double correction(double position, Direction direction) const;
    bool operator==(const CompensationTable &) const = default;
};

/// A table as it was found in a control.
struct FoundTable {
    const char *control = ""; ///< "LinuxCNC", "SINUMERIK", …
    CompensationTable table;
    std::vector<Message> remarks; ///< what was taken for granted, what the control does not use
};

/// Which control the table is for, by its content; null for what is no compensation table. Three numbers a
/// line and nothing else are a table of LinuxCNC only under the ending of one (.comp, .com, .cmp, .cal):
/// without it they may be a measurement.
[[nodiscard]] const char *controlOfTable(QByteArrayView bytes, QStringView fileName);

/// The table as that control reads it, as far as its rules are public; three numbers a line are one of
/// LinuxCNC under any name. Throws Error, with line and column where there is one, for what is no table or
/// one whose rules are not known.
[[nodiscard]] FoundTable readControlTable(QByteArrayView bytes, QStringView fileName);

/// How the values of LinuxCNC are meant: COMP_FILE_TYPE 0, actual positions, or 1, what is added.
enum class LinuxcncValues { positions, trims };

// One reader a control; the text is UTF-8. They throw Error as readControlTable does.

/// usrmotLoadComp: triplets up to the first line that is none, those that do not ascend and those after 256
/// left out.
[[nodiscard]] FoundTable readLinuxcncTable(std::string_view text, LinuxcncValues values);
/// $AA_ENC_COMP and $AN_CEC of an axis upon itself: positive values move the axis in the negative direction.
[[nodiscard]] FoundTable readSinumerikTable(std::string_view text);
/// axeserr.dat. The maker's formula is nominal − actual; `deviations`: actual − nominal.
[[nodiscard]] FoundTable readWeihongTable(std::string_view text, bool deviations);
/// Columns AXISPOS, BACKLASH and the axis.
[[nodiscard]] FoundTable readHeidenhainTable(std::string_view text);

} // namespace palmer
