// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QString>
#include <QStringView>

namespace palmer {

inline constexpr int terminalWidth = 100; ///< columns

/// Columns of a terminal that a text takes: 0 for combining marks (x̄), 2 for wide East Asian characters.
[[nodiscard]] int displayWidth(QStringView text);

/// Breaks a text at its spaces into lines of at most `width` columns; a longer word gets its own, overlong
/// line. No-break spaces do not break.
[[nodiscard]] QStringList wrapped(const QString &text, int width);

/// A report as plain text for a terminal of `width` columns; lines end in '\n', never in a space.
[[nodiscard]] QString plainText(const Report &report, int width = terminalWidth);

} // namespace palmer
