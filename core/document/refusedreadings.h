// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

#include <nlohmann/json_fwd.hpp>

namespace palmer {

// Texts that were typed in the place of readings. Version 1 of the file has no key for them, so they stand in
// the extensions of a positioning test: "refusedReadings": [{"run": 1, "target": 3, "text": "4,,8"}].

/// Moves them from the extensions into the measurement. An entry of that name in another form, or of a place
/// that the test does not have or where there is a reading, stays an extension like any other.
void takeRefusedReadings(Test &test);

/// Adds them to the extensions as they are written.
void addRefusedReadings(const Test &test, nlohmann::json &extensions);

} // namespace palmer
