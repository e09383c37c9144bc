// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QColor>
#include <QPointF>

class QPainter;

namespace palmer {

/// Draws a mark into the square of `side` points around `centre`. They differ in form: black and white is
/// enough.
void drawMark(QPainter &painter, Mark mark, QPointF centre, double side, const QColor &ink = Qt::black);

constexpr double markBox = 2.5; ///< width and height of a mark in a line of text, mm

constexpr double guardPictureWidth = 16;   ///< mm
constexpr double guardPictureHeight = 3.1; ///< mm

/// The limit stands at 60 % of the width in every picture; what lies outside is put on the end.
void drawGuardPicture(QPainter &painter, QPointF topLeft, const Guard &guard, const QColor &ink = Qt::black);

/// A bar of a table from its zero line on, full or its outline; `left` is the middle of that line, `length`
/// in points.
void drawBar(QPainter &painter, QPointF left, double length, bool hollow = false);

/// The signs of a guard picture one by one, for its legend; around `centre`. Widths in mm.
[[nodiscard]] double legendSignWidth(LegendSign sign);
void drawLegendSign(QPainter &painter, LegendSign sign, QPointF centre);

} // namespace palmer
