// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/measurement/axis.h"
#include "language/units.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palmer {

/// What every pasted table says of itself.
struct Pasted {
    std::size_t taken = 0;           ///< numbers that can be put
    std::vector<ImportChoice> units; ///< they were read in; each can be answered otherwise
    std::vector<Question> questions; ///< to be answered before anything is put
    std::vector<Message> remarks;
};

/// The units that a user reads and types: what a pasted table means where it says nothing.
[[nodiscard]] ImportOptions usualUnits(Motion motion, const DisplayUnits &units);

/// A table that is pasted into an open test, read as a file is. `known` holds whatever it says, `usual` where
/// it says nothing; what only a test states as a whole (correction to 20 °C, axis …) is neither asked nor
/// remarked. A sign is asked where the table speaks of it. Throws Error as importMeasurement does.
[[nodiscard]] Imported readPastedTable(const std::string &text, ImportOptions known,
                                       const ImportOptions &usual = {});

/// What is to be said of it: what could not be used, and what was assumed.
[[nodiscard]] std::vector<Message> remarksOfPaste(const Imported &imported);

/// The questions that want an answer of their own: nothing is put before.
[[nodiscard]] std::vector<Question> doubtsOf(const Imported &imported);

} // namespace palmer
