// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/measurement/axis.h"
#include "language/units.h"

#include <string>

namespace palmer {

/// The units that a user reads and types: what a pasted table means where it says nothing.
[[nodiscard]] ImportOptions usualUnits(Motion motion, const DisplayUnits &units);

/// A table that is pasted into an open test, read as a file is. `known` holds whatever it says, `usual` where
/// it says nothing; what only a test states as a whole (correction to 20 °C, axis, sign …) is neither asked
/// nor remarked. Throws Error as importMeasurement does.
[[nodiscard]] Imported readPastedTable(const std::string &text, ImportOptions known,
                                       const ImportOptions &usual = {});

} // namespace palmer
