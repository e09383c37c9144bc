// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <QString>
#include <QWidget>

namespace palmer::ui {

/// Returns a new widget with an object name.
template <class Widget>
[[nodiscard]] Widget *made(const char *name) {
    auto *widget = new Widget;
    widget->setObjectName(QString::fromLatin1(name));
    return widget;
}

/// Returns a new widget with an object name and a text size of the theme.
template <class Widget>
[[nodiscard]] Widget *made(const char *name, TextSize size) {
    auto *widget = made<Widget>(name);
    widget->setFont(themeFont(size));
    return widget;
}

/// Returns a new layout without margins and spacing; `parent` may be null.
template <class Layout>
[[nodiscard]] Layout *tight(QWidget *parent = nullptr) {
    auto *layout = new Layout(parent);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    return layout;
}

} // namespace palmer::ui
