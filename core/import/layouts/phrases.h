// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/measurement/test.h"
#include "tables/units.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// What the heading of a column says about its numbers.
enum class Meaning {
    unknown,
    statistic, ///< mean, standard deviation …: computed here, not read
    temperature,
    deviation, ///< deviation from the target, radial deviation
    actual,    ///< actual position
    reading,   ///< a measured value: position or deviation
    direction, ///< of approach, or sense of contouring
    time,
    angle,
    radius,
    nominal, ///< a nominal radius or length, not one of the targets
    target,  ///< target position
    place,   ///< a position without saying which: that of the targets, if nothing else is
    run,
    index,   ///< number of the target or point
    axis,    ///< name of an axis
    process, ///< name of a process variable
    other,   ///< known to be no reading: a tolerance, a feed, a remark
    x,
    y,
};

/// What the whole words of a heading say, in English, French, German, Italian or Spanish. Words never count
/// in part: "Pos." is a place and "rev" an abbreviation, neither is a direction.
struct HeadingWords {
    Meaning meaning = Meaning::unknown;
    bool isTarget = false;                ///< says "target" or "nominal", whatever else it says
    bool isActual = false;                ///< says "actual", "measured" or "reading", whatever else it says
    std::optional<Direction> direction;   ///< a whole phrase: "approche négative", "Hinfahrt", "↑", "+"
    std::optional<Direction> hint;        ///< an abbreviation that means a direction only beside its opposite
    bool isHintWord = false;              ///< the hint is an abbreviation, no letter and no dash
    bool saysDirection = false;           ///< holds a word for "direction"
    bool namesSense = false;              ///< of rotation; its hint is a guess: clockwise as ↑
    TestRole state = TestRole::notStated; ///< before or after an adjustment
    bool comesFrom = false;               ///< "approach from −": the hint is the other way, and to be asked
    std::optional<unsigned> number;       ///< of a run
    char axis = 0;                        ///< X Y Z U V W A B C, else 0
    std::size_t unknownWords = 0;
    std::size_t words = 0; ///< with signs and numbers, without the unit
    std::string group;     ///< what stands above several columns and is not understood
    std::string stem;      ///< the words without direction, number and unit: equal for runs of one kind

    /// Whether its hint can mean nothing else: "neg. Richtung" beside "pos. Richtung", "rev" beside
    /// "forward".
    [[nodiscard]] bool isClearHint(bool oppositeIsStated) const {
        return isHintWord && (saysDirection || oppositeIsStated);
    }

    /// Whether it says a direction and nothing that is not part of saying it.
    [[nodiscard]] bool isDirectionOnly() const { return direction && unknownWords == 0; }
};

[[nodiscard]] HeadingWords readHeading(std::string_view text);

/// The direction a cell of a column of directions stands for: + − ↑ ↓ up down fwd rev aller retour …;
/// nothing for any other.
[[nodiscard]] std::optional<Direction> directionOf(std::string_view cell);

} // namespace palmer
