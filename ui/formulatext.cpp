// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/formulatext.h"

#include "print/fonts.h"
#include "ui/theme.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPalette>
#include <cmath>
#include <vector>

namespace palmer::ui {

namespace {

constexpr double subscriptFactor = 0.72;
constexpr double formulaSubscriptDrop = 0.16; ///< of the font size
constexpr QChar combiningMacron(u'\u0304');

/// Unit of drawing.
struct FormulaPiece {
    QString text;
    QFont font;
    double drop = 0;
    bool barred = false;
    std::optional<Direction> approach;
    bool breakBefore = false; ///< a line may begin here
    double width = 0;
};

bool isArrow(QChar c) {
    return c == u'↑' || c == u'↓';
}

QFont arrowFont(const QFont &font) {
    return paperFont(QFontInfo(font).pixelSize(), true);
}

std::vector<FormulaPiece> pieces(const Formula &formula, const QFont &base, bool strong) {
    std::vector<FormulaPiece> result;
    const double size = QFontInfo(base).pixelSize();
    for (const FormulaSpan &span : formula.spans) {
        QFont font = base;
        if (strong || span.strong)
            font.setWeight(QFont::DemiBold);
        if (span.subscript)
            font.setPixelSize(qMax(1, qRound(size * subscriptFactor)));
        const double drop = span.subscript ? size * formulaSubscriptDrop : 0;
        const auto add = [&](const QString &text, const QFont &its, bool barred, bool breakBefore) {
            const double width = QFontMetricsF(its).horizontalAdvance(text);
            result.push_back({text, its, drop, barred, span.approach, breakBefore, width});
        };
        QString plain;
        bool breakable = false;
        const auto flush = [&] {
            if (!plain.isEmpty())
                add(plain, font, false, breakable);
            plain.clear();
            breakable = false;
        };
        for (qsizetype i = 0; i < span.text.size(); ++i) {
            const QChar c = span.text[i];
            if (i + 1 < span.text.size() && span.text[i + 1] == combiningMacron) {
                flush();
                add(QString(c), font, true, false);
                ++i;
            } else if (isArrow(c)) {
                flush();
                add(QString(c), arrowFont(font), false, false);
            } else if (c == u' ' && !span.strong) {
                plain += c;
                flush();
                breakable = true;
            } else {
                plain += c;
            }
        }
        flush();
    }
    return result;
}

void drawPiece(QPainter &painter, QPointF baseline, const FormulaPiece &piece) {
    painter.setFont(piece.font);
    const QPointF at(baseline.x(), baseline.y() + piece.drop);
    painter.drawText(at, piece.text);
    if (!piece.barred)
        return;
    const QFontMetricsF metrics(piece.font);
    // By the letter as it is drawn, as some fonts state a wrong x-height: a bar that high touches the rule of
    // a row of 20 px.
    const double y = std::floor(at.y() + metrics.tightBoundingRect(piece.text).top()) - 2;
    painter.fillRect(
        QRectF(at.x() + piece.width * 0.12, y, piece.width * 0.76, qMax(1.0, metrics.lineWidth())),
        painter.pen().color());
}

QColor colourOf(const FormulaPiece &piece, const QColor &colour, const QPalette &palette) {
    if (!piece.approach)
        return colour;
    return token(*piece.approach == Direction::positive ? Token::up : Token::downText, palette);
}

} // namespace

double formulaWidth(const Formula &formula, const QFont &font) {
    double width = 0;
    for (const FormulaPiece &piece : pieces(formula, font, false))
        width += piece.width;
    return width;
}

void drawFormula(QPainter &painter, const QRectF &area, Qt::Alignment alignment, const Formula &formula,
                 const QFont &font, const QColor &colour, bool strong) {
    const std::vector<FormulaPiece> parts = pieces(formula, font, strong);
    double width = 0;
    for (const FormulaPiece &piece : parts)
        width += piece.width;
    double x = area.left();
    if (alignment & Qt::AlignRight)
        x = area.right() - width;
    else if (alignment & Qt::AlignHCenter)
        x = area.center().x() - width / 2;
    const QFontMetricsF metrics(font);
    const double y = area.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    painter.setPen(colour);
    for (const FormulaPiece &piece : parts) {
        drawPiece(painter, {x, y}, piece);
        x += piece.width;
    }
}

double drawFormulaLines(QPainter *painter, const QRectF &area, const Formula &formula, const QFont &font,
                        const QColor &colour, const QPalette &palette, double indent) {
    const std::vector<FormulaPiece> parts = pieces(formula, font, false);
    const QFontMetricsF metrics(font);
    const double lineHeight = metrics.height() + 3;
    double x = area.left();
    double y = area.top();
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (parts[k].breakBefore && x > area.left()) {
            double ahead = parts[k].width; // width up to the next possible break
            for (std::size_t next = k + 1; next < parts.size() && !parts[next].breakBefore; ++next)
                ahead += parts[next].width;
            if (x + ahead > area.right()) {
                x = area.left() + indent;
                y += lineHeight;
            }
        }
        if (painter) {
            painter->setPen(colourOf(parts[k], colour, palette));
            drawPiece(*painter, {x, y + metrics.ascent()}, parts[k]);
        }
        x += parts[k].width;
    }
    return y + lineHeight - area.top();
}

} // namespace palmer::ui
