// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/circlefigure.h"
#include "language/language.h"
#include "print/figures/drawfigure.h"
#include "ui/figures/plotgestures.h"

#include <optional>
#include <span>

namespace palmer::ui {

/// Canvas of a figure of circles; the same point stays in the middle when its size changes.
class CirclePlot : public PlotCanvas {
    Q_OBJECT

public:
    using PlotCanvas::PlotCanvas;

    [[nodiscard]] const CircleView &view() const { return m_view; }
    void setView(const CircleView &view);
    void fit() override { setView({}); }
    [[nodiscard]] QRectF range() const override;
    void setRange(const QRectF &range) override;

protected:
    /// The whole figure in a size (mm), with points this far apart (mm).
    [[nodiscard]] virtual CircleFigure wholeFigure(QSizeF size, double pointStep) const = 0;
    /// The profiles of the figure.
    [[nodiscard]] virtual std::span<const PathProfile> paths() const = 0;
    [[nodiscard]] QRectF plotArea() const override { return rect(); }

    /// Makes the figure for the current size, resolution and view.
    void fitFigure();
    /// The figure is made anew with the next repaint.
    void discardFigure();

    void layOut() override { drawAnew(); }
    [[nodiscard]] QRectF whole() const override;
    [[nodiscard]] QSizeF deepestZoom() const override;
    [[nodiscard]] QPointF valueAt(const QPointF &place) const override { return m_transform.toData(place); }

    Language m_language{Language::Id::english};
    std::optional<CircleFigure> m_figure; ///< in the last painted view; null if outdated
    FigureTransform m_transform;

private:
    CircleView m_view;
};

} // namespace palmer::ui
