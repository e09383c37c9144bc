// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QString>

namespace palmer::ui {

/// A report as simple HTML for a window: headings with anchors, paragraphs, pairs and tables. Omits figures,
/// signatures and page breaks.
[[nodiscard]] QString reportHtml(const Report &report);

} // namespace palmer::ui
