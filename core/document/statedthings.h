// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/text.h"

#include <span>
#include <string_view>

namespace palmer {

/// Something that a test file can state: what window, report and help call it, and a sentence that says what
/// to enter.
struct StatedThing {
    std::string_view key; ///< in the file, and of the findings that miss it
    Text name;
    Text meaning = {}; ///< none where the name says it all
};

/// In the order of the help.
[[nodiscard]] std::span<const StatedThing> statedThings();

/// Null: none has that key.
[[nodiscard]] const StatedThing *statedThing(std::string_view key);

} // namespace palmer
