// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QWidget>

class QApplication;
class QScrollArea;

namespace palmer::ui {

/// The size wished for a window, or as much of it as its screen has room for beside panels and a title bar.
[[nodiscard]] QSize sizeOnScreen(const QWidget &window, QSize wished);

/// Gives a window the size of another, a step beside it, within its screen; one that fills the screen has the
/// size it would go back to. A window that is to fill the screen itself stays so.
void placeBeside(const QWidget &first, QWidget &window);

/// A place that asks for no room: what stands in it (setWidget) fills it, and is scrolled where the place is
/// smaller than its least size.
[[nodiscard]] QScrollArea *scrolledPlace(QWidget *parent);

/// Dialogs that need more room than their screen has are scrolled; their row of buttons stays in sight.
void keepDialogsOnScreen(QApplication &application);

} // namespace palmer::ui
