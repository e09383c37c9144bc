// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/measures.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

namespace palmer::ui {

/// Centres the labels of a form vertically on their fields, whatever these consist of.
inline void alignLabels(QFormLayout &form) {
    form.setVerticalSpacing(8);
    form.setHorizontalSpacing(12);
    for (int row = 0; row < form.rowCount(); ++row) {
        QLayoutItem *item = form.itemAt(row, QFormLayout::LabelRole);
        if (auto *label = item ? qobject_cast<QLabel *>(item->widget()) : nullptr)
            label->setMinimumHeight(fieldHeight);
    }
}

/// Styles a button as the primary one, over the style from its button box.
inline void makePrimary(QPushButton &button) {
    button.setProperty("primary", true);
    button.setDefault(true);
    button.style()->unpolish(&button);
    button.style()->polish(&button);
}

} // namespace palmer::ui
