// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStyledItemDelegate>

namespace palmer::ui {

/// Draws a cell of the results: bidirectional bold, its details dimmed, the decision scale, verdict with
/// mark.
class ResultsDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;

    void setExplained(const QString &id) { m_explained = id; }

private:
    QString m_explained;
};

} // namespace palmer::ui
