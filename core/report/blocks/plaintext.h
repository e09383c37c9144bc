// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QString>
#include <QStringView>

namespace palmer {

inline constexpr int terminalWidth = 100; ///< columns

/// Columns of a terminal that a text takes: combining marks (x̄) none, wide characters of East Asia two.
[[nodiscard]] int displayWidth(QStringView text);

/// The text broken at its spaces into lines of at most `width` columns; a word that is longer stands alone
/// and over. No-break spaces do not break.
[[nodiscard]] QStringList wrapped(const QString &text, int width);

/// A report as plain text for a terminal of `width` columns, lines ending in '\n' and never in a space.
[[nodiscard]] QString plainText(const Report &report, int width = terminalWidth);

} // namespace palmer
