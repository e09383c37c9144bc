// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGuiApplication>

namespace palmer::ui {

/// Has every window put what is not saved into its recovery copy before the program is ended from outside:
/// by a signal (SIGTERM, SIGINT, SIGHUP), after which the program ends by that signal, or by the end of the
/// session. The next start offers the copies. To be called once.
void keepCopiesAtEnd(QGuiApplication &application);

/// The same, now.
void keepCopiesOfAllWindows();

} // namespace palmer::ui
