// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/comparisonview.h"

#include "print/figures/style.h"
#include "ui/theme.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double roomLeft = 54;
constexpr double roomRight = 16;
constexpr double plotAbove = 30;
constexpr double plotBelow = 40;
constexpr double meanLine = 1.6;
constexpr qsizetype markersOfPath = 8;

struct LineStyle {
    Token colour = Token::up;
    Qt::PenStyle dashes = Qt::SolidLine;
    int corners = 0; ///< of the marker; 0: a circle
};
constexpr std::array styles{
    LineStyle{Token::up, Qt::SolidLine, 0},       LineStyle{Token::down, Qt::DashLine, 4},
    LineStyle{Token::ok, Qt::DashDotLine, 3},     LineStyle{Token::explanation, Qt::DotLine, 5},
    LineStyle{Token::bad, Qt::DashDotDotLine, 6}, LineStyle{Token::secondaryText, Qt::SolidLine, 3},
};

void drawMarker(QPainter &painter, const QPointF &at, int corners) {
    constexpr double radius = 3.4;
    if (corners == 0) {
        painter.drawEllipse(at, radius * 0.8, radius * 0.8);
        return;
    }
    QPolygonF shape;
    for (int k = 0; k < corners; ++k) {
        const double angle = 6.283185307179586 * k / corners - 1.5707963267948966;
        shape << at + QPointF(std::cos(angle), std::sin(angle)) * radius;
    }
    painter.drawPolygon(shape);
}

/// Draws a line with a marker at every `step`-th point, starting in the middle of the first step.
void drawLine(QPainter &painter, const QPolygonF &points, const QPen &pen, int corners, qsizetype step) {
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(points);
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen.color());
    for (qsizetype at = step / 2; at < points.size(); at += step)
        drawMarker(painter, points[at], corners);
}

} // namespace

ComparisonView::ComparisonView(QWidget *parent)
    : QWidget(parent) {
    setMinimumHeight(180);
}

void ComparisonView::show(const ComparisonFigure &figure) {
    m_figure = figure;
    QStringList names;
    for (const ComparisonCurve &curve : figure.curves)
        names << curve.name;
    setAccessibleDescription(names.join(QStringLiteral(", ")));
    update();
}

void ComparisonView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    painter.setFont(themeFont(TextSize::tiny));
    if (m_figure.curves.empty() || m_figure.x.ticks.empty())
        return;
    const QRectF plot(roomLeft, plotAbove, width() - roomLeft - roomRight, height() - plotAbove - plotBelow);
    const auto place = [&](double x, double y) {
        return QPointF(plot.left() + (x - m_figure.x.from) / (m_figure.x.to - m_figure.x.from) * plot.width(),
                       plot.bottom() -
                           (y - m_figure.y.from) / (m_figure.y.to - m_figure.y.from) * plot.height());
    };
    const QColor text = token(Token::secondaryText, palette());
    for (const Tick &tick : m_figure.x.ticks) {
        const double x = place(tick.value, m_figure.y.from).x();
        painter.setPen(QPen(token(Token::line, palette()), 1));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(x - 40, plot.bottom() + 3, 80, 16), Qt::AlignHCenter, tick.label);
    }
    for (const Tick &tick : m_figure.y.ticks) {
        const double y = place(m_figure.x.from, tick.value).y();
        painter.setPen(QPen(token(tick.value == 0 ? Token::secondaryText : Token::line, palette()), 1));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(0, y - 8, roomLeft - 6, 16), Qt::AlignRight | Qt::AlignVCenter, tick.label);
    }
    painter.drawText(QRectF(plot.left(), height() - 20, plot.width(), 16), Qt::AlignHCenter,
                     QStringLiteral("%1 (%2)").arg(m_figure.x.quantity, m_figure.x.unit));
    const int third = width() / 3;
    painter.drawText(QRectF(8, 4, third, 16), Qt::AlignLeft | Qt::AlignVCenter,
                     QStringLiteral("%1 (%2)").arg(m_figure.y.quantity, m_figure.y.unit));
    double legend = width() / 3.0;
    for (const ComparisonCurve &curve : m_figure.curves) {
        const LineStyle &style = styles.at(curve.test % styles.size());
        const QColor colour = token(style.colour, palette());
        // Both senses of a circular test have its colour and are as heavy and light as on the page.
        const double width =
            curve.sense ? figurePen(pathRole(*curve.sense), Medium::screenLight).widthF() / pointsPerPixel
                        : meanLine;
        const QPen pen(colour, width, curve.sense ? Qt::SolidLine : style.dashes);
        for (const auto &line : curve.lines) {
            QPolygonF points;
            for (const FigurePoint &point : line)
                points << place(point.x, point.y);
            // A few markers identify a path.
            const qsizetype step = curve.sense ? std::max<qsizetype>(1, points.size() / markersOfPath) : 1;
            drawLine(painter, points, pen, style.corners, step);
        }
        painter.setPen(pen);
        painter.drawLine(QPointF(legend, 12), QPointF(legend + 24, 12));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        drawMarker(painter, QPointF(legend + 12, 12), style.corners);
        painter.setPen(palette().color(QPalette::WindowText));
        const QString name = painter.fontMetrics().elidedText(curve.name, Qt::ElideRight, 140);
        painter.drawText(QPointF(legend + 30, 16), name);
        legend += 44 + painter.fontMetrics().horizontalAdvance(name);
    }
}

} // namespace palmer::ui
