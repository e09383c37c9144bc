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

/// Reads a deviation (mm, rotary: degrees) as it is typed, in the unit it is shown in; with a `target` an
/// actual position in the unit positions are shown in, of which the deviation is the distance from the
/// target. A dash alone says, as it does where it is shown, that there is no reading.
[[nodiscard]] NumberEntry typedReading(QStringView text, const Axis &axis, const DisplayUnits &units,
                                       std::optional<double> target = std::nullopt);

/// A target position as it is typed: its value, or why it cannot be one.
struct TargetEntry {
    std::optional<double> value; ///< mm or degrees
    std::optional<Message> refusal;
};

/// Reads the position of a target, in the unit positions are shown in; it has to lie between its neighbours.
[[nodiscard]] TargetEntry typedTarget(QStringView text, const PositioningMeasurement &measurement,
                                      std::size_t target, const DisplayUnits &units);

struct PastedTargets : Pasted {
    std::vector<double> targets; ///< mm or degrees
};

/// Target positions that were typed or pasted: numbers parted by semicolons, blanks, tabs or lines, in the
/// unit that a heading says, else in that of positions; `answers` may say another ("positionUnit"). Where
/// headings name a column of targets, that one. Null: something is no number, or its unit none of the axis.
[[nodiscard]] std::optional<PastedTargets> targetsFrom(const std::string &text, const Axis &axis,
                                                       const DisplayUnits &units,
                                                       const ImportOptions &answers = {});

/// The unit that a heading says, of that kind. Throws Error where numbers are not converted from it.
[[nodiscard]] const Unit &unitOfHeading(const SaidUnit &said, UnitKind kind);

/// Of the readings and the positions of an axis.
[[nodiscard]] constexpr UnitKind unitKindOf(Motion motion) {
    return motion == Motion::linear ? UnitKind::length : UnitKind::angle;
}

/// The deviation of an actual position from its target, without the rounding errors of the difference: to a
/// millionth of a micrometre.
[[nodiscard]] double deviationFrom(double target, double position);

} // namespace palmer
