#pragma once

#include <QFormLayout>
#include <QLabel>

namespace palmer::ui {

/// Puts the labels of a form on the middle of their fields, however these are made up.
inline void alignLabels(QFormLayout &form) {
    constexpr int fieldHeight = 28;
    form.setVerticalSpacing(8);
    form.setHorizontalSpacing(12);
    for (int row = 0; row < form.rowCount(); ++row) {
        QLayoutItem *item = form.itemAt(row, QFormLayout::LabelRole);
        if (auto *label = item ? qobject_cast<QLabel *>(item->widget()) : nullptr)
            label->setMinimumHeight(fieldHeight);
    }
}

} // namespace palmer::ui
