// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/pagetabs.h"

#include "ui/theme.h"

#include <QPainter>
#include <array>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int tabHeight = 40;
constexpr int lowTabHeight = 28;

struct Measures {
    int padding; ///< by which the line extends beyond the word
    int space;   ///< between two tabs: six with their counts fit in a row
    int badge;
    int badgeGap;
};
constexpr std::array measuresOf{Measures{4, 10, 20, 6}, Measures{4, 10, 20, 3}, Measures{3, 6, 16, 2},
                                Measures{2, 4, 6, 1}};

constexpr const Measures &measures(PageTabs::Tightness tightness) {
    return measuresOf[static_cast<std::size_t>(tightness)];
}

QFont tabFont(bool current, PageTabs::Tightness tightness) {
    if (tightness < PageTabs::Tightness::small)
        return themeFont(current ? TextSize::head : TextSize::base);
    QFont font = themeFont(tightness == PageTabs::Tightness::small ? TextSize::small : TextSize::tiny);
    font.setWeight(current ? QFont::DemiBold : QFont::Normal);
    return font;
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
    return {widthOf(index, m_tightness), m_low ? lowTabHeight : tabHeight};
}

/// As wide as the bold word, so that nothing moves when another tab is chosen.
int PageTabs::widthOf(int index, Tightness tightness) const {
    const QString shown = QString(tabText(index)).remove(u'&');
    const bool bold = tightness == Tightness::none || index == currentIndex();
    const Measures &all = measures(tightness);
    const int badge = count(index) > 0 ? all.badge + all.badgeGap : 0;
    return QFontMetrics(tabFont(bold, tightness)).horizontalAdvance(shown) + badge + all.space;
}

/// True if all tabs are in view.
bool PageTabs::fits(Tightness tightness) const {
    int whole = 0;
    for (int tab = 0; tab < count(); ++tab)
        whole += isTabVisible(tab) ? widthOf(tab, tightness) : 0;
    return whole <= width();
}

void PageTabs::fit() {
    Tightness tightness = Tightness::none;
    while (tightness != Tightness::dots && !fits(tightness))
        tightness = static_cast<Tightness>(static_cast<int>(tightness) + 1);
    if (tightness == Tightness::none && m_tightness == tightness)
        return;
    const bool changes = std::exchange(m_tightness, tightness) != tightness || m_widest != currentIndex();
    m_widest = currentIndex();
    if (changes && count() > 0)
        setTabText(0, tabText(0)); // updates the sizes
}

void PageTabs::resizeEvent(QResizeEvent *event) {
    QTabBar::resizeEvent(event);
    fit();
}

QSize PageTabs::minimumTabSizeHint(int index) const {
    return tabSizeHint(index);
}

void PageTabs::paintCount(QPainter &painter, const QRect &badge, int count) const {
    const bool isDot = m_tightness == Tightness::dots;
    painter.setPen(Qt::NoPen);
    painter.setBrush(token(isDot ? Token::unsure : Token::unsureGround, palette()));
    painter.drawRoundedRect(badge, badge.width() / 2.0, badge.width() / 2.0);
    if (isDot)
        return;
    QFont font = themeFont(TextSize::tiny);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(token(Token::unsure, palette()));
    painter.drawText(badge, Qt::AlignCenter, QString::number(count));
}

void PageTabs::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = token(Token::accent, palette());
    const auto &[padding, space, badgeSize, badgeGap] = measures(m_tightness);
    const QFontMetrics bold(tabFont(true, m_tightness));
    for (int tab = 0; tab < count(); ++tab) {
        const bool current = tab == currentIndex();
        const bool hovered = tabRect(tab).contains(mapFromGlobal(QCursor::pos())) && underMouse();
        const QRect area = tabRect(tab).adjusted(0, 0, -(space - 2 * padding), 0);
        painter.setFont(tabFont(current, m_tightness));
        painter.setPen(current || hovered ? palette().color(QPalette::WindowText)
                                          : token(Token::secondaryText, palette()));
        const QString shown = QString(tabText(tab)).remove(u'&');
        const int width = painter.fontMetrics().horizontalAdvance(shown);
        // Centred in the width of the bold word, so that gaps are even; the first is at the edge of the page.
        const int slack =
            tab == 0 || m_tightness != Tightness::none ? 0 : (bold.horizontalAdvance(shown) - width) / 2;
        const QRect word = area.adjusted(padding + slack, 0, -padding, 0);
        painter.drawText(word, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic, tabText(tab));
        if (count(tab) > 0) {
            const QRect badge(word.left() + width + badgeGap, area.center().y() - badgeSize / 2 + 1,
                              badgeSize,
                              badgeSize); // closer to its word than to the next
            paintCount(painter, badge, count(tab));
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
