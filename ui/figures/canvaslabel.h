// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>

class QPainter;

namespace palmer::ui {

/// Paints a short framed text next to a point of a canvas, on the side with space, always within the canvas.
void paintCanvasLabel(QPainter &painter, const QWidget &canvas, QPointF beside, const QString &text,
                      const QColor &colour);

/// Paints a ring around the point under the pointer and its label, if not empty.
void paintPointed(QPainter &painter, const QWidget &canvas, QPointF at, const QString &text);

} // namespace palmer::ui
