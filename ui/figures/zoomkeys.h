// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QPointF>
#include <functional>

namespace palmer::ui {

inline constexpr double zoomStep = 1.25; ///< factor per wheel step or key

/// Callbacks to zoom and move a figure.
struct ZoomMoves {
    std::function<void(int steps)> zoom; ///< about the middle: in, or out if negative
    std::function<void(QPointF by)> pan; ///< pixels
    std::function<void()> fit;
};

/// Keys of all figures: plus and minus zoom, arrows move, 0 shows the whole. False for any other key.
[[nodiscard]] inline bool takeZoomKey(const QKeyEvent &event, const ZoomMoves &moves) {
    constexpr double panStep = 40;
    switch (event.key()) {
    case Qt::Key_Plus:
        moves.zoom(1);
        return true;
    case Qt::Key_Minus:
        moves.zoom(-1);
        return true;
    case Qt::Key_0:
        moves.fit();
        return true;
    case Qt::Key_Left:
        moves.pan({panStep, 0});
        return true;
    case Qt::Key_Right:
        moves.pan({-panStep, 0});
        return true;
    case Qt::Key_Up:
        moves.pan({0, panStep});
        return true;
    case Qt::Key_Down:
        moves.pan({0, -panStep});
        return true;
    default:
        return false;
    }
}

} // namespace palmer::ui
