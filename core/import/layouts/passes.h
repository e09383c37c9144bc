// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/layouts/headings.h"
#include "import/remark.h"
#include "kernel/measurement/test.h"
#include "tables/units.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// A reading of a file: position and value in the file's units. Kept small, as there may be millions.
struct PassReading {
    double position = 0;
    double value = 0;
    std::uint32_t line = 0; ///< of the file; 0: unknown
    bool isMissing = false; ///< no reading; `value` is undefined
};

/// One pass over the targets in one direction, in file order.
struct Pass {
    Direction direction = Direction::positive;
    std::vector<PassReading> readings;
};

/// How to interpret the values of passes. Texts and origins are those of the choices.
struct PassForm {
    std::string content = "deviations"; ///< or "positions"
    std::string sign = "actualMinusTarget";
    const Unit *unit = nullptr;         ///< of the values
    const Unit *positionUnit = nullptr; ///< of the targets
};

/// Makes a measurement with ascending targets without repetition, one run per pass, missing readings null;
/// deviations = actual − target in mm or degrees. Differences of positions are rounded to 1e-10, far below
/// any instrument: 150.712 − 150.71 is 0.002. Remarks: two readings at one place (the first is kept;
/// differing ones are unread data), a run of zeros, gaps, unequal numbers of runs.
[[nodiscard]] PositioningMeasurement measurementOf(std::vector<Pass> passes, const PassForm &form,
                                                   Remarks &remarks);

/// Makes a test of a measurement; edition and axis name as chosen, otherwise `stated` or the default, and
/// `axis`.
[[nodiscard]] Test testFrom(PositioningMeasurement measurement, std::string_view axis, Choices &choices,
                            const Edition *stated = nullptr);

/// Throws Error unless the units of readings and positions are both lengths or both angles.
void requireOneMotion(const PassForm &form);

/// Adds targets of a list that a pass lacks as missing readings, so that targets without reading are kept.
void addMissing(Pass &pass, std::span<const double> targets);

/// True if each number is above the one before, or each is below it.
[[nodiscard]] bool isStrictlyMonotone(std::span<const double> values);

/// Alternates the passes of both directions, ↑1 ↓1 ↑2 ↓2 …, as measured in the standard cycle.
[[nodiscard]] std::vector<Pass> inCycles(std::vector<Pass> passes);

/// True if the values follow their positions and hence are positions: the differences are small compared with
/// the range of positions, and the values are not.
[[nodiscard]] bool arePositions(const std::vector<Pass> &passes);

/// Statements of a file about its values; empty or null if there are none.
struct StatedForm {
    std::string content; ///< "deviations" or "positions"
    std::string sign;    ///< a word of the choice, if the file proves it
    SaidUnit unit = {};
    SaidUnit positionUnit = {};
    SaidSign said = {};        ///< in words of the file, to be confirmed; words alone leave the sign open
    bool isCorrection = false; ///< a heading of the data read names a correction
};

/// How to ask for a unit.
struct UnitQuestion {
    Text guessed;                                ///< nothing states it: "… read as %1."
    RemarkGrade grade = RemarkGrade::assumption; ///< grade of `guessed`
    std::optional<Message> contradiction = {};   ///< why the stated unit is unusable; null: it is only quoted
};

/// Settles the unit of a choice: the user's, otherwise `found` (the stated one, if usable), otherwise the
/// usual one if none is stated, otherwise `guess` with its question. Null if the user's is not a unit.
const Unit *resolveUnit(std::string_view choice, const SaidUnit &said, const Unit *found, const Unit &guess,
                        const UnitQuestion &question, Choices &choices, Remarks &remarks);

/// Settles content, unit, positionUnit, sign and motion of passes: as stated in the file, otherwise guessed
/// with a question.
[[nodiscard]] PassForm resolveForm(const std::vector<Pass> &passes, const StatedForm &stated,
                                   Choices &choices, Remarks &remarks);

} // namespace palmer
