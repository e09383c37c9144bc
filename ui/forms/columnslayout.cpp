// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/columnslayout.h"

#include <QWidget>
#include <algorithm>

namespace palmer::ui {

ColumnsLayout::ColumnsLayout(int gap)
    : m_gap(gap) {
    setContentsMargins(0, 0, 0, 0);
}

void ColumnsLayout::add(QWidget *widget, int span, Qt::Alignment alignment) {
    addChildWidget(widget);
    auto item = std::make_unique<QWidgetItem>(widget);
    item->setAlignment(alignment);
    m_cells.push_back({std::move(item), taken(), span});
    invalidate();
}

QLayoutItem *ColumnsLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_cells[static_cast<std::size_t>(index)].item.get() : nullptr;
}

QLayoutItem *ColumnsLayout::takeAt(int index) {
    if (index < 0 || index >= count())
        return nullptr;
    const auto cell = m_cells.begin() + index;
    QLayoutItem *item = cell->item.release();
    m_cells.erase(cell);
    invalidate();
    return item;
}

void ColumnsLayout::addItem(QLayoutItem *item) {
    m_cells.push_back({std::unique_ptr<QLayoutItem>(item), taken(), 1});
}

/// x coordinate of the left edge of a column.
int ColumnsLayout::edge(int column, int width) const {
    return column * (width + m_gap) / columns;
}

int ColumnsLayout::widthOf(const Cell &cell, int width) const {
    return edge(cell.column + cell.span, width) - m_gap - edge(cell.column, width);
}

QSize ColumnsLayout::sizeHint() const {
    int height = 0;
    for (const Cell &cell : m_cells)
        height = std::max(height, cell.item->sizeHint().height());
    return {0, height};
}

bool ColumnsLayout::hasHeightForWidth() const {
    return std::ranges::any_of(m_cells, [](const Cell &cell) { return cell.item->hasHeightForWidth(); });
}

int ColumnsLayout::heightForWidth(int width) const {
    int height = 0;
    for (const Cell &cell : m_cells) {
        height =
            std::max(height, cell.item->hasHeightForWidth() ? cell.item->heightForWidth(widthOf(cell, width))
                                                            : cell.item->sizeHint().height());
    }
    return height;
}

void ColumnsLayout::setGeometry(const QRect &area) {
    QLayout::setGeometry(area);
    for (const Cell &cell : m_cells) {
        cell.item->setGeometry({area.left() + edge(cell.column, area.width()), area.top(),
                                widthOf(cell, area.width()), area.height()});
    }
}

} // namespace palmer::ui
