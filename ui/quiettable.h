// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>
#include <QStyledItemDelegate>

namespace palmer::ui {

/// A plain header: small words over their columns, aligned and coloured by the model, with a rule below.
class QuietHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit QuietHeader(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

/// A cell of a quiet table: its text, a light rule below, and a background if current, under the pointer or
/// refused. Typing continues when other data arrive.
class QuietDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    enum Role { refusedRole = Qt::UserRole + 20 }; ///< bool: the text was typed and refused

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;

    void setEditorData(QWidget *editor, const QModelIndex &index) const override;

    /// The cell pointed at, here or in a figure.
    void setHovered(const QModelIndex &index) { m_hovered = index; }

private:
    QPersistentModelIndex m_hovered;
};

} // namespace palmer::ui
