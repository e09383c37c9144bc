// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

namespace palmer {

/// What the words after `palmer` ask for that needs no window: --help and --version are answered on standard
/// output, an option that neither Palmer nor Qt knows and a missing display with one line on standard error.
/// The exit code; nothing when the window is to open. `words`: in the encoding of the system, program's name
/// left out. Needs no application, and no display.
[[nodiscard]] std::optional<int> answeredWithoutWindow(const QStringList &words);

/// The files among the words that Qt leaves: all after "--", and what is no option.
[[nodiscard]] QStringList filesOf(const QStringList &words);

} // namespace palmer
