// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/pagetabs.h"

#include "ui/theme.h"

#include <QPainter>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int tabHeight = 40;
constexpr int lowTabHeight = 28;
constexpr int padding = 4; ///< by which the line extends beyond the word
constexpr int space = 10;  ///< between two tabs: six with their counts fit in a row
constexpr int badgeSize = 20;
constexpr int badgeGap = 6;
constexpr int tightBadgeGap = 3;

QFont tabFont(bool current) {
    return themeFont(current ? TextSize::head : TextSize::base);
}

} // namespace

PageTabs::PageTabs(QWidget *parent)
    : QTabBar(parent) {
    setDrawBase(false);
    setExpanding(false);
    setUsesScrollButtons(true);
    setElideMode(Qt::ElideNone);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QTabBar::currentChanged, this, &PageTabs::fit);
}

void PageTabs::setCount(int tab, int count) {
    if (tabData(tab).toInt() == count)
        return;
    setTabData(tab, count);
    setTabText(tab, tabText(tab)); // updates its width
    updateGeometry();
    update();
}

int PageTabs::count(int tab) const {
    return tabData(tab).toInt();
}

void PageTabs::setLow(bool low) {
    if (std::exchange(m_low, low) == low)
        return;
    if (count() > 0)
        setTabText(0, tabText(0)); // updates the sizes
    updateGeometry();
}

QSize PageTabs::tabSizeHint(int index) const {
    return {widthOf(index, m_tight), m_low ? lowTabHeight : tabHeight};
}

/// As wide as the bold word, so that nothing moves when another tab is chosen.
int PageTabs::widthOf(int index, bool tight) const {
    const QString shown = QString(tabText(index)).remove(u'&');
    const bool bold = !tight || index == currentIndex();
    const int badge = count(index) > 0 ? badgeSize + (tight ? tightBadgeGap : badgeGap) : 0;
    return QFontMetrics(tabFont(bold)).horizontalAdvance(shown) + badge + space;
}

void PageTabs::fit() {
    int whole = 0;
    for (int tab = 0; tab < count(); ++tab)
        whole += isTabVisible(tab) ? widthOf(tab, false) : 0;
    if (const bool tight = whole > width(); tight != m_tight || tight) {
        const bool changes = std::exchange(m_tight, tight) != tight || m_widest != currentIndex();
        m_widest = currentIndex();
        if (changes && count() > 0)
            setTabText(0, tabText(0)); // updates the sizes
    }
}

void PageTabs::resizeEvent(QResizeEvent *event) {
    QTabBar::resizeEvent(event);
    fit();
}

QSize PageTabs::minimumTabSizeHint(int index) const {
    return tabSizeHint(index);
}

void PageTabs::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = token(Token::accent, palette());
    const QFontMetrics bold(tabFont(true));
    for (int tab = 0; tab < count(); ++tab) {
        const bool current = tab == currentIndex();
        const bool hovered = tabRect(tab).contains(mapFromGlobal(QCursor::pos())) && underMouse();
        const QRect area = tabRect(tab).adjusted(0, 0, -(space - 2 * padding), 0);
        painter.setFont(tabFont(current));
        painter.setPen(current || hovered ? palette().color(QPalette::WindowText)
                                          : token(Token::secondaryText, palette()));
        const QString shown = QString(tabText(tab)).remove(u'&');
        const int width = painter.fontMetrics().horizontalAdvance(shown);
        // Centred in the width of the bold word, so that gaps are even; the first is at the edge of the page.
        const int slack = tab == 0 || m_tight ? 0 : (bold.horizontalAdvance(shown) - width) / 2;
        const QRect word = area.adjusted(padding + slack, 0, -padding, 0);
        painter.drawText(word, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic, tabText(tab));
        if (count(tab) > 0) {
            const QRect badge(word.left() + width + (m_tight ? tightBadgeGap : badgeGap),
                              area.center().y() - badgeSize / 2 + 1, badgeSize,
                              badgeSize); // closer to its word than to the next
            painter.setPen(Qt::NoPen);
            painter.setBrush(token(Token::unsureGround, palette()));
            painter.drawRoundedRect(badge, badgeSize / 2.0, badgeSize / 2.0);
            QFont font = themeFont(TextSize::tiny);
            font.setWeight(QFont::DemiBold);
            painter.setFont(font);
            painter.setPen(token(Token::unsure, palette()));
            painter.drawText(badge, Qt::AlignCenter, QString::number(count(tab)));
        }
        if (current)
            painter.fillRect(QRect(area.left(), area.bottom() - 2, area.width(), 3), accent);
        if (current && hasFocus()) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(accent, 2));
            painter.drawRoundedRect(QRectF(area).adjusted(1, m_low ? 2 : 6, -1, m_low ? -2 : -6), 3, 3);
        }
    }
}

} // namespace palmer::ui
