// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/circletraces.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double centreMark = 2; ///< half, mm
constexpr double startRadius = 1.3;
constexpr double halo = 0.35;
constexpr double contactWidth = 1.7;
constexpr double repetitionStrength = 0.45;

/// Number of points from which most points of a path overlap in an image.
constexpr std::size_t denseTrace = 2500;
constexpr std::size_t denseTraceInView = 300;
constexpr double densePixels = 2; ///< between points

/// True if points of a path overlap at this pixel size: a number that only a whole turn has, or several
/// points per pixel in a zoomed view.
bool isDense(const CircleFrame &frame, const std::vector<TracePoint> &points, double pixel) {
    if (points.size() >= denseTrace)
        return true;
    if (frame.whole() || points.size() < denseTraceInView)
        return false;
    const double angle = radians(std::abs(points.back().angle - points.front().angle));
    const double length = angle * frame.figure().plotRadius * frame.scale() / pixel;
    return static_cast<double>(points.size()) * densePixels > length;
}

/// A raster painter takes a second for the joins of thousands of overlapping points: a dense path is
/// drawn as parallel one-pixel lines, which looks the same.
void drawTrace(CircleFrame &frame, const std::vector<TracePoint> &points, QPen line) {
    QPainter &p = frame.painter();
    const double pixel = 1 / std::sqrt(std::abs(p.deviceTransform().determinant()));
    const double width = line.widthF();
    int lines = 1;
    if (frame.isPicture() && isDense(frame, points, pixel) && width > pixel) {
        lines = static_cast<int>(std::ceil(width / pixel));
        line.setWidthF(0.99 * pixel); // fast path of the painter
    }
    p.setPen(line);
    std::vector<QPointF> directions; // shared by all lines: the sine costs as much as everything else
    directions.reserve(points.size());
    for (const TracePoint &point : points)
        directions.push_back(CircleFrame::directionOf(point.angle));
    for (int i = 0; i < lines; ++i) {
        const double offset = lines == 1 ? 0 : (width - pixel) * (static_cast<double>(i) / (lines - 1) - 0.5);
        QPolygonF chain;
        chain.reserve(static_cast<qsizetype>(points.size()));
        for (std::size_t k = 0; k < points.size(); ++k)
            chain << frame.placeOn(directions[k],
                                   frame.figure().radius(points[k].deviation) + offset / frame.scale());
        if (chain.size() == 1)
            p.drawPoint(chain.front());
        else if (frame.whole())
            frame.stroke(chain);
        else
            frame.drawChain(chain);
    }
}

void drawTraces(CircleFrame &frame, bool repetitions, Sense sense) {
    frame.painter().setBrush(Qt::NoBrush);
    for (const CircleTrace &trace : frame.figure().traces) {
        if (trace.repetition != repetitions || trace.synthetic || trace.sense != sense)
            continue;
        QPen line = trace.layer ? layerPen(*trace.layer, frame.medium()) : frame.pen(trace.sense);
        if (trace.layer && trace.sense == Sense::counterclockwise)
            line.setWidthF(line.widthF() / 2);
        if (repetitions) {
            line.setColor(blend(line.color(), frame.colour(FigureRole::background), repetitionStrength));
            line.setWidthF(line.widthF() / 2);
        }
        drawTrace(frame, trace.points, line);
    }
}

void drawStar(CircleFrame &frame, QPointF at, const QColor &ink, double width,
              Qt::PenCapStyle cap = Qt::FlatCap) {
    QPainter &p = frame.painter();
    QPen line(ink);
    line.setWidthF(width);
    line.setCapStyle(cap);
    p.setPen(line);
    for (const double angle : {30.0, 90.0, 150.0}) {
        const QPointF arm = QPointF(std::cos(radians(angle)), std::sin(radians(angle))) * (startRadius * mm);
        p.drawLine(at - arm, at + arm);
    }
}

/// All halos first, because starting points are often close together.
void drawStarts(CircleFrame &frame) {
    for (const bool ground : {true, false}) {
        for (const TraceMark &start : frame.figure().starts) {
            const QPen line = frame.pen(start.sense);
            const double width = std::max(0.24 * mm, 0.75 * line.widthF());
            if (ground)
                drawStar(frame, frame.place(start.at), frame.colour(FigureRole::background),
                         width + 2 * halo * mm, Qt::RoundCap);
            else
                drawStar(frame, frame.place(start.at), line.color(), width);
        }
    }
}

/// Squares: filled on the outer circle, open on the inner one.
void drawContact(CircleFrame &frame, QPointF at, bool outer) {
    QPainter &p = frame.painter();
    const double half = contactWidth * mm / 2;
    QPen line = frame.pen(FigureRole::nominal);
    line.setJoinStyle(Qt::MiterJoin);
    p.setPen(line);
    p.setBrush(outer ? line.color() : frame.colour(FigureRole::background));
    p.drawRect(QRectF(at - QPointF(half, half), at + QPointF(half, half)));
}

void drawPlus(CircleFrame &frame, QPointF at) {
    QPainter &p = frame.painter();
    p.setPen(frame.pen(FigureRole::centre, Qt::FlatCap));
    const double arm = centreMark * mm;
    p.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
    p.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
}

} // namespace

void drawTraces(CircleFrame &frame) {
    QPainter &p = frame.painter();
    for (const bool repetitions : {true, false}) {
        for (const Sense sense : {Sense::clockwise, Sense::counterclockwise}) // the light one above
            drawTraces(frame, repetitions, sense);
    }
    p.setBrush(Qt::NoBrush);
    for (const CircleTrace &trace : frame.figure().traces) {
        if (!trace.synthetic)
            continue;
        p.setPen(frame.pen(FigureRole::synthetic));
        const QPolygonF chain = frame.chainOf(trace.points);
        if (frame.whole())
            p.drawPolyline(chain);
        else
            frame.drawChain(chain);
    }
}

void drawMarks(CircleFrame &frame) {
    drawStarts(frame);
    for (const ContactMark &contact : frame.figure().contacts)
        drawContact(frame, frame.place(contact.mark.at), contact.outer);
    drawPlus(frame, frame.centre());
}

void drawSample(CircleFrame &frame, const QRectF &box, const CircleLegendEntry &entry) {
    QPainter &p = frame.painter();
    const QPointF middle = box.center();
    const auto line = [&](FigureRole role) {
        p.setPen(frame.pen(role, Qt::FlatCap));
        p.drawLine(QPointF(box.left(), middle.y()), QPointF(box.right(), middle.y()));
    };
    switch (entry.sample) {
    case CircleLegendSample::counterclockwise:
        return line(FigureRole::counterclockwise);
    case CircleLegendSample::clockwise:
        return line(FigureRole::clockwise);
    case CircleLegendSample::nominal:
        return line(FigureRole::nominal);
    case CircleLegendSample::envelope:
        return line(FigureRole::envelope);
    case CircleLegendSample::limit:
        return line(FigureRole::limit);
    case CircleLegendSample::synthetic:
        return line(FigureRole::synthetic);
    case CircleLegendSample::layer:
        p.setPen(layerPen(entry.layer, frame.medium()));
        return p.drawLine(QPointF(box.left(), middle.y()), QPointF(box.right(), middle.y()));
    case CircleLegendSample::continued:
        return;
    case CircleLegendSample::centre:
        return drawPlus(frame, middle);
    case CircleLegendSample::start:
        return drawStar(frame, middle, frame.colour(FigureRole::centre), 0.32 * mm);
    case CircleLegendSample::contacts:
        drawContact(frame, middle - QPointF(contactWidth * mm, 0), true);
        return drawContact(frame, middle + QPointF(contactWidth * mm, 0), false);
    case CircleLegendSample::repetitions: {
        double y = middle.y() - 0.6 * mm;
        for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
            if (std::ranges::none_of(frame.figure().traces, [&](const CircleTrace &trace) {
                    return trace.repetition && trace.sense == sense;
                }))
                continue;
            QPen ink = frame.pen(sense);
            ink.setColor(blend(ink.color(), frame.colour(FigureRole::background), repetitionStrength));
            ink.setWidthF(ink.widthF() / 2);
            p.setPen(ink);
            p.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
            y += 1.2 * mm;
        }
        return;
    }
    }
}

} // namespace palmer
