// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QSize>
#include <QWidget>

namespace palmer::ui {

/// Returns `wished`, limited to the available size of the window's screen, less a title bar.
[[nodiscard]] QSize sizeOnScreen(const QWidget &window, QSize wished);

/// Gives a window the size of `first` and a position offset from it, within its screen; if `first` fills the
/// screen, its normal size. A window that is maximised or full screen itself is unchanged.
void placeBeside(const QWidget &first, QWidget &window);

/// A scroll area without minimum size: its widget (setWidget) fills it and scrolls if the area is smaller
/// than the widget's minimum size.
[[nodiscard]] QScrollArea *scrolledPlace(QWidget *parent);

/// Makes Tab follow the window's layouts, that is the reading order, instead of the order of creation. The
/// window needs a layout; widgets in no layout keep their place.
void orderTabs(QWidget &window);

/// Does this for each dialog when it is first shown, and makes one too large for its screen scroll, with its
/// button row always visible.
void guardDialogs(QApplication &application);

} // namespace palmer::ui
