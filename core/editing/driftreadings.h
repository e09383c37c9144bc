// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"
#include "kernel/measurement/test.h"
#include "language/units.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palmer {

/// A reading of a drift test: s, and mm (rotary: degrees).
struct DriftReading {
    double time = 0;
    double deviation = 0;

    bool operator==(const DriftReading &) const = default;
};

// Edits of the readings of a drift test. Rows count from 0; other kinds of test are unchanged.

/// Replaces typed readings from `row` on; those beyond the end are appended. Channels are unchanged.
void setDriftReadings(Test &test, std::size_t row, const std::vector<DriftReading> &readings);

/// Removes readings; rows beyond the end are ignored. Channels without a reading go with their temperatures.
void removeDriftReadings(Test &test, std::size_t row, std::size_t count);

/// Readings of one channel, or of several and temperatures.
struct PastedDrift : Pasted {
    DriftMeasurement drift; ///< gaps left out where there is one channel alone
};

/// Puts a pasted table: one channel into typed readings from `row` on; several channels or temperatures, and
/// whatever meets such a table, in place of all readings. The axis and `settled` stay.
void putDriftReadings(Test &test, std::size_t row, const DriftMeasurement &pasted);

/// Reads a table of times and deviations as a file is read; without units, times are in s and deviations in
/// the displayed unit. `answers`: to its questions, and other units. Throws Error if it is not such a table.
[[nodiscard]] PastedDrift driftReadingsFrom(const std::string &pasted, Motion motion,
                                            const DisplayUnits &units = {},
                                            const ImportOptions &answers = {});

} // namespace palmer
