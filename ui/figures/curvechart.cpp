#include "ui/figures/curvechart.h"

#include "ui/figures/bandoverlap.h"

#include <QAreaSeries>
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
    case CurveRole::mean:
        break;
    }
    return FigureRole::mean;
}

FigureRole edgeRole(CurveRole role) {
    return role == CurveRole::down ? FigureRole::downEdge : FigureRole::upEdge;
}

/// A chart that shows nothing but its series, in a plot area that was given.
class BareChart {
public:
    BareChart(const QRectF &area, const QRectF &plot, const CurveFigure &figure) {
        m_scene.setItemIndexMethod(QGraphicsScene::NoIndex);
        m_scene.setSceneRect(area);
        m_chart = new QChart;
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
        m_chart->setPlotArea(plot); // before the first layout: later the axes would stay behind
        m_chart->setGeometry(area);
    }

    void addLine(const QList<QPointF> &points, const QPen &pen) {
        auto *series = new QLineSeries;
        series->replace(points);
        series->setPen(pen);
        add(series);
    }

    void addArea(const std::vector<BandPoint> &band, const QColor &colour) {
        auto *series = new QAreaSeries;
        auto *upper = new QLineSeries(series);
        auto *lower = new QLineSeries(series);
        upper->replace(edge(band, &BandPoint::upper));
        lower->replace(edge(band, &BandPoint::lower));
        series->setUpperSeries(upper);
        series->setLowerSeries(lower);
        series->setPen(Qt::NoPen);
        series->setBrush(colour);
        add(series);
    }

    [[nodiscard]] static QList<QPointF> edge(const std::vector<BandPoint> &band, double BandPoint::*limit) {
        QList<QPointF> points;
        points.reserve(static_cast<qsizetype>(band.size()));
        for (const BandPoint &point : band)
            points.append({point.x, point.*limit});
        return points;
    }

    void paint(QPainter &painter) {
        m_scene.render(&painter, m_scene.sceneRect(), m_scene.sceneRect(), Qt::IgnoreAspectRatio);
    }

private:
    void add(QAbstractSeries *series) {
        m_chart->addSeries(series);
        series->attachAxis(m_x);
        series->attachAxis(m_y);
    }

    QGraphicsScene m_scene;
    QChart *m_chart = nullptr;
    QValueAxis *m_x = nullptr;
    QValueAxis *m_y = nullptr;
};

} // namespace

void paintChart(QPainter &painter, const QRectF &area, const QRectF &plot, const CurveFigure &figure,
                const std::vector<double> &gridX, const std::vector<double> &gridY, Medium medium) {
    BareChart chart(area, plot, figure);
    // A band of one target has no area: its whisker is drawn with the marks.
    for (const Band &band : figure.bands) {
        if (band.points.size() > 1)
            chart.addArea(band.points,
                          bandColor(band.role == CurveRole::up, band.role == CurveRole::down, medium));
    }
    for (const Band &up : figure.bands) {
        for (const Band &down : figure.bands) {
            if (up.role != CurveRole::up || down.role != CurveRole::down)
                continue;
            for (const auto &overlap : bandOverlap(up.points, down.points))
                chart.addArea(overlap, bandColor(true, true, medium));
        }
    }
    for (const double x : gridX)
        chart.addLine({{x, figure.y.from}, {x, figure.y.to}}, figurePen(FigureRole::grid, medium));
    for (const double y : gridY)
        chart.addLine({{figure.x.from, y}, {figure.x.to, y}},
                      figurePen(y == 0 ? FigureRole::zeroLine : FigureRole::grid, medium));
    for (const Band &band : figure.bands) {
        if (band.points.size() < 2)
            continue;
        const QPen pen = figurePen(edgeRole(band.role), medium);
        chart.addLine(BareChart::edge(band.points, &BandPoint::upper), pen);
        chart.addLine(BareChart::edge(band.points, &BandPoint::lower), pen);
    }
    for (const CurveRole role : {CurveRole::mean, CurveRole::down, CurveRole::up}) {
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
    chart.paint(painter);
}

} // namespace palmer::ui
