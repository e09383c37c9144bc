// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "import/instruments/compensationtable.h"
#include "kernel/measurement/positioning.h"

#include <QByteArray>
#include <QByteArrayView>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

enum class CompensationFormat {
    linuxcnc, ///< `nominal forward reverse` per line, COMP_FILE_TYPE 0: actual positions; at most 256 lines
    siemens,  ///< $AA_ENC_COMP…: values with the sign of the deviation, 0 at the reference point
    weihong,  ///< axeserr.dat: `nominal, forward, backward`, nominal − actual
    csv,      ///< position and correction, one or two columns
};

/// How a table is computed. Lengths in mm, for rotary axes in degrees.
struct CompensationOptions {
    std::optional<double> from;     ///< null: first target
    std::optional<double> to;       ///< null: last target
    std::optional<double> interval; ///< null: the targets themselves (siemens: mean interval of the targets)
    bool perDirection = false;      ///< x̄_i↑ and x̄_i↓ separately; false: the mean of both
    bool incremental = false;       ///< csv: each value is the step from the previous one
    bool deviations = false; ///< csv, weihong: values with the sign of the deviation, not of the correction
    char decimalMark = '.';  ///< csv
    int encoder = 0;         ///< siemens: index of the measuring system, 0 (the first) or 1
    bool signConfirmed =
        false; ///< confirmed: the deviations are actual − target, which their file does not state
    std::optional<double> reference; ///< siemens, required: the reference point of the axis
};

/// Longest LinuxCNC table; the control ignores further lines.
inline constexpr std::size_t mostLinuxcncPoints = 256;

/// Computes the table that compensates the means of an evaluated positioning test: linear between targets,
/// rounded to 0.1 µm (rotary: 1e-5°), so that the file matches the prediction. A test of one direction
/// applies its values to both, and a remark says so. Siemens: the positions are equally spaced; the value is
/// 0 at the reference point (within half the rounding if that is between two points); a rotary axis of 360°,
/// by its targets or its stated travel, gets a closed table of the full turn. Throws Error(content) if the
/// test is no positioning test, targets lack a mean, values per direction are wanted for a test of one
/// direction, range or interval are senseless, the format does not allow it (values per direction or steps in
/// a Siemens table, steps in a LinuxCNC or Weihong table, more points than the control loads, a rotary axis
/// for Weihong), the reference point is missing, or an assumed sign is not confirmed.
[[nodiscard]] CompensationTable compensationTable(const Test &test, const TestEvaluation &evaluation,
                                                  CompensationFormat format,
                                                  const CompensationOptions &options);

/// The file whose deviations were assumed to be actual − target; null if there is none.
[[nodiscard]] const ImportedFile *fileOfAssumedSign(const Test &test);

/// True if both directions have results, as values per direction require.
[[nodiscard]] bool measuredBothWays(const TestEvaluation &evaluation);

/// The table as a file for the control. Throws Error(content) if the control does not know the name of the
/// axis (or it is empty) or a SINUMERIK does not have the measuring system.
[[nodiscard]] QByteArray writeCompensation(const CompensationTable &table, CompensationFormat format,
                                           const CompensationOptions &options);

/// Remarks for the user before loading the table: conditions of the test under which it holds, required
/// settings of the control, positions and directions that were not measured, and the origin of the sign.
[[nodiscard]] std::vector<Message> compensationRemarks(const Test &test, const CompensationTable &table,
                                                       CompensationFormat format,
                                                       const CompensationOptions &options);

/// Reads a file of writeCompensation() by the rules of the control. Throws Error with the line.
[[nodiscard]] CompensationTable readCompensation(QByteArrayView bytes, CompensationFormat format,
                                                 const CompensationOptions &options);

/// Reads an existing table for comparison: from a control, or written here as CSV. Throws Error.
[[nodiscard]] FoundTable readFoundTable(QByteArrayView bytes, QStringView fileName);

/// The largest difference between the corrections of two tables, evaluated at the positions of both.
struct TableDifference {
    double value = 0; ///< second − first, mm or degrees
    double position = 0;
    Direction direction = Direction::positive;
};
[[nodiscard]] TableDifference largestDifference(const CompensationTable &first,
                                                const CompensationTable &second);

/// The test as predicted with the table applied: each deviation plus the correction at its target.
[[nodiscard]] Test compensated(const Test &test, const CompensationTable &table);

/// Positions of a compensation table are rounded to this fraction of a mm or degree.
inline constexpr double positionFineness = 1e6;

/// Rounds to multiples of 1/parts; never −0.
[[nodiscard]] inline double rounded(double value, double parts) {
    return std::round(value * parts) / parts + 0.0;
}

} // namespace palmer
