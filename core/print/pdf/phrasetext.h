// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/textblock.h"
#include "report/blocks/report.h"

namespace palmer {

/// The spans of a phrase as they are set. `bold`: all but what is muted.
[[nodiscard]] RichText richText(const Phrase &phrase, bool bold = false);

/// What stands where nothing is stated.
inline const QString thinDash = QStringLiteral("–");

} // namespace palmer
