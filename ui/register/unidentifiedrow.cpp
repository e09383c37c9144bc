// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/unidentifiedrow.h"

#include "ui/measures.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QPainter>

namespace palmer::ui {

UnidentifiedRow::UnidentifiedRow(QWidget *parent)
    : Translated(parent) {
    setCheckable(true);
    setFixedHeight(rowHeight);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    retranslate();
}

void UnidentifiedRow::setTests(int tests) {
    m_tests = tests;
    retranslate();
}

void UnidentifiedRow::retranslate() {
    setText(tr("Not identified"));
    m_below = withGroups(tr("%n test(s) without serial number", nullptr, m_tests), m_tests);
    setAccessibleName(text() + QStringLiteral(", ") + m_below);
    update();
}

void UnidentifiedRow::paintEvent(QPaintEvent *) {
    constexpr int sign = 16;
    QPainter painter(this);
    if (isChecked())
        painter.fillRect(rect(), selectedGround(palette()));
    else if (underMouse())
        painter.fillRect(rect(), token(Token::hover, palette()));
    painter.setPen(token(Token::line, palette()));
    painter.drawLine(rect().topLeft(), rect().topRight());
    if (hasFocus()) {
        painter.setPen(QPen(token(Token::accent, palette()), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    drawLineIcon(painter, QRect(pageMargin - 4, 0, sign, height()), QStringLiteral("ques"),
                 token(Token::unsure, palette()));
    drawLineIcon(painter, QRect(width() - pageMargin - sign + 4, 0, sign, height()),
                 isChecked() ? QStringLiteral("close") : QStringLiteral("right"),
                 token(Token::secondaryText, palette()));
    const QRect words = rect().adjusted(pageMargin + sign + 8, 5, -pageMargin - sign, -5);
    const auto line = [&](Qt::Alignment where, const QString &said) {
        painter.drawText(words, Qt::AlignLeft | where,
                         painter.fontMetrics().elidedText(said, Qt::ElideRight, words.width()));
    };
    painter.setFont(themeFont(TextSize::base));
    painter.setPen(palette().color(QPalette::WindowText));
    line(Qt::AlignTop, text());
    painter.setFont(themeFont(TextSize::tiny));
    painter.setPen(token(Token::secondaryText, palette()));
    line(Qt::AlignBottom, m_below);
}

} // namespace palmer::ui
