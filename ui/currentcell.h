// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>

namespace palmer::ui {

/// Makes a cell current and the only selected one. QAbstractItemView::setCurrentIndex depends on the keys
/// held: during Ctrl+Z it would extend the selection, which Delete then erases.
inline void makeCurrent(QAbstractItemView &view, const QModelIndex &index) {
    view.selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect);
}

} // namespace palmer::ui
