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

/// Marks for an explanation in the figure.
struct FigureMarking {
    std::vector<double> positions;      ///< of the targets that determine the parameter
    std::optional<Dimension> dimension; ///< the distance between them
    QString label;                      ///< "R = 10,26 µm"
};

/// Limits zoom ranges of x and y to the whole figure, and to a depth at which axis numbers still differ.
[[nodiscard]] std::array<Interval, 2> rangesWithin(const CurveFigure &whole, const Interval &x,
                                                   const Interval &y);

/// Canvas of a figure. The figure is drawn once per size, range and theme; whatever follows the pointer is
/// painted over it.
class FigureCanvas : public QWidget {
    Q_OBJECT

public:
    explicit FigureCanvas(Selection &selection, QWidget *parent = nullptr);

    /// `readings`: those the pointer can find.
    void setFigure(const CurveFigure &figure, FigureReadings readings);
    void setMarking(const FigureMarking &marking);
    /// Label next to the ring, requested when the pointer moves to another reading.
    void setHoverLabel(const QString &label);
    void clear();
    /// Zooms in about the middle by so many wheel steps, or out if negative.
    void zoomBy(int steps);

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 270}; }
    /// Position of a reading on the canvas; null if out of view.
    [[nodiscard]] std::optional<QPointF> placeOf(const ReadingPlace &reading);

signals:
    /// The user zooms or pans to these ranges.
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
    /// Position of the reading at `place`; null if out of view.
    [[nodiscard]] std::optional<QPointF> shownAt(const ReadingPlace &place) const;
    void paintMarking(QPainter &painter) const;
    void paintHover(QPainter &painter) const;

    Selection &m_selection;
    std::optional<CurveFigure> m_figure;
    FigureReadings m_readings;
    FigureMarking m_marking;
    QString m_hoverLabel;
    QPixmap m_drawn; ///< null if outdated
    FigureTransform m_transform;
    std::optional<QPointF> m_drag; ///< last position of the pointer
    bool m_dragged = false;
};

} // namespace palmer::ui
