// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QWidget>

namespace palmer::ui {

/// The size wished for a window, or as much of it as its screen has room for beside panels and a title bar.
[[nodiscard]] QSize sizeOnScreen(const QWidget &window, QSize wished);

} // namespace palmer::ui
