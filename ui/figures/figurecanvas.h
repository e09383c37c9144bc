// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/measurement/axis.h"
#include "print/figures/drawfigure.h"
#include "ui/figures/figurereadings.h"
#include "ui/figures/plotgestures.h"
#include "ui/model/selection.h"

#include <array>
#include <optional>
#include <vector>

namespace palmer::ui {

/// Marks for an explanation in the figure.
struct FigureMarking {
    std::vector<double> positions;      ///< of the targets that determine the parameter
    std::optional<Dimension> dimension; ///< the distance between them
    QString label;                      ///< "R = 10,26 µm"
};

/// Limits zoom ranges of x and y to the whole figure, and to a depth at which axis numbers still differ.
[[nodiscard]] std::array<Interval, 2> rangesWithin(const CurveFigure &whole, const Interval &x,
                                                   const Interval &y);

/// Canvas of a figure of curves.
class FigureCanvas : public PlotCanvas {
    Q_OBJECT

public:
    explicit FigureCanvas(Selection &selection, QWidget *parent = nullptr);

    /// `readings`: those the pointer can find.
    void setFigure(const CurveFigure &figure, FigureReadings readings);
    void setMarking(const FigureMarking &marking);
    /// Label next to the ring, requested when the pointer moves to another reading.
    void setHoverLabel(const QString &label);
    void clear();

    [[nodiscard]] QRectF range() const override {
        return m_figure ? rangeOf(m_figure->x, m_figure->y) : QRectF();
    }
    /// Asks its owner to show this range.
    void setRange(const QRectF &range) override;
    void fit() override { emit fitWanted(); }

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 270}; }
    /// Position of a reading on the canvas; null if out of view.
    [[nodiscard]] std::optional<QPointF> placeOf(const ReadingPlace &reading);

signals:
    /// The user zooms or pans to these ranges.
    void rangesWanted(const palmer::Interval &x, const palmer::Interval &y);
    void fitWanted();

protected:
    void drawPicture(QPainter &painter) override;
    void paintOver(QPainter &painter) override;
    void layOut() override { drawAnew(); }
    [[nodiscard]] QRectF plotArea() const override { return m_transform.plotArea; }
    [[nodiscard]] QPointF valueAt(const QPointF &place) const override { return m_transform.toData(place); }
    void hover(const std::optional<QPointF> &at) override;
    void click(const QPointF &at) override;

private:
    [[nodiscard]] QPointF shown(const FigureReading &reading) const;
    [[nodiscard]] std::optional<ReadingPlace> nearest(QPointF at) const;
    /// Position of the reading at `place`; null if out of view.
    [[nodiscard]] std::optional<QPointF> shownAt(const ReadingPlace &place) const;
    void paintMarking(QPainter &painter) const;

    Selection &m_selection;
    std::optional<CurveFigure> m_figure;
    FigureReadings m_readings;
    FigureMarking m_marking;
    QString m_hoverLabel;
    FigureTransform m_transform;
};

} // namespace palmer::ui
