// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMimeData;

namespace palmer::ui {

/// What was copied, as lines of cells parted by tabs: plain text, or what a program copies as HTML or RTF
/// alone.
[[nodiscard]] QString copiedText(const QMimeData &copied);

/// That of the clipboard.
[[nodiscard]] QString clipboardText();

} // namespace palmer::ui
