// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/circlelabels.h"

#include <algorithm>

namespace palmer {

bool CircleLabels::take(const QRectF &box) {
    if (!hasRoom(box))
        return false;
    reserve(box);
    return true;
}

bool CircleLabels::hasRoom(const QRectF &box) const {
    return m_frame.plot().contains(box) &&
           std::ranges::none_of(m_taken, [&](const QRectF &other) { return other.intersects(box); });
}

bool CircleLabels::isCrossed(const QRectF &box) {
    if (m_lines.empty()) {
        for (const CircleTrace &trace : m_frame.figure().traces)
            m_lines.push_back(m_frame.chainOf(trace.points));
    }
    return std::ranges::any_of(m_lines, [&](const QPolygonF &line) {
        for (qsizetype i = 0; i < line.size(); ++i) {
            QPointF from = line[std::max<qsizetype>(i - 1, 0)];
            QPointF to = line[i];
            if (clip(from, to, box))
                return true;
        }
        return false;
    });
}

void CircleLabels::drawLetter(QPointF centre, const QString &letter) {
    const double width = textWidth(letter);
    if (take(boxOf(centre, width)))
        drawText(m_frame.painter(), centre - QPointF(width / 2, 0), letter, m_frame.colour(FigureRole::text));
}

void CircleLabels::drawOnGround(QPointF centre, const TextLine &line, bool bold) {
    const double width = textWidth(line, bold);
    m_frame.painter().fillRect(boxOf(centre, width), m_frame.colour(FigureRole::background));
    drawText(m_frame.painter(), {centre.x() - width / 2, centre.y()}, line, m_frame.colour(FigureRole::text),
             bold);
}

} // namespace palmer
