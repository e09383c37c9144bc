// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawtext.h"

#include "language/visibletext.h"
#include "print/fonts.h"

#include <QFontMetricsF>

namespace palmer {

namespace {

constexpr int subscriptSize = 6;
constexpr double subscriptDrop = 1.9;
/// Capitals and digits of Liberation Sans are 0.72 em high.
constexpr double halfCapital = 0.36 * figureTextSize;

QFont fontOf(const TextPiece &piece, bool bold) {
    return paperFont(piece.subscript ? subscriptSize : figureTextSize, bold);
}

double widthOf(const TextPiece &piece, bool bold) {
    return QFontMetricsF(fontOf(piece, bold)).horizontalAdvance(visibleText(piece.text));
}

} // namespace

double textWidth(const TextLine &line, bool bold) {
    double width = 0;
    for (const TextPiece &piece : line)
        width += widthOf(piece, bold);
    return width;
}

double textWidth(const QString &text, bool bold) {
    return textWidth(TextLine{{text}}, bold);
}

void drawText(QPainter &painter, QPointF leftCentre, const TextLine &line, const QColor &colour, bool bold) {
    painter.setPen(colour);
    double x = leftCentre.x();
    const double baseline = leftCentre.y() + halfCapital;
    for (const TextPiece &piece : line) {
        painter.setFont(fontOf(piece, bold));
        painter.drawText(QPointF(x, baseline + (piece.subscript ? subscriptDrop : 0)),
                         visibleText(piece.text));
        x += widthOf(piece, bold);
    }
}

void drawText(QPainter &painter, QPointF leftCentre, const QString &text, const QColor &colour, bool bold) {
    drawText(painter, leftCentre, TextLine{{text}}, colour, bold);
}

} // namespace palmer
