// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/grouplayout.h"

#include "ui/forms/field.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int nameWidth = 88;
constexpr int nameGap = 8;
constexpr int aboveName = 8;   ///< where it precedes the rows of a further group
constexpr int leastRows = 520; ///< pixels that the fields of a row need for their labels

} // namespace

GroupLayout::GroupLayout(QLabel *name, int gap, bool first)
    : m_rows(new QVBoxLayout)
    , m_first(first) {
    setContentsMargins(0, 0, 0, 0);
    name->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    addChildWidget(name);
    m_items.push_back(new QWidgetItem(name));
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(gap);
    addChildLayout(m_rows);
    m_items.push_back(m_rows);
}

// A layout owns its items; one that is deleted looks for itself among those of its parent.
GroupLayout::~GroupLayout() {
    while (!m_items.empty()) {
        const QLayoutItem *item = m_items.back();
        m_items.pop_back();
        delete item;
    }
}

void GroupLayout::addRow(QLayout *row) {
    m_rows->addLayout(row);
}

QLayoutItem *GroupLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem *GroupLayout::takeAt(int index) {
    QLayoutItem *item = itemAt(index);
    if (item)
        m_items.erase(m_items.begin() + index);
    return item;
}

void GroupLayout::addItem(QLayoutItem *item) {
    m_items.push_back(item);
}

std::array<QRect, 2> GroupLayout::placesIn(int width) const {
    const auto heightOf = [](const QLayoutItem &item, int within) {
        return item.hasHeightForWidth() ? item.heightForWidth(within) : item.sizeHint().height();
    };
    const int beside = width - nameWidth - nameGap;
    const QLayoutItem &name = *m_items.front();
    if (beside >= leastRows)
        return {QRect(0, 0, nameWidth + nameGap, heightOf(name, nameWidth + nameGap)),
                QRect(nameWidth + nameGap, 0, beside, heightOf(*m_rows, beside))};
    const int above = m_first ? 0 : aboveName;
    const int height = heightOf(name, width);
    return {QRect(0, above, width, height), QRect(0, above + height, width, heightOf(*m_rows, width))};
}

QSize GroupLayout::sizeHint() const {
    return {0, heightForWidth(leastRows)};
}

int GroupLayout::heightForWidth(int width) const {
    const auto places = placesIn(width);
    return std::max(places[0].bottom(), places[1].bottom()) + 1;
}

void GroupLayout::setGeometry(const QRect &area) {
    QLayout::setGeometry(area);
    const auto places = placesIn(area.width());
    for (std::size_t i = 0; i < places.size() && i < m_items.size(); ++i)
        m_items[i]->setGeometry(places.at(i).translated(area.topLeft()));
}

} // namespace palmer::ui
