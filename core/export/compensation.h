#pragma once

#include "document/evaluateddocument.h"
#include "kernel/measurement/positioning.h"

#include <QByteArray>
#include <QByteArrayView>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

enum class CompensationFormat {
    linuxcnc, ///< `nominal forward reverse` a line, COMP_FILE_TYPE 0: actual positions
    siemens,  ///< $AA_ENC_COMP…: values with the sign of the deviation
    csv,      ///< position and correction, one or two columns
};

/// How a table is made. Lengths in mm, of rotary axes in degrees.
struct CompensationOptions {
    std::optional<double> from;     ///< null: first target
    std::optional<double> to;       ///< null: last target
    std::optional<double> interval; ///< null: the targets themselves (siemens: their mean interval)
    bool perDirection = false;      ///< x̄_i↑ and x̄_i↓ apart, else the mean of both
    bool incremental = false;       ///< csv: each value is the step from the one before
    bool deviations = false;        ///< csv: values with the sign of the deviation, not of the correction
    char decimalMark = '.';         ///< csv
    int encoder = 0;                ///< siemens: index of the measuring system; 0 is the first
};

/// A compensation of the systematic deviations of an axis: what is added to the commanded position.
/// Values between the positions are interpolated, those beyond them hold (as controls do).
struct CompensationTable {
    std::string axis;
    Motion motion = Motion::linear;
    bool perDirection = false;
    std::vector<double> positions; ///< ascending, mm or degrees
    std::vector<double> forward;   ///< −x̄_i↑, or −x̄_i; mm or degrees
    std::vector<double> reverse;   ///< −x̄_i↓, or −x̄_i

    [[nodiscard]] double correction(double position, Direction direction) const;
    bool operator==(const CompensationTable &) const = default;
};

/// The table that takes out the means of an evaluated positioning test; linear between targets, rounded to
/// 0.1 µm (rotary: 1e-5°), so that what is written is what is predicted. A test of one direction has the
/// same values for both. Throws Error(content) for no positioning test, targets without a mean, a range or
/// interval beyond sense.
[[nodiscard]] CompensationTable compensationTable(const Test &test, const TestEvaluation &evaluation,
                                                  CompensationFormat format,
                                                  const CompensationOptions &options);

/// The table as the control reads it. Throws Error(content) for what the format cannot say: values per
/// direction or steps in a Siemens table, steps in a LinuxCNC table.
[[nodiscard]] QByteArray writeCompensation(const CompensationTable &table, CompensationFormat format,
                                           const CompensationOptions &options);

/// Reads what writeCompensation has written. Throws Error with the line.
[[nodiscard]] CompensationTable readCompensation(QByteArrayView bytes);

/// The test as it would be with the table applied: each deviation plus the correction at its target.
[[nodiscard]] Test compensated(const Test &test, const CompensationTable &table);

} // namespace palmer
