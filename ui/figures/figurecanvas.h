// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/measurement/axis.h"
#include "print/figures/drawfigure.h"
#include "ui/figures/figurereadings.h"
#include "ui/model/selection.h"

#include <QPixmap>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

namespace palmer::ui {

/// What an explanation marks in the figure.
struct FigureMarking {
    std::vector<double> positions;      ///< of the ruling targets
    std::optional<Dimension> dimension; ///< what is measured between them
    QString label;                      ///< "R = 10,26 µm"
};

/// Ranges of x and y to zoom to: never beyond the whole, never so deep that the numbers of the axes say
/// nothing.
[[nodiscard]] std::array<Interval, 2> rangesWithin(const CurveFigure &whole, const Interval &x,
                                                   const Interval &y);

/// The surface of a figure. The figure itself is drawn once for a size, range and theme; what moves with the
/// pointer lies over it.
class FigureCanvas : public QWidget {
    Q_OBJECT

public:
    explicit FigureCanvas(Selection &selection, QWidget *parent = nullptr);

    /// `readings`: what the pointer finds.
    void setFigure(const CurveFigure &figure, FigureReadings readings);
    void setMarking(const FigureMarking &marking);
    /// What the label beside the ring says; asked for when the pointer moves to another reading.
    void setHoverLabel(const QString &label);
    void clear();
    /// In by so many steps of the wheel about the middle, out where negative.
    void zoomBy(int steps);

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 270}; }
    /// Where a reading stands on the canvas; nothing where it is out of view.
    [[nodiscard]] std::optional<QPointF> placeOf(const ReadingPlace &reading);

signals:
    /// The user zooms or pans: show these ranges.
    void rangesWanted(const palmer::Interval &x, const palmer::Interval &y);
    void fitWanted();

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void drawAnew();
    void zoom(double factor, QPointF about);
    void pan(QPointF by);
    [[nodiscard]] QPointF shown(const FigureReading &reading) const;
    [[nodiscard]] std::optional<FigureReading> nearest(QPointF at) const;
    /// In view and at this place.
    [[nodiscard]] std::optional<QPointF> shownAt(const ReadingPlace &place) const;
    void paintMarking(QPainter &painter) const;
    void paintHover(QPainter &painter) const;

    Selection &m_selection;
    std::optional<CurveFigure> m_figure;
    FigureReadings m_readings;
    FigureMarking m_marking;
    QString m_hoverLabel;
    QPixmap m_drawn; ///< null: to be drawn
    FigureTransform m_transform;
    std::optional<QPointF> m_drag; ///< where the pointer was
    bool m_dragged = false;
};

} // namespace palmer::ui
