// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"
#include "kernel/measurement/test.h"

#include <string>
#include <vector>

namespace palmer {

/// A value that its statement cannot have, such as a humidity of 130 %. Which these are, the demands of the
/// fields say (`questioned`, `ascending`).
struct ImpossibleValue {
    std::string place; ///< in the test: "conditions.airHumidity"
    double value = 0;  ///< in the unit of the file; of times that fall, the first that does
    Text expected;     ///< "expected a percentage from 0 to 100"
    Finding finding;
};

/// Returns the impossible values of a test in the order of the file; of a list at most one.
[[nodiscard]] std::vector<ImpossibleValue> impossibleValues(const Test &test);

/// Returns a finding for each of them.
[[nodiscard]] std::vector<Finding> findImpossible(const Test &test);

} // namespace palmer
