// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>
#include <QStyledItemDelegate>

namespace palmer::ui {

/// A head without a look of its own: small words over their columns as the model aligns and colours them, a
/// rule below.
class QuietHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit QuietHeader(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

/// A cell of a quiet table: its text, a light rule below, and the ground of what is current, under the
/// pointer or refused. What is being typed stays when other data arrive.
class QuietDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    enum Role { refusedRole = Qt::UserRole + 20 }; ///< bool: the text was typed and cannot be taken

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;

    void setEditorData(QWidget *editor, const QModelIndex &index) const override;

    /// The cell that is pointed at, here or in a figure.
    void setHovered(const QModelIndex &index) { m_hovered = index; }

private:
    QPersistentModelIndex m_hovered;
};

} // namespace palmer::ui
