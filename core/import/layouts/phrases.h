// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/measurement/test.h"
#include "tables/units.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// Meaning of the numbers of a column, from its heading.
enum class Meaning {
    unknown,
    statistic, ///< mean, standard deviation …: computed here, not read
    temperature,
    deviation, ///< deviation from the target, radial deviation
    actual,    ///< actual position
    reading,   ///< a measured value: position or deviation
    direction, ///< direction of approach, or sense of contouring
    time,
    angle,
    radius,
    nominal, ///< a nominal radius or length, not one of the targets
    target,  ///< target position
    place,   ///< an unspecified position: that of the targets, unless another column is
    run,
    index,   ///< target or point number
    axis,    ///< name of an axis
    process, ///< name of a process variable
    other,   ///< not a reading: a tolerance, a feed, a remark
    x,
    y,
};

[[nodiscard]] inline bool isOneOf(Meaning meaning, std::initializer_list<Meaning> meanings) {
    return std::ranges::find(meanings, meaning) != meanings.end();
}

/// Meaning of the words of a heading in English, French, German, Italian or Spanish. Only whole words count:
/// "Pos." is a place and "rev" an abbreviation, neither is a direction.
struct HeadingWords {
    Meaning meaning = Meaning::unknown;
    bool isTarget = false;              ///< contains "target" or "nominal"
    bool isActual = false;              ///< contains "actual", "measured" or "reading"
    std::optional<Direction> direction; ///< a whole phrase: "approche négative", "Hinfahrt", "↑", "+"
    std::optional<Direction> hint;      ///< an abbreviation that is a direction only next to its opposite
    bool isHintWord = false;            ///< the hint is an abbreviation, not a letter or dash
    bool saysDirection = false;         ///< contains a word for "direction"
    bool namesBoth = false;             ///< ↑ and ↓
    bool namesSense = false;            ///< names a sense of rotation; its hint is a guess: clockwise as ↑
    TestRole state = TestRole::notStated; ///< before or after an adjustment
    bool isTest = false;                  ///< contains "test", which is a run to some, a whole test to others
    bool comesFrom = false;         ///< "approach from −": the hint is the reverse, and to be confirmed
    std::optional<unsigned> number; ///< of a run
    char axis = 0;                  ///< X Y Z U V W A B C, otherwise 0
    std::size_t unknownWords = 0;
    std::size_t words = 0; ///< including signs and numbers, without the unit
    std::string group;     ///< unknown words above several columns
    std::string stem;      ///< the words without direction, number and unit: the same for runs of one kind

    /// True if its hint is unambiguous: "neg. Richtung" next to "pos. Richtung", "rev" next to "forward".
    [[nodiscard]] bool isClearHint(bool oppositeIsStated) const {
        return isHintWord && (saysDirection || oppositeIsStated);
    }

    /// True if no word tells anything but readings.
    [[nodiscard]] bool isOfReadings() const {
        return !isOneOf(meaning, {Meaning::statistic, Meaning::temperature, Meaning::other, Meaning::time});
    }
    /// True if all words are known and tell readings: a title, neither prose nor "Pressure ↑ 60".
    [[nodiscard]] bool isTitle() const { return unknownWords == 0 && isOfReadings(); }
    /// True if it names a direction and nothing else.
    [[nodiscard]] bool isDirectionOnly() const { return direction && isTitle(); }
};

[[nodiscard]] HeadingWords readHeading(std::string_view text);
/// The same of a line, without the label of "State: as found".
[[nodiscard]] HeadingWords readTitle(std::string_view line);

/// The direction named in a cell of directions: + − ↑ ↓ up down fwd rev aller retour …; null for other texts.
[[nodiscard]] std::optional<Direction> directionOf(std::string_view cell);

} // namespace palmer
