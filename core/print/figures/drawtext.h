// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QString>
#include <vector>

namespace palmer {

/// A piece of a line of text; a subscript is lower and smaller.
struct TextPiece {
    QString text;
    bool subscript = false;
};

using TextLine = std::vector<TextPiece>;

constexpr int figureTextSize = 8; ///< points

/// Width of a line in the paper font, points.
[[nodiscard]] double textWidth(const TextLine &line, bool bold = false);
[[nodiscard]] double textWidth(const QString &text, bool bold = false);

/// Draws a line with its left end at x and its capitals centred at y.
void drawText(QPainter &painter, QPointF leftCentre, const TextLine &line, const QColor &colour,
              bool bold = false);
void drawText(QPainter &painter, QPointF leftCentre, const QString &text, const QColor &colour,
              bool bold = false);

} // namespace palmer
