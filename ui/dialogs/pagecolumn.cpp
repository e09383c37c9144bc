// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/pagecolumn.h"

#include "ui/measures.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int numberHeight = 20;
constexpr std::size_t mostPictures = 12; ///< cached; a page of 1 000 × 1 400 takes 5.6 MB

} // namespace

PageColumn::PageColumn(QWidget *parent)
    : QWidget(parent) {}

void PageColumn::setPages(const Pages &pages) {
    m_pages = pages;
    m_pictures.clear();
    m_current = std::min(m_current, count() - 1);
    resize(sizeHint());
    updateGeometry();
    update();
}

void PageColumn::setScale(double scale) {
    if (m_scale == scale)
        return;
    m_scale = scale;
    m_pictures.clear();
    resize(sizeHint());
    updateGeometry();
    update();
}

void PageColumn::setCurrent(int page) {
    m_current = page;
    update();
}

int PageColumn::gap() const {
    return m_numbered ? numberHeight + pageMargin / 2 : pageMargin;
}

QRect PageColumn::pageRect(int page) const {
    int top = pageMargin;
    for (int i = 0; i < page; ++i)
        top += qRound(m_pages[static_cast<std::size_t>(i)].size.height() * m_scale) + gap();
    const QSize size = (m_pages[static_cast<std::size_t>(page)].size * m_scale).toSize();
    return {QPoint(std::max(pageMargin, (width() - size.width()) / 2), top), size};
}

int PageColumn::pageAt(int y) const {
    int page = 0;
    while (page + 1 < count() && pageRect(page + 1).top() - gap() / 2 <= y)
        ++page;
    return page;
}

QSize PageColumn::sizeHint() const {
    double widest = 0;
    for (const auto &page : m_pages)
        widest = std::max(widest, page.size.width() * m_scale);
    const int bottom = m_pages.empty() ? 0 : pageRect(count() - 1).bottom();
    return {qRound(widest) + 2 * pageMargin, bottom + gap() + 1};
}

const QPixmap &PageColumn::picture(int page) {
    if (m_ratio != devicePixelRatioF()) {
        m_ratio = devicePixelRatioF();
        m_pictures.clear();
    }
    if (const auto found = m_pictures.find(page); found != m_pictures.end())
        return found->second;
    if (!m_numbered && m_pictures.size() >= mostPictures) // remove the most distant page
        m_pictures.erase(page - m_pictures.begin()->first > m_pictures.rbegin()->first - page
                             ? m_pictures.begin()
                             : std::prev(m_pictures.end()));
    QPixmap drawn(pageRect(page).size() * m_ratio);
    drawn.setDevicePixelRatio(m_ratio);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.scale(m_scale, m_scale);
    drawPage(painter, m_pages[static_cast<std::size_t>(page)]);
    painter.end();
    return m_pictures.emplace(page, std::move(drawn)).first->second;
}

void PageColumn::paintEvent(QPaintEvent *event) {
    QPainter painter(this);
    for (int page = 0; page < count(); ++page) {
        const QRect area = pageRect(page);
        if (!event->rect().intersects(area.adjusted(-3, -3, 3, gap())))
            continue;
        painter.drawPixmap(area.topLeft(), picture(page));
        const bool current = m_numbered && page == m_current;
        painter.setPen(QPen(current ? token(Token::accent, palette()) : token(Token::lineStrong, palette()),
                            current ? 2 : 1));
        painter.drawRect(area.adjusted(-1, -1, 0, 0));
        if (m_numbered) {
            painter.setFont(themeFont(current ? TextSize::head : TextSize::small));
            painter.setPen(palette().color(QPalette::WindowText));
            painter.drawText(QRect(0, area.bottom() + 2, width(), numberHeight), Qt::AlignCenter,
                             QString::number(page + 1));
        }
    }
}

void PageColumn::mousePressEvent(QMouseEvent *event) {
    if (event->button() == Qt::LeftButton && count() > 0)
        emit clicked(pageAt(qRound(event->position().y())));
}

} // namespace palmer::ui
