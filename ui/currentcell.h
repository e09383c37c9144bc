// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>

namespace palmer::ui {

/// Makes a cell the current one and alone selected. QAbstractItemView::setCurrentIndex goes by the keys that
/// are held: during Ctrl+Z it would add to what is selected, which Delete then erases.
inline void makeCurrent(QAbstractItemView &view, const QModelIndex &index) {
    view.selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect);
}

} // namespace palmer::ui
