#include "ui/welcome/startbutton.h"

#include "ui/theme.h"

#include <QPainter>

namespace palmer::ui {

StartButton::StartButton(const QString &icon, QWidget *parent)
    : QAbstractButton(parent)
    , m_icon(icon) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    setMinimumSize(sizeHint());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StartButton::setTexts(const QString &title, const QString &detail, const QString &shortcut) {
    setText(title);
    m_detail = detail;
    m_shortcut = shortcut;
    setAccessibleName(QString(title).remove(u'&'));
    setAccessibleDescription(detail);
    update();
}

void StartButton::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = token(Token::accent, palette());
    const double width = hasFocus() ? 2 : 1;
    painter.setPen(QPen(hasFocus() ? accent : token(Token::line, palette()), width));
    painter.setBrush(underMouse() || isDown() ? token(Token::hover, palette())
                                              : palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(width / 2, width / 2, -width / 2, -width / 2), 6, 6);
    drawLineIcon(painter, QRect(8, 0, 36, height()), m_icon, accent);
    const QRect upper(48, 8, this->width() - 60, 20), lower(48, 28, this->width() - 60, 20);
    painter.setFont(themeFont(TextSize::tiny));
    painter.setPen(token(Token::secondaryText, palette()));
    painter.drawText(upper, Qt::AlignRight | Qt::AlignVCenter, m_shortcut);
    painter.setFont(themeFont(TextSize::small));
    painter.drawText(lower, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(m_detail, Qt::ElideRight, lower.width()));
    painter.setFont(themeFont(TextSize::head));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(upper, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic, text());
}

} // namespace palmer::ui
