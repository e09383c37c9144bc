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

struct PastedDrift : Pasted {
    std::vector<DriftReading> readings;
};

/// A table of times and deviations, read as a file is; where it says no units, times are in s and deviations
/// in the unit shown. `answers`: to its questions, and other units. Throws Error for what is none.
[[nodiscard]] PastedDrift driftReadingsFrom(const std::string &pasted, Motion motion,
                                            const DisplayUnits &units = {},
                                            const ImportOptions &answers = {});

} // namespace palmer
