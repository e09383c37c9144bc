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

/// A reading of a file: where, and what; in the file's units. There are millions: as small as may be.
struct PassReading {
    double position = 0;
    double value = 0;
    std::uint32_t line = 0; ///< of the file, 0: not known
    bool isMissing = false; ///< no reading: its value says nothing
};

/// One pass over the targets in one direction, in the order of the file.
struct Pass {
    Direction direction = Direction::positive;
    std::vector<PassReading> readings;
};

/// How the values of passes are to be understood. The texts and origins are those of the choices.
struct PassForm {
    std::string content = "deviations"; ///< or "positions"
    std::string sign = "actualMinusTarget";
    const Unit *unit = nullptr;         ///< of the values
    const Unit *positionUnit = nullptr; ///< of the targets
};

/// Targets ascending without repetition, one run a pass, readings that are not there null; deviations =
/// actual − target in mm or degrees. Differences of positions are rounded to 1e-10, far below any
/// instrument: 150.712 − 150.71 is 0.002. Remarks: two readings in one place (the first stays; others than
/// it are data that were not read), a run of zeros, gaps, runs that differ in number.
[[nodiscard]] PositioningMeasurement measurementOf(std::vector<Pass> passes, const PassForm &form,
                                                   std::vector<Remark> &remarks);

/// The test of a measurement: its edition and the name of its axis are chosen, else the default and `axis`.
[[nodiscard]] Test testFrom(PositioningMeasurement measurement, std::string_view axis, Choices &choices);

/// A table of an instrument is of lengths, or of angles: one unit of each is refused.
void demandOneMotion(const PassForm &form);

/// Targets of a list that have a reading in no run are targets all the same: those a pass lacks are added to
/// it as missing readings.
void addMissing(Pass &pass, std::span<const double> targets);

/// The numbers of both directions, one after the other: ↑1 ↓1 ↑2 ↓2 …, as the standard cycle measures.
[[nodiscard]] std::vector<Pass> inCycles(std::vector<Pass> passes);

/// Whether the values follow the positions they stand at, and hence are positions: their differences are
/// small against the range of the positions, and the values are not.
[[nodiscard]] bool arePositions(const std::vector<Pass> &passes);

/// What a file says of its values; empty or null: nothing.
struct StatedForm {
    std::string content; ///< "deviations" or "positions"
    std::string sign;    ///< as of the choice, where the file proves it
    SaidUnit unit = {};
    SaidUnit positionUnit = {};
    SaidSign said = {};        ///< what words of the file say, which is asked
    bool isCorrection = false; ///< a heading of what is read names one
};

/// How a unit is asked for.
struct UnitQuestion {
    Text guessed;                                ///< nothing says it: "… read as %1."
    RemarkGrade grade = RemarkGrade::assumption; ///< of that
    std::optional<Message> contradiction =
        {}; ///< what is said cannot be taken; null: it is quoted, without more
};

/// Settles the unit of a choice: that of the user, `found` (the one said, where numbers can be read in it),
/// the usual one where nothing is said, else `guess` with its question. Null where the user's is no unit.
const Unit *settleUnit(std::string_view choice, const SaidUnit &said, const Unit *found, const Unit &guess,
                       const UnitQuestion &question, Choices &choices, std::vector<Remark> &remarks);

/// Settles content, unit, positionUnit, sign and motion for passes: what the file says, else a guess with its
/// question.
[[nodiscard]] PassForm settleForm(const std::vector<Pass> &passes, const StatedForm &stated, Choices &choices,
                                  std::vector<Remark> &remarks);

} // namespace palmer
