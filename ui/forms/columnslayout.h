// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace palmer::ui {

/// A form row of twelve columns, at the same positions in all rows of a width, whatever their content.
class ColumnsLayout : public QLayout {
public:
    static constexpr int columns = 12;

    /// `gap`: width between two columns, pixels.
    explicit ColumnsLayout(int gap);

    /// Adds a widget over the next columns. An aligned widget keeps its size.
    void add(QWidget *widget, int span, Qt::Alignment alignment = {});

    /// Number of columns in use.
    [[nodiscard]] int taken() const {
        return m_cells.empty() ? 0 : m_cells.back().column + m_cells.back().span;
    }

    [[nodiscard]] int count() const override { return static_cast<int>(m_cells.size()); }
    [[nodiscard]] QLayoutItem *itemAt(int index) const override;
    QLayoutItem *takeAt(int index) override;
    void addItem(QLayoutItem *item) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSize() const override { return {0, sizeHint().height()}; }
    [[nodiscard]] bool hasHeightForWidth() const override;
    [[nodiscard]] int heightForWidth(int width) const override;
    void setGeometry(const QRect &area) override;

private:
    struct Cell {
        std::unique_ptr<QLayoutItem> item;
        int column = 0;
        int span = 1;
    };

    [[nodiscard]] int edge(int column, int width) const;
    [[nodiscard]] int widthOf(const Cell &cell, int width) const;

    std::vector<Cell> m_cells;
    int m_gap;
};

} // namespace palmer::ui
