// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/elidedlabel.h"

#include "ui/formulatext.h"

#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QStylePainter>

namespace palmer::ui {

bool namesSymbol(const QString &text) {
    return text.contains(QLatin1StringView("E_VE")) || text.contains(QLatin1StringView("R_LSC"));
}

void drawElided(QPainter &painter, const QRect &area, Qt::Alignment side, const QString &text) {
    painter.drawText(area, static_cast<int>(side | Qt::AlignVCenter),
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, area.width()));
}

void drawElided(QPainter &painter, const QRect &area, Qt::Alignment side, const QString &text,
                const QFont &font, const QColor &colour) {
    painter.setFont(font);
    painter.setPen(colour);
    drawElided(painter, area, side, text);
}

ElidedLabel::ElidedLabel(QWidget *parent)
    : QLabel(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void ElidedLabel::setSeparator(const QString &separator) {
    m_separator = separator;
    update();
}

QString ElidedLabel::shownText() const {
    const QFontMetrics metrics = fontMetrics();
    if (!m_separator.isEmpty() && metrics.horizontalAdvance(text()) > width()) {
        for (const QString &separator : {m_separator, QStringLiteral(", ")}) {
            for (qsizetype end = text().lastIndexOf(separator); end > 0;
                 end = text().lastIndexOf(separator, end - 1)) {
                QString shown = text().first(end) + QStringLiteral(" …");
                if (metrics.horizontalAdvance(shown) <= width())
                    return shown;
            }
        }
        return {};
    }
    return metrics.elidedText(text(), Qt::ElideRight, width());
}

void ElidedLabel::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    const QColor colour = palette().color(foregroundRole());
    if (namesSymbol(text())) {
        const Formula formula = formulaFrom(text());
        if (formulaWidth(formula, font()) <= width()) {
            drawFormula(painter, rect(), alignment(), formula, font(), colour);
            setToolTip({});
            return;
        }
    }
    painter.setPen(colour);
    const QString shown = shownText();
    painter.drawText(rect(), static_cast<int>(alignment()), shown);
    setToolTip(shown == text() ? QString() : text());
}

namespace {

constexpr int besideWords = 4; ///< margin that styles leave within the field

} // namespace

ElidedButton::ElidedButton(QWidget *parent)
    : QPushButton(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QString ElidedButton::shownText() const {
    QStyleOptionButton option;
    initStyleOption(&option);
    const QRect words = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this);
    return fontMetrics().elidedText(text(), Qt::ElideRight, words.width());
}

void ElidedButton::paintEvent(QPaintEvent *) {
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text = shownText();
    painter.drawControl(QStyle::CE_PushButton, option);
    setToolTip(option.text == text() ? QString() : text());
}

QString ElidedBox::shownText() const {
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    const QString text = currentIndex() < 0 ? placeholderText() : currentText();
    return fontMetrics().elidedText(text, Qt::ElideRight, field.width() - besideWords);
}

void ElidedBox::paintEvent(QPaintEvent *) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText = shownText();
    painter.setPen(palette().color(QPalette::Text));
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

} // namespace palmer::ui
