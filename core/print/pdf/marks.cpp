// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/marks.h"

#include "print/figures/style.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace palmer {

namespace {

constexpr double limitPlace = 0.6; ///< fraction of the width
constexpr double bandHeight = 1.56 * mm;
constexpr double diamondHalf = 0.88 * mm;
constexpr double haloWidth = 0.2 * mm;
constexpr double zeroTick = 1.2 * mm;
constexpr double printedBarHeight = 1.9 * mm;
constexpr double barAxis = 2.9 * mm;
constexpr double hollowOutline = 0.2;
constexpr QColor barColour(0x00, 0x44, 0x88);

QPen line(double width, const QColor &colour = Qt::black) {
    return {QBrush(colour), width * mm, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin};
}

void drawDiamond(QPainter &painter, QPointF centre, const QColor &ink = Qt::black) {
    const auto diamond = [&](double half) {
        return QPolygonF{centre - QPointF(half, 0), centre - QPointF(0, half), centre + QPointF(half, 0),
                         centre + QPointF(0, half)};
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPolygon(diamond(diamondHalf + haloWidth * 1.414));
    painter.setBrush(ink);
    painter.drawPolygon(diamond(diamondHalf));
}

void drawBand(QPainter &painter, const QRectF &band) {
    painter.setPen(line(0.13, QColor(0x55, 0x55, 0x55)));
    painter.setBrush(QColor(0xe4, 0xe4, 0xe4));
    painter.drawRect(band);
}

void drawLimit(QPainter &painter, QPointF centre, const QColor &ink) {
    painter.setPen(line(0.32, ink));
    const QPointF half(0, guardPictureHeight * mm / 2);
    painter.drawLine(centre - half, centre + half);
}

} // namespace

void drawMark(QPainter &painter, Mark mark, QPointF centre, double side, const QColor &ink) {
    const double unit = side / markBox; // points per mm of the mark's own coordinates
    const auto at = [&](double x, double y) {
        return centre + QPointF(x - markBox / 2, y - markBox / 2) * unit;
    };
    painter.setBrush(Qt::NoBrush);
    QPen pen(ink);
    switch (mark) {
    case Mark::check: {
        pen.setWidthF(0.38 * unit);
        pen.setCapStyle(Qt::RoundCap);
        pen.setJoinStyle(Qt::RoundJoin);
        painter.setPen(pen);
        QPainterPath path(at(0.3, 1.42));
        path.lineTo(at(0.92, 2.08));
        path.lineTo(at(2.2, 0.5));
        painter.drawPath(path);
        return;
    }
    case Mark::cross:
        pen.setWidthF(0.52 * unit);
        pen.setCapStyle(Qt::FlatCap);
        painter.setPen(pen);
        painter.drawLine(at(0.4, 0.4), at(2.1, 2.1));
        painter.drawLine(at(0.4, 2.1), at(2.1, 0.4));
        return;
    case Mark::openCircle:
        pen.setWidthF(0.32 * unit);
        painter.setPen(pen);
        painter.drawEllipse(centre, 0.85 * unit, 0.85 * unit);
        return;
    case Mark::warning: {
        pen.setWidthF(0.26 * unit);
        pen.setJoinStyle(Qt::RoundJoin);
        painter.setPen(pen);
        painter.drawPolygon(QPolygonF{at(1.25, 0.22), at(2.37, 2.2), at(0.13, 2.2)});
        pen.setCapStyle(Qt::RoundCap);
        painter.setPen(pen);
        painter.drawLine(at(1.25, 0.95), at(1.25, 1.45));
        painter.drawPoint(at(1.25, 1.83));
        return;
    }
    case Mark::none:
        return;
    }
}

void drawGuardPicture(QPainter &painter, QPointF topLeft, const Guard &guard, const QColor &ink) {
    const double width = guardPictureWidth * mm;
    const double middle = topLeft.y() + guardPictureHeight * mm / 2;
    const double perUnit = limitPlace * width / guard.limit;
    const auto x = [&](double value) { return topLeft.x() + std::clamp(value * perUnit, 0.0, width); };

    painter.setPen(line(0.13, QColor(0x88, 0x88, 0x88)));
    painter.drawLine(QPointF(x(0), middle), QPointF(topLeft.x() + width, middle));
    painter.drawLine(QPointF(x(0), middle - zeroTick / 2), QPointF(x(0), middle + zeroTick / 2));
    if (guard.guardBand) {
        const double from = x(guard.limit - *guard.guardBand);
        const double to = x(guard.limit + *guard.guardBand);
        drawBand(painter, QRectF(from, middle - bandHeight / 2, to - from, bandHeight));
    }
    drawLimit(painter, {x(guard.limit), middle}, ink);
    drawDiamond(painter, {x(guard.value), middle}, ink);
}

void drawWhisker(QPainter &painter, QPointF topLeft, const Whisker &whisker, const QColor &ink,
                 const QColor &ground) {
    constexpr double cap = 0.7 * mm;
    constexpr double point = 0.85 * mm;
    const double middle = topLeft.y() + guardPictureHeight * mm / 2;
    const double perUnit = (guardPictureWidth * mm - 2 * point) / (whisker.to - whisker.from);
    const auto at = [&](double value, double up = 0) {
        return QPointF(topLeft.x() + point +
                           (std::clamp(value, whisker.from, whisker.to) - whisker.from) * perUnit,
                       middle + up);
    };
    drawLimit(painter, at(0), QColor(0x88, 0x88, 0x88));
    painter.setPen(line(0.18, ink));
    const double low = whisker.value - whisker.half;
    const double high = whisker.value + whisker.half;
    painter.drawLine(at(low), at(high));
    for (const double end : {low, high})
        painter.drawLine(at(end, -cap), at(end, cap));
    painter.setPen(line(0.25, ink));
    painter.setBrush(whisker.open ? QBrush(ground) : QBrush(ink));
    painter.drawEllipse(at(whisker.value), point - 0.1 * mm, point - 0.1 * mm);
}

void drawBar(QPainter &painter, QPointF left, double length, bool hollow) {
    if (length > 0) {
        const QPen outline = line(hollowOutline, barColour);
        painter.setPen(hollow ? outline : QPen(Qt::NoPen));
        painter.setBrush(hollow ? QBrush(Qt::NoBrush) : QBrush(barColour));
        const double inset = hollow ? outline.widthF() / 2 : 0; // as high and long as a filled one
        painter.drawRect(QRectF(left.x(), left.y() - printedBarHeight / 2, length, printedBarHeight)
                             .adjusted(0, inset, -std::min(inset, length), -inset));
        painter.setBrush(Qt::NoBrush);
    }
    painter.setPen(line(0.2));
    painter.drawLine(left - QPointF(0, barAxis / 2), left + QPointF(0, barAxis / 2));
}

double legendSignWidth(LegendSign sign) {
    return inOrder(sign, {0.0, 1.76, 0.32, 4.6, markBox, markBox, markBox, markBox});
}

void drawLegendSign(QPainter &painter, LegendSign sign, QPointF centre) {
    switch (sign) {
    case LegendSign::value:
        drawDiamond(painter, centre);
        return;
    case LegendSign::limit: {
        painter.setPen(line(0.32));
        const QPointF half(0, 1.25 * mm);
        painter.drawLine(centre - half, centre + half);
        return;
    }
    case LegendSign::band: {
        const double width = legendSignWidth(sign) * mm;
        drawBand(painter,
                 QRectF(centre.x() - width / 2, centre.y() - bandHeight * 0.4, width, bandHeight * 0.8));
        return;
    }
    default:
        constexpr Mark none = Mark::none;
        const Mark mark = inOrder(
            sign, {none, none, none, none, Mark::check, Mark::cross, Mark::openCircle, Mark::warning});
        drawMark(painter, mark, centre, markBox * mm);
    }
}

} // namespace palmer
