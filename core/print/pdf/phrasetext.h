// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/textblock.h"
#include "report/blocks/report.h"

namespace palmer {

/// Converts a phrase to formatted text. `bold`: everything except muted spans.
[[nodiscard]] RichText richText(const Phrase &phrase, bool bold = false);

/// Placeholder for missing values.
inline const QString thinDash = QStringLiteral("–");

} // namespace palmer
