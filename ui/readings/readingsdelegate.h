#pragma once

#include <QStyledItemDelegate>
#include <vector>

namespace palmer::ui {

/// Draws a cell of the readings: numbers, rules, and the marks of what is current, pointed at, set aside or
/// ruling.
class ReadingsDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;

    void setHovered(const QModelIndex &index) { m_hovered = index; }
    void setCurrent(const QModelIndex &index) { m_current = index; }
    void setRuling(std::vector<int> rows) { m_ruling = std::move(rows); }

private:
    QPersistentModelIndex m_hovered;
    QPersistentModelIndex m_current;
    std::vector<int> m_ruling;
};

} // namespace palmer::ui
