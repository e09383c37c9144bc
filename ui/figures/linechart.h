// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"

#include <QChartView>
#include <QRectF>
#include <functional>
#include <optional>

class QCategoryAxis;

namespace palmer::ui {

/// A line figure as an interactive chart: dragging or the wheel zooms, a double click or 0 shows the whole,
/// and the point under the pointer is labelled. Long lines are drawn as the extremes within the view.
class LineChart : public QChartView {
    Q_OBJECT

public:
    explicit LineChart(QWidget *parent = nullptr);

    /// `empty`: text shown if the figure has no lines.
    void setFigure(const LineFigure &figure, const Language &language, const QString &empty = {});
    [[nodiscard]] const LineFigure &figure() const { return m_figure; }

    using ReadOut = std::function<QString(const FigureLine &, const QPointF &)>;
    /// Label of a point; by default both its numbers.
    void setReadOut(ReadOut readOut) { m_readOut = std::move(readOut); }

    /// The range in view, in the units of the axes.
    [[nodiscard]] QRectF range() const { return m_range; }
    void setRange(const QRectF &range);
    void fit();
    /// Zooms in about the middle by so many wheel steps, or out if negative.
    void zoomBy(int steps);
    /// Label of the point nearest to a widget position; empty if none is near.
    [[nodiscard]] QString readOutAt(const QPointF &place) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 110}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 170}; }

protected:
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    /// A point by the indices of its line and within it.
    struct Place {
        std::size_t line = 0;
        std::size_t point = 0;

        bool operator==(const Place &) const = default;
    };

    void build();
    void fillLines();
    void fillAxes();
    void fillAxis(QCategoryAxis &axis, const FigureAxis &content, double from, double to);
    void zoom(double factor, const QPointF &about);
    [[nodiscard]] QRectF whole() const;
    [[nodiscard]] QPointF valueAt(const QPointF &place) const;
    [[nodiscard]] QPointF placeOf(const QPointF &value) const;
    [[nodiscard]] std::optional<Place> nearest(const QPointF &place) const;
    [[nodiscard]] QString words(const Place &place) const;
    void point(const std::optional<Place> &place);

    LineFigure m_figure;
    Language m_language{Language::Id::english};
    QString m_empty;
    ReadOut m_readOut;
    QRectF m_range;
    QCategoryAxis *m_x = nullptr;
    QCategoryAxis *m_y = nullptr;
    std::optional<Place> m_pointed;
    std::optional<QPointF> m_pressed;
    std::optional<QPointF> m_dragged;
};

} // namespace palmer::ui
