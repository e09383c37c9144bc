// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGuiApplication>

namespace palmer::ui {

/// Makes every window write its unsaved changes to its recovery copy before the program is ended from
/// outside, by a signal (SIGTERM, SIGINT, SIGHUP) or by the end of the session. After a signal the program
/// ends by that signal. The next start offers the copies. Call once.
void keepCopiesAtEnd(QGuiApplication &application);

/// Writes the recovery copies of all windows now.
void keepCopiesOfAllWindows();

} // namespace palmer::ui
