// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <algorithm>

namespace palmer {

/// Clips a segment to a rectangle; false if they do not intersect.
[[nodiscard]] inline bool clip(QPointF &a, QPointF &b, const QRectF &rect) {
    // On a long path nearly all segments are on one side or inside; this test takes a third of the time.
    const auto [left, right] = std::minmax({a.x(), b.x()});
    const auto [top, bottom] = std::minmax({a.y(), b.y()});
    if (right < rect.left() || left > rect.right() || bottom < rect.top() || top > rect.bottom())
        return false;
    if (left >= rect.left() && right <= rect.right() && top >= rect.top() && bottom <= rect.bottom())
        return true;
    double from = 0;
    double to = 1;
    const QPointF way = b - a;
    const auto cut = [&](double along, double distance) {
        if (along == 0)
            return distance >= 0;
        const double at = distance / along;
        if (along < 0)
            from = std::max(from, at);
        else
            to = std::min(to, at);
        return from <= to;
    };
    if (!cut(-way.x(), a.x() - rect.left()) || !cut(way.x(), rect.right() - a.x()) ||
        !cut(-way.y(), a.y() - rect.top()) || !cut(way.y(), rect.bottom() - a.y()))
        return false;
    b = a + to * way;
    a = a + from * way;
    return true;
}

} // namespace palmer
