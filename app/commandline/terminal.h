// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace palmer {

/// Columns of the terminal: COLUMNS, otherwise those of the terminal on standard output; null if it is a
/// file. Determined at the first call, which must precede any redirection of the output.
[[nodiscard]] std::optional<int> terminalColumns();

/// Columns for text and tables: those of the terminal, otherwise 100.
[[nodiscard]] int textColumns();

} // namespace palmer
