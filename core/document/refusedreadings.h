// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

#include <nlohmann/json_fwd.hpp>

namespace palmer {

// Texts typed instead of readings. Version 1 of the file has no key for them, so they are kept in the
// extensions of a positioning test: "refusedReadings": [{"run": 1, "target": 3, "text": "4,,8"}].

/// Moves them from the extensions into the measurement. An entry of that name with another form, or for a
/// place that does not exist or has a reading, remains an ordinary extension.
void readRefusedReadings(Test &test);

/// Adds them to the extensions for writing.
void addRefusedReadings(const Test &test, nlohmann::json &extensions);

} // namespace palmer
