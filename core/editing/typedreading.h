// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"
#include "kernel/measurement/positioning.h"
#include "kernel/words/message.h"
#include "language/entry.h"
#include "tables/units.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// Reads a typed deviation (mm, rotary: degrees) in its displayed unit; with a `target`, an actual position
/// in the displayed unit of positions, converted to its distance from the target. A single dash means no
/// reading, as in the display.
[[nodiscard]] NumberEntry typedReading(QStringView text, const Axis &axis, const DisplayUnits &units,
                                       std::optional<double> target = std::nullopt);

/// A typed target position: its value, or why it is invalid.
struct TargetEntry {
    std::optional<double> value; ///< mm or degrees
    std::optional<Message> refusal;
};

/// Reads a target position in the displayed unit of positions; it must lie between its neighbours.
[[nodiscard]] TargetEntry typedTarget(QStringView text, const PositioningMeasurement &measurement,
                                      std::size_t target, const DisplayUnits &units);

struct PastedTargets : Pasted {
    std::vector<double> targets; ///< mm or degrees
};

/// Target positions that were typed or pasted: numbers parted by semicolons, blanks, tabs or lines, in the
/// unit that a heading says, else in that of positions; `answers` may say another ("positionUnit"). Where
/// headings name a column of targets, that one. Null if
/// something is no number. Throws Error if a heading says a unit that is none of the axis.
[[nodiscard]] std::optional<PastedTargets> targetsFrom(const std::string &text, const Axis &axis,
                                                       const DisplayUnits &units,
                                                       const ImportOptions &answers = {});

/// The unit in a heading, of that kind. Throws Error for one without conversion.
[[nodiscard]] const Unit &unitOfHeading(const SaidUnit &said, UnitKind kind);

/// Kind of unit of an axis's readings and positions.
[[nodiscard]] constexpr UnitKind unitKindOf(Motion motion) {
    return motion == Motion::linear ? UnitKind::length : UnitKind::angle;
}

/// The deviation of an actual position from its target, rounded to a millionth of a micrometre to remove the
/// rounding error of the difference.
[[nodiscard]] double deviationFrom(double target, double position);

} // namespace palmer
