// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QString>

namespace palmer::ui {

/// A report as simple HTML for reading in a window: headings with their anchors, paragraphs, pairs and
/// tables. Figures, signatures and page breaks are left out.
[[nodiscard]] QString reportHtml(const Report &report);

} // namespace palmer::ui
