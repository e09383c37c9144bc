// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>

class QPainter;

namespace palmer::ui {

/// A short text in a frame beside a place of a canvas, on the side where there is room, always within it.
void paintCanvasLabel(QPainter &painter, const QWidget &canvas, QPointF beside, const QString &text,
                      const QColor &colour);

} // namespace palmer::ui
