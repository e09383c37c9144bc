// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"
#include "ui/figures/plotchart.h"

#include <functional>
#include <optional>

class QCategoryAxis;

namespace palmer::ui {

/// A line figure as an interactive chart that labels the point under the pointer. Long lines are drawn as the
/// extremes within the view.
class LineChart : public PlotChart {
    Q_OBJECT

public:
    explicit LineChart(QWidget *parent = nullptr);

    /// `empty`: text shown if the figure has no lines.
    void setFigure(const LineFigure &figure, const Language &language, const QString &empty = {});
    [[nodiscard]] const LineFigure &figure() const { return m_figure; }

    using ReadOut = std::function<QString(const FigureLine &, const QPointF &)>;
    /// Label of a point; by default both its numbers.
    void setReadOut(ReadOut readOut) { m_readOut = std::move(readOut); }

    /// Label of the point nearest to a widget position; empty if none is near.
    [[nodiscard]] QString readOutAt(const QPointF &place) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 110}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 170}; }

protected:
    void showRange() override;
    void paintOver(QPainter &painter) override;
    [[nodiscard]] QRectF whole() const override { return rangeOf(m_figure.x, m_figure.y); }
    [[nodiscard]] QSizeF deepestZoom() const override { return {2000, 2000}; }
    void hover(const std::optional<QPointF> &at) override;
    void changeEvent(QEvent *event) override;

private:
    /// A point by the indices of its line and within it.
    struct Place {
        std::size_t line = 0;
        std::size_t point = 0;

        bool operator==(const Place &) const = default;
    };

    void build();
    void fillLines();
    void fillAxis(QCategoryAxis &axis, const FigureAxis &content, double from, double to);
    [[nodiscard]] std::optional<Place> nearest(const QPointF &place) const;
    [[nodiscard]] QString words(const Place &place) const;

    LineFigure m_figure;
    Language m_language{Language::Id::english};
    QString m_empty;
    ReadOut m_readOut;
    QCategoryAxis *m_x = nullptr;
    QCategoryAxis *m_y = nullptr;
    std::optional<Place> m_pointed;
};

} // namespace palmer::ui
