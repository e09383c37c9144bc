// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QColor>
#include <QPointF>

class QPainter;

namespace palmer {

/// Draws a mark into a square of `side` points around `centre`. Marks differ in shape, so black and white is
/// enough.
void drawMark(QPainter &painter, Mark mark, QPointF centre, double side, const QColor &ink = Qt::black);

constexpr double markBox = 2.5; ///< width and height of a mark in a text line, mm

constexpr double guardPictureWidth = 16;   ///< mm
constexpr double guardPictureHeight = 3.1; ///< mm

/// The limit is at 60 % of the width in every picture; values outside are drawn at the end.
void drawGuardPicture(QPainter &painter, QPointF topLeft, const Guard &guard, const QColor &ink = Qt::black);

/// The picture of a difference, as large.
void drawWhisker(QPainter &painter, QPointF topLeft, const Whisker &whisker, const QColor &ink = Qt::black,
                 const QColor &ground = Qt::white);

/// Draws a bar of a table from its zero line, filled or as an outline; `left` is the middle of that line,
/// `length` in points.
void drawBar(QPainter &painter, QPointF left, double length, bool hollow = false);

/// Single symbols of a guard picture for its legend; around `centre`. Widths in mm.
[[nodiscard]] double legendSignWidth(LegendSign sign);
void drawLegendSign(QPainter &painter, LegendSign sign, QPointF centre);

} // namespace palmer
