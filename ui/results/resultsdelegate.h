// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/quiettable.h"

#include <QString>

namespace palmer::ui {

/// Draws a cell of the results: bidirectional bold, its details dimmed, the decision scale, verdict with
/// mark.
class ResultsDelegate : public RowDelegate {
    Q_OBJECT

public:
    using RowDelegate::RowDelegate;

    void setExplained(const QString &id) { m_explained = id; }

protected:
    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override;

private:
    QString m_explained;
};

} // namespace palmer::ui
