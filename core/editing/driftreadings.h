// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "language/units.h"

#include <QStringView>
#include <cstddef>
#include <optional>
#include <vector>

namespace palmer {

/// One reading of a drift test: s, and mm (rotary: degrees).
struct DriftReading {
    double time = 0;
    double deviation = 0;

    bool operator==(const DriftReading &) const = default;
};

// Edits of the readings of a drift test. Rows count from 0; tests of other kinds stay as they are.

/// Puts readings from `row` on in the place of those that are there; what lies beyond the end is added.
void setDriftReadings(Test &test, std::size_t row, const std::vector<DriftReading> &readings);

/// Removes readings; those beyond the end are none.
void removeDriftReadings(Test &test, std::size_t row, std::size_t count);

/// Two columns as they are copied from a table: times in s and deviations in the unit shown, parted by tabs,
/// semicolons or blanks, a reading a line. Lines without numbers above the first reading are their head; the
/// units that it says are those of the columns. Nothing where a line says anything else. Throws Error for
/// units that numbers are not converted from.
[[nodiscard]] std::optional<std::vector<DriftReading>> driftReadingsFrom(QStringView pasted, Motion motion,
                                                                         const DisplayUnits &units = {});

} // namespace palmer
