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

/// The outcome of reading a pasted table.
struct Pasted {
    std::size_t taken = 0;           ///< numbers that can be put
    std::vector<ImportChoice> units; ///< they were read in; each can be answered otherwise
    std::vector<Question> questions; ///< to be answered before anything is put
    std::vector<Message> remarks;
};

/// The units that a user reads and types: what a pasted table means where it says nothing.
[[nodiscard]] ImportOptions usualUnits(Motion motion, const DisplayUnits &units);

/// Reads a table pasted into an open test as a file is read. `known` overrides the table, `usual` applies
/// where it states nothing; what only the test states (correction to 20 °C, axis …) is neither asked nor
/// remarked. A sign is asked if the table mentions it. Throws Error as importMeasurement does.
[[nodiscard]] Imported readPastedTable(const std::string &text, ImportOptions known,
                                       const ImportOptions &usual = {});

/// Remarks for the user: what could not be used, and what was assumed.
[[nodiscard]] std::vector<Message> remarksOfPaste(const Imported &imported);

/// The questions that must be answered before anything is pasted.
[[nodiscard]] std::vector<Question> doubtsOf(const Imported &imported);

} // namespace palmer
