// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>
#include <vector>

namespace palmer::ui {

inline constexpr int textMargin = 8; ///< right of the text of cells and column headers

/// Draws a cell of the readings: numbers, rules and the marks of current, next, hovered, excluded, refused
/// and determining cells. Makes the editor of a cell and reports the typed text and the next step.
class ReadingsDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    /// Move of the current cell after typing.
    enum class Step { stay, next, previous, right, left, up, down };
    Q_ENUM(Step)

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    [[nodiscard]] QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                                        const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const override;

    void setHovered(const QModelIndex &index) { m_hovered = index; }
    void setCurrent(const QModelIndex &index) { m_current = index; }
    /// The next cell of the measuring cycle.
    void setNext(const QModelIndex &index) { m_next = index; }
    void setRuling(std::vector<int> rows) { m_ruling = std::move(rows); }

signals:
    /// A changed text was typed into a cell.
    void typed(const QModelIndex &index, const QString &text) const;
    void stepWanted(palmer::ui::ReadingsDelegate::Step step);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QPersistentModelIndex m_hovered;
    QPersistentModelIndex m_current;
    QPersistentModelIndex m_next;
    std::vector<int> m_ruling;
};

} // namespace palmer::ui
