// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QLayout>
#include <array>
#include <memory>

namespace palmer::ui {

/// A group of a form: its name on the left of its rows, or above them where the rows would get too narrow.
class GroupLayout : public QLayout {
    Q_DISABLE_COPY(GroupLayout)

public:
    /// `gap`: height between two rows, pixels; `first` of its section: directly below what precedes it.
    GroupLayout(QLabel *name, int gap, bool first);
    ~GroupLayout() override;

    void addRow(QLayout *row);

    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem *itemAt(int index) const override;
    QLayoutItem *takeAt(int index) override;
    void addItem(QLayoutItem *item) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSize() const override { return {0, sizeHint().height()}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    void setGeometry(const QRect &area) override;

private:
    /// Rectangles of name and rows in an area of that width.
    [[nodiscard]] std::array<QRect, 2> placesIn(int width) const;

    QVBoxLayout *m_rows;
    bool m_first;
    std::vector<QLayoutItem *> m_items; ///< name, rows; owned
};

} // namespace palmer::ui
