// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "import/instruments/compensationtable.h"
#include "kernel/measurement/positioning.h"

#include <QByteArray>
#include <QByteArrayView>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

enum class CompensationFormat {
    linuxcnc, ///< `nominal forward reverse` a line, COMP_FILE_TYPE 0: actual positions; at most 256 lines
    siemens,  ///< $AA_ENC_COMP…: values with the sign of the deviation, 0 at the reference point
    weihong,  ///< axeserr.dat: `nominal, forward, backward`, nominal − actual
    csv,      ///< position and correction, one or two columns
};

/// How a table is made. Lengths in mm, of rotary axes in degrees.
struct CompensationOptions {
    std::optional<double> from;     ///< null: first target
    std::optional<double> to;       ///< null: last target
    std::optional<double> interval; ///< null: the targets themselves (siemens: their mean interval)
    bool perDirection = false;      ///< x̄_i↑ and x̄_i↓ apart, else the mean of both
    bool incremental = false;       ///< csv: each value is the step from the one before
    bool deviations = false; ///< csv, weihong: values with the sign of the deviation, not of the correction
    char decimalMark = '.';  ///< csv
    int encoder = 0;         ///< siemens: index of the measuring system, 0 (the first) or 1
    bool signConfirmed =
        false; ///< the deviations are actual − target, though what they were read from is silent
    std::optional<double> reference; ///< siemens: the reference point of the axis, owed
};

/// Most lines of a LinuxCNC table: the control leaves out the others.
inline constexpr std::size_t mostLinuxcncPoints = 256;

/// The table that takes out the means of an evaluated positioning test; linear between targets, rounded to
/// 0.1 µm (rotary: 1e-5°), so that what is written is what is predicted. A test of one direction has its
/// values for both, and the remarks say so. Siemens: the positions are a whole number of equal steps; the
/// value is 0 at the reference point (half of the rounding where that lies between two points); a rotary axis
/// of 360°, by its targets or its stated travel, gets a table of the full turn that closes. Throws
/// Error(content) for no positioning test, targets without a mean, values per direction of a test of one, a
/// range or interval beyond sense, what the format cannot hold: values per direction or steps in a Siemens
/// table, steps in a LinuxCNC or Weihong table, more points than a control loads, a rotary axis for Weihong;
/// a reference point that is owed, a sign that was assumed and nobody has confirmed.
[[nodiscard]] CompensationTable compensationTable(const Test &test, const TestEvaluation &evaluation,
                                                  CompensationFormat format,
                                                  const CompensationOptions &options);

/// The file whose deviations were taken for actual − target without saying so; null: there is none.
[[nodiscard]] const ImportedFile *fileOfAssumedSign(const Test &test);

/// Both directions have results: values per direction can be had.
[[nodiscard]] bool measuredBothWays(const TestEvaluation &evaluation);

/// The table as the control reads it. Throws Error(content) for a name of the axis that the control does not
/// know, an empty one included, and a measuring system that a SINUMERIK does not have.
[[nodiscard]] QByteArray writeCompensation(const CompensationTable &table, CompensationFormat format,
                                           const CompensationOptions &options);

/// What has to be known before the table is loaded: what the control has to be set to, where and in which
/// direction nothing was measured, what the sign rests on.
[[nodiscard]] std::vector<Message> compensationRemarks(const CompensationTable &table,
                                                       CompensationFormat format,
                                                       const CompensationOptions &options);

/// Reads what writeCompensation has written, by the rules of the control. Throws Error with the line.
[[nodiscard]] CompensationTable readCompensation(QByteArrayView bytes, CompensationFormat format,
                                                 const CompensationOptions &options);

/// A table that was found somewhere, to compare: of a control, or written here as CSV. Throws Error.
[[nodiscard]] FoundTable readFoundTable(QByteArrayView bytes, QStringView fileName);

/// The largest difference between the corrections of two tables at the positions of both.
struct TableDifference {
    double value = 0; ///< second − first, mm or degrees
    double position = 0;
    Direction direction = Direction::positive;
};
[[nodiscard]] TableDifference largestDifference(const CompensationTable &first,
                                                const CompensationTable &second);

/// The test as it would be with the table applied: each deviation plus the correction at its target.
[[nodiscard]] Test compensated(const Test &test, const CompensationTable &table);

} // namespace palmer
