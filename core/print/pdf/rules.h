// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/style.h"

#include <QPainter>

namespace palmer {

// Rules of tables and pages, mm.
constexpr double outerRule = 0.35; ///< top and bottom of a table
constexpr double headRule = 0.2;
constexpr double groupRule = 0.15;
constexpr double strongRule = 0.5; ///< below the titles, around the verdict

inline const QColor groupGrey(0xc4, 0xc4, 0xc4);
inline const QColor ruleGrey(0x77, 0x77, 0x77);
inline const QColor headTint(0xf3, 0xf3, 0xf3);

/// Draws a horizontal rule from `left`, centred at its y; `width` in points, `strength` in mm.
inline void drawRule(QPainter &painter, QPointF left, double width, double strength,
                     const QColor &colour = Qt::black) {
    painter.setPen(QPen(colour, strength * mm, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(left, left + QPointF(width, 0));
}

} // namespace palmer
