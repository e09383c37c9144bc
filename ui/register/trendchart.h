// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "register/machinetrend.h"
#include "ui/figures/plotchart.h"
#include "ui/qtforward.h"

#include <QDate>
#include <map>
#include <vector>

namespace palmer::ui {

/// The trend of a parameter as a chart: hovering names a test, a click chooses it, zoom is over time only.
class TrendChart : public PlotChart {
    Q_OBJECT

public:
    explicit TrendChart(QWidget *parent = nullptr);

    void setTrend(const MachineTrend &trend, const QDate &today);
    /// Marks the chosen tests (by digest) with the numbers of their curves.
    void setChosen(const std::map<QString, int> &numbers);
    /// Label of a test under the pointer.
    [[nodiscard]] QString label(std::size_t value) const;
    [[nodiscard]] const TrendPanel &panel() const { return m_panel; }
    [[nodiscard]] const MachineTrend &trend() const { return m_trend; }
    void showAll() { fit(); }

signals:
    void testChosen(const QString &digest);

protected:
    void showRange() override;
    void paintOver(QPainter &painter) override;
    [[nodiscard]] QRectF whole() const override { return rangeOf(m_panel.x, m_panel.y); }
    [[nodiscard]] QSizeF deepestZoom() const override;
    void hover(const std::optional<QPointF> &at) override;
    void click(const QPointF &at) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void rebuild();
    void addBand(const QColor &accent);
    void addLine(const std::vector<QPointF> &points, const QPen &pen);
    [[nodiscard]] std::optional<std::size_t> nearest(const QPointF &position) const;
    void drawToday(QPainter &painter, const QRectF &plot, double today) const;
    [[nodiscard]] bool isFree(const QRectF &area) const; ///< by limits and values
    void drawInterventions(QPainter &painter, const QRectF &plot) const;
    void drawInterventionNames(QPainter &painter, const QRectF &plot) const;
    void drawForbidden(QPainter &painter, const QRectF &plot) const;
    void drawEmpty(QPainter &painter) const;
    void drawTags(QPainter &painter, const QRectF &plot) const;
    void drawValues(QPainter &painter, const QRectF &plot) const;
    void drawLabel(QPainter &painter, const QRectF &plot) const;
    void drawNotBefore(QPainter &painter, const QRectF &plot) const;

    MachineTrend m_trend;
    TrendPanel m_panel;
    QDate m_today;
    std::vector<const TrendEntry *> m_entries; ///< per value of the panel
    std::map<QString, int> m_chosen;
    std::optional<std::size_t> m_hovered;
    QCategoryAxis *m_x = nullptr;
    QCategoryAxis *m_y = nullptr;
};

} // namespace palmer::ui
