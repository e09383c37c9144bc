// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/circleframe.h"
#include "print/figures/drawtext.h"

namespace palmer {

/// Texts of a circle figure and the room they take; texts do not overlap each other, and keep off the paths
/// where there is room. Places in points.
class CircleLabels {
public:
    static constexpr double height = figureTextSize * 1.15;

    /// Precondition: the frame outlives the labels.
    explicit CircleLabels(CircleFrame &frame)
        : m_frame(frame) {}

    /// Box of a text of one line.
    [[nodiscard]] static QRectF boxOf(QPointF centre, double width) {
        return {centre.x() - width / 2 - 1, centre.y() - height / 2, width + 2, height};
    }
    /// Reserves the box of a text in any case.
    void reserve(const QRectF &box) { m_taken.push_back(box); }
    /// Reserves the box of a text; false if it is not in view or overlaps another text.
    bool claim(const QRectF &box);
    [[nodiscard]] bool hasRoom(const QRectF &box) const;
    /// True if a path crosses the box.
    [[nodiscard]] bool isCrossed(const QRectF &box);
    /// True if the box is in view and free of texts and paths.
    [[nodiscard]] bool isFree(const QRectF &box) { return hasRoom(box) && !isCrossed(box); }

    /// Draws a letter where it has room.
    void drawLetter(QPointF centre, const QString &letter);
    /// Draws a text on a filled ground.
    void drawOnGround(QPointF centre, const TextLine &line, bool bold = false);

private:
    CircleFrame &m_frame;
    std::vector<QRectF> m_taken;    ///< boxes of texts
    std::vector<QPolygonF> m_lines; ///< paths, filled on first use
};

/// Draws the width of the envelope as a dimension, if the figure has one.
void drawDimension(CircleFrame &frame, CircleLabels &labels);

/// Draws the limit of a width to scale, centred between the circles it limits.
void drawLimitOfG(CircleFrame &frame, CircleLabels &labels);

} // namespace palmer
