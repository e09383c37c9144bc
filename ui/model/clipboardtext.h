// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMimeData;

namespace palmer::ui {

/// Copied data as lines of tab-separated cells: plain text, or the text of HTML or RTF if there is no other.
[[nodiscard]] QString copiedText(const QMimeData &copied);

/// Returns copiedText of the clipboard.
[[nodiscard]] QString clipboardText();

} // namespace palmer::ui
