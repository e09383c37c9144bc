// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

namespace palmer {

/// Handles the words after `palmer` that need no window: --help and --version on standard output, an option
/// unknown to Palmer and Qt or a missing display with one line on standard error. Returns the exit code; null
/// if the window is to open. `words`: in the encoding of the system, without the program name. Requires no
/// application and no display.
[[nodiscard]] std::optional<int> answeredWithoutWindow(const QStringList &words);

/// The files among the words left by Qt: everything after "--", and all words that are no options.
[[nodiscard]] QStringList filesOf(const QStringList &words);

} // namespace palmer
