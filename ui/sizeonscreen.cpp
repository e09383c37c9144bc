// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sizeonscreen.h"

#include <QScreen>
#include <QStyle>

namespace palmer::ui {

QSize sizeOnScreen(const QWidget &window, QSize wished) {
    const QSize room = window.screen()->availableSize();
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &window);
    return wished.boundedTo({room.width(), room.height() - title});
}

} // namespace palmer::ui
