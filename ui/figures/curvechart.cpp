// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/curvechart.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLegend>
#include <QLineSeries>
#include <QValueAxis>

namespace palmer::ui {

namespace {

FigureRole lineRole(CurveRole role) {
    switch (role) {
    case CurveRole::up:
        return FigureRole::up;
    case CurveRole::down:
        return FigureRole::down;
    case CurveRole::drift:
        return FigureRole::drift;
    case CurveRole::mean:
        break;
    }
    return FigureRole::mean;
}

FigureRole edgeRole(CurveRole role) {
    return role == CurveRole::down ? FigureRole::downEdge : FigureRole::upEdge;
}

QList<QPointF> edge(const std::vector<BandPoint> &band, double BandPoint::*limit) {
    QList<QPointF> points;
    points.reserve(static_cast<qsizetype>(band.size()));
    for (const BandPoint &point : band)
        points.append({point.x, point.*limit});
    return points;
}

/// A chart that shows nothing but its series, in a plot area that was given.
class BareChart {
public:
    BareChart(const QRectF &area, const QRectF &plot, const CurveFigure &figure)
        : m_plot(plot)
        , m_chart(new QChart) {
        m_scene.setItemIndexMethod(QGraphicsScene::NoIndex);
        m_scene.setSceneRect(area);
        m_scene.addItem(m_chart);
        m_chart->legend()->hide();
        m_chart->setBackgroundVisible(false);
        m_chart->setMargins({});
        m_chart->layout()->setContentsMargins(0, 0, 0, 0);
        for (const auto &[axis, content, alignment] :
             {std::tuple{&m_x, &figure.x, Qt::AlignBottom}, std::tuple{&m_y, &figure.y, Qt::AlignLeft}}) {
            *axis = new QValueAxis;
            (*axis)->setRange(content->from, content->to);
            (*axis)->setVisible(false);
            m_chart->addAxis(*axis, alignment);
        }
    }

    void addLine(const QList<QPointF> &points, const QPen &pen) {
        auto *series = new QLineSeries;
        series->replace(points);
        series->setPen(pen);
        add(series);
    }

    void paint(QPainter &painter) {
        // Once all curves are in: each change of the size has every curve laid out anew. The plot area comes
        // before the first layout: given later, it would leave the axes behind.
        m_chart->setPlotArea(m_plot);
        m_chart->setGeometry(m_scene.sceneRect());
        m_scene.render(&painter, m_scene.sceneRect(), m_scene.sceneRect(), Qt::IgnoreAspectRatio);
    }

private:
    void add(QAbstractSeries *series) {
        m_chart->addSeries(series);
        series->attachAxis(m_x);
        series->attachAxis(m_y);
    }

    QRectF m_plot;
    QGraphicsScene m_scene;
    QChart *m_chart = nullptr;
    QValueAxis *m_x = nullptr;
    QValueAxis *m_y = nullptr;
};

} // namespace

void paintCurves(QPainter &painter, const QRectF &area, const QRectF &plot, const CurveFigure &figure,
                 Medium medium) {
    BareChart chart(area, plot, figure);
    for (const Band &band : figure.bands) {
        if (band.points.size() < 2)
            continue;
        const QPen pen = figurePen(edgeRole(band.role), medium);
        chart.addLine(edge(band.points, &BandPoint::upper), pen);
        chart.addLine(edge(band.points, &BandPoint::lower), pen);
    }
    for (const CurveRole role : {CurveRole::mean, CurveRole::drift, CurveRole::down, CurveRole::up}) {
        for (const Curve &curve : figure.curves) {
            if (curve.role != role || curve.points.size() < 2)
                continue;
            QList<QPointF> points;
            points.reserve(static_cast<qsizetype>(curve.points.size()));
            for (const FigurePoint &point : curve.points)
                points.append({point.x, point.y});
            chart.addLine(points, figurePen(lineRole(role), medium));
        }
    }
    painter.setBrush(Qt::NoBrush); // Qt Charts draws curves with the brush it finds
    chart.paint(painter);
}

} // namespace palmer::ui
