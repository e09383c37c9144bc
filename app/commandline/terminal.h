// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace palmer {

/// Columns of the terminal that is written to: those COLUMNS says, else those of the terminal on standard
/// output; nothing where it goes into a file. Found once, at the first call: to be called before outputs are
/// caught.
[[nodiscard]] std::optional<int> terminalColumns();

/// Columns for text and tables: those of the terminal, without one 100.
[[nodiscard]] int textColumns();

} // namespace palmer
