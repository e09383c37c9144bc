#pragma once

#include <QStyledItemDelegate>

namespace palmer::ui {

/// A cell with a bar from its left end: the part of the width, 0 to 1, that the item holds in `partRole`. The
/// first row, what is to be improved first, in the accent.
class ContributionBars : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int partRole = Qt::UserRole;

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
};

} // namespace palmer::ui
