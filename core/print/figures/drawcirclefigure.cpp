// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawcirclefigure.h"

#include "print/figures/drawtext.h"

#include <QPaintEngine>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace palmer {

namespace {

// Dimensions on the printed page, mm of the figure unless points are stated.
constexpr double axisTip = 3.2; ///< positive ends, beyond the figure radius
constexpr double axisTail = 1.4;
constexpr double circleArrowLength = 2.1;
constexpr double circleArrowWidth = 1.3;
constexpr double dimensionArrowLength = 1.3;
constexpr double dimensionArrowWidth = 0.9;
constexpr double letterBeside = 3.2;
constexpr double centreMark = 2;
constexpr double startRadius = 1.3;
constexpr double halo = 0.35;
constexpr double contactWidth = 1.7;
constexpr double senseRadius = 14;
constexpr double leftSenseLabel = 132; ///< degrees
constexpr double senseRoom = 3;        ///< between the sense arrows and the drawing around them
constexpr int spokes = 30;             ///< degrees
constexpr double freeOfMarks = 9;      ///< degrees
constexpr double roomForLabel = 9;     ///< between the circles of a dimension
constexpr double circleLimitTick = 1;
constexpr double circleGuardWidth = 1.2; ///< mm
constexpr double scaleLeft = 2.8;        ///< from the left edge
constexpr double scaleBottom = 3.9;
constexpr double scaleTick = 1.1;
constexpr double scaleText = 1.8;
constexpr double ratioAbove = 4.6;
constexpr double circleSampleWidth = 8;
constexpr double sampleText = 10;
constexpr double secondColumn = 39;
constexpr double thirdColumn = 76;
constexpr double keyTop = 1;
constexpr double keyRow = 4.8;
constexpr double repetitionStrength = 0.45;
constexpr double textHeight = figureTextSize * 1.15; ///< points

constexpr double screenInset = 4; ///< points
constexpr double screenRow = 11;
constexpr double screenSample = 20;
constexpr double screenSampleGap = 5;

/// Number of points from which most points of a path overlap in an image.
constexpr std::size_t denseTrace = 2500;
constexpr std::size_t denseTraceInView = 300;
constexpr double densePixels = 2; ///< between points
constexpr qsizetype longChain = 4;
/// Flatness of a circle approximated by chords, points.
constexpr double flatness = 0.02;

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// Clips a segment to a rectangle; false if they do not intersect.
bool clip(QPointF &a, QPointF &b, const QRectF &rect) {
    // On a long path nearly all segments are on one side or inside; this test takes a third of the time.
    const auto [left, right] = std::minmax({a.x(), b.x()});
    const auto [top, bottom] = std::minmax({a.y(), b.y()});
    if (right < rect.left() || left > rect.right() || bottom < rect.top() || top > rect.bottom())
        return false;
    if (left >= rect.left() && right <= rect.right() && top >= rect.top() && bottom <= rect.bottom())
        return true;
    double from = 0;
    double to = 1;
    const QPointF way = b - a;
    const auto cut = [&](double along, double distance) {
        if (along == 0)
            return distance >= 0;
        const double at = distance / along;
        if (along < 0)
            from = std::max(from, at);
        else
            to = std::min(to, at);
        return from <= to;
    };
    if (!cut(-way.x(), a.x() - rect.left()) || !cut(way.x(), rect.right() - a.x()) ||
        !cut(-way.y(), a.y() - rect.top()) || !cut(way.y(), rect.bottom() - a.y()))
        return false;
    b = a + to * way;
    a = a + from * way;
    return true;
}

constexpr double drawnSmaller = 1 - 1e-6; ///< a figure below this fraction of its size counts as reduced

/// Points per mm of the figure and of its key. The key is never reduced, because its letters are not.
struct Units {
    double figure = 1;
    double key = 1;
};

Units unitsOf(const CircleFigure &figure, const QRectF &area, Medium medium) {
    const double keyHeight = medium == Medium::paper ? figure.keyHeight : 0;
    const double both =
        std::min(area.width() / figure.size.width(), area.height() / (figure.size.height() + keyHeight));
    if (medium != Medium::paper || both >= mm)
        return {both, both};
    constexpr double least = 0.1 * mm;
    const double height = area.height() - keyHeight * mm;
    return {
        std::clamp(height / figure.size.height(), least, std::max(least, area.width() / figure.size.width())),
        mm};
}

/// The figure to be drawn at a scale `less` < 1 with the same magnification on paper: the distance between
/// the nominal circle and the figure radius keeps its size, everything else shrinks.
CircleFigure withMagnificationKept(const CircleFigure &figure, double less) {
    CircleFigure result = figure;
    result.magnification = figure.magnification / less;
    result.plotRadius = figure.figureRadius - (figure.figureRadius - figure.plotRadius) / less;
    return result;
}

class CircleFigurePainter {
public:
    CircleFigurePainter(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium)
        : p(painter)
        , m_units(unitsOf(figure, area, medium))
        , m_smaller(medium == Medium::paper && m_units.figure < drawnSmaller * mm
                        ? std::optional(withMagnificationKept(figure, m_units.figure / mm))
                        : std::nullopt)
        , m_figure(m_smaller ? *m_smaller : figure)
        , m_medium(medium)
        , m_area(area)
        , m_unit(m_units.figure) {
        m_plot = medium == Medium::paper ? QRectF(area.topLeft(), figure.size * m_unit)
                                         : area; // the space around the figure belongs to the picture
        if (medium == Medium::paper)
            m_plot.moveLeft(area.left() + (area.width() - m_plot.width()) / 2);
        m_scale = m_unit * figure.view.zoom;
        m_centre = m_plot.center() +
                   QPointF(-figure.view.x - figure.home.x(), figure.view.y + figure.home.y()) * m_scale;
        if (figure.sector) {
            m_dimensionAngles = anglesIn(*figure.sector, {0.7, 0.62, 0.78, 0.55, 0.85, 0.5});
            m_limitAngles = anglesIn(*figure.sector, {0.35, 0.28, 0.42, 0.2, 0.15, 0.5});
            m_labelAngles = anglesIn(*figure.sector, {0.12, 0.16, 0.2, 0.24, 0.3, 0.45, 0.55, 0.8, 0.88});
        }
        m_guard = m_plot.adjusted(-20, -20, 20, 20);
    }

    /// Left end of the sense labels next to the circles.
    [[nodiscard]] double leftOfSenses() const {
        double left = m_plot.right();
        if (!whole() || m_figure.sector || sensesAreInside())
            return left;
        for (const SenseArrow &arrow : m_figure.arrows) {
            if (arrow.sense == Sense::clockwise)
                left = polar(leftSenseLabel, outerSenseLabel()).x() - textWidth(arrow.index) / 2 - 1;
        }
        return left;
    }

    static std::vector<double> anglesIn(const Interval &sector, std::vector<double> parts) {
        for (double &part : parts)
            part = sector.from + part * (sector.to - sector.from);
        return parts;
    }

    FigureTransform draw() {
        p.setRenderHint(QPainter::Antialiasing);
        p.setRenderHint(QPainter::TextAntialiasing);
        if (m_plot.width() <= 0 || m_plot.height() <= 0)
            return {};
        p.save();
        p.setClipRect(m_plot, Qt::IntersectClip);
        drawRings();
        drawAxes();
        if (whole())
            drawScale();
        drawCircle(0, FigureRole::nominal);
        drawLimitsOfF();
        drawEnvelope();
        for (const bool repetitions : {true, false})
            drawTraces(repetitions);
        drawSyntheticTraces();
        drawStarts();
        drawContacts();
        drawCentre();
        drawDimension();
        drawSenses();
        if (m_medium != Medium::paper && whole())
            drawCorners();
        drawRingLabels();
        drawLimitOfG();
        p.restore();
        if (!whole()) { // draw on top of the zoomed figure
            drawScale();
            if (m_medium != Medium::paper)
                drawCorners();
        }
        if (m_medium == Medium::paper)
            drawKey();
        return {m_plot, QTransform(m_scale, 0, 0, -m_scale, m_centre.x(), m_centre.y()), 0};
    }

private:
    [[nodiscard]] QPen pen(FigureRole role) const { return figurePen(role, m_medium); }
    [[nodiscard]] QColor colour(FigureRole role) const { return figureColor(role, m_medium); }
    [[nodiscard]] bool whole() const { return m_figure.view.zoom <= 1; }

    /// Point in a direction (degrees) at a distance from the centre (mm).
    [[nodiscard]] QPointF polar(double degrees, double radius) const {
        return placeOn(directionOf(degrees), radius);
    }
    [[nodiscard]] static QPointF directionOf(double degrees) {
        const double angle = radians(degrees);
        return {std::cos(angle), -std::sin(angle)};
    }
    [[nodiscard]] QPointF placeOn(QPointF ray, double radius) const {
        return m_centre + ray * (radius * m_scale);
    }
    [[nodiscard]] QPointF place(const TracePoint &point) const {
        return polar(point.angle, m_figure.radius(point.deviation));
    }
    [[nodiscard]] static FigureRole roleOf(Sense sense) {
        return sense == Sense::counterclockwise ? FigureRole::counterclockwise : FigureRole::clockwise;
    }

    // ---- Lines -------------------------------------------------------------------------------------------

    /// Draws a polyline, clipped to the surroundings of the view: the painter cannot handle far coordinates.
    void drawChain(const QPolygonF &chain) {
        QPolygonF piece;
        piece.reserve(chain.size());
        for (qsizetype i = 1; i < chain.size(); ++i) {
            QPointF a = chain[i - 1];
            QPointF b = chain[i];
            if (!clip(a, b, m_guard)) {
                flush(piece);
                continue;
            }
            if (piece.isEmpty() || piece.back() != a) {
                flush(piece);
                piece << a;
            }
            piece << b;
        }
        flush(piece);
    }
    void flush(QPolygonF &piece) {
        if (piece.size() > 1)
            stroke(piece);
        piece.clear();
    }

    [[nodiscard]] bool isPicture() const {
        return p.paintEngine() && p.paintEngine()->type() == QPaintEngine::Raster;
    }

    /// In a raster image, draws separate lines with round caps: this looks like round joins, which take many
    /// times as long where the line crosses itself.
    void stroke(const QPolygonF &chain) {
        if (!isPicture() || chain.size() < longChain || p.pen().capStyle() != Qt::RoundCap) {
            p.drawPolyline(chain);
            return;
        }
        QList<QLineF> lines;
        lines.reserve(chain.size() - 1);
        for (qsizetype i = 1; i < chain.size(); ++i)
            lines.append({chain[i - 1], chain[i]});
        p.drawLines(lines);
    }

    void drawCircle(double deviation, FigureRole role) {
        const double radius = m_figure.radius(deviation) * m_scale;
        if (radius <= 0)
            return;
        p.setPen(pen(role));
        p.setBrush(Qt::NoBrush);
        if (whole()) {
            p.drawEllipse(m_centre, radius, radius);
            return;
        }
        // Only the visible part, as chords: a circle a thousand times the view is too much for the painter.
        const double step = 2 * std::acos(std::max(0.5, 1 - flatness / radius));
        const auto [from, to] = anglesInView();
        const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
        QPolygonF chain;
        chain.reserve(parts + 1);
        for (int i = 0; i <= parts; ++i) {
            const double angle = from + (to - from) * i / parts;
            chain << m_centre + QPointF(std::cos(angle), -std::sin(angle)) * radius;
        }
        drawChain(chain);
    }

    /// Range of directions from the centre of the circles to the view, radians.
    [[nodiscard]] Interval anglesInView() const {
        if (m_guard.contains(m_centre))
            return {0, 2 * std::numbers::pi};
        const QPointF towards = m_guard.center() - m_centre;
        const double middle = std::atan2(-towards.y(), towards.x());
        Interval result{middle, middle};
        for (const QPointF corner :
             {m_guard.topLeft(), m_guard.topRight(), m_guard.bottomLeft(), m_guard.bottomRight()}) {
            const QPointF way = corner - m_centre;
            const double angle =
                middle + std::remainder(std::atan2(-way.y(), way.x()) - middle, 2 * std::numbers::pi);
            result = {std::min(result.from, angle), std::max(result.to, angle)};
        }
        return result;
    }

    void drawRings() {
        for (const DeviationCircle &ring : m_figure.rings) {
            if (ring.deviation != 0)
                drawCircle(ring.deviation, FigureRole::ring);
        }
        if (m_figure.rings.size() < 2)
            return;
        const double inner = m_figure.radius(whole() ? m_figure.rings.front().deviation
                                                     : -m_figure.plotRadius * 1000 / m_figure.magnification);
        const double outer =
            whole() ? m_figure.radius(m_figure.rings.back().deviation) : m_figure.figureRadius;
        p.setPen(pen(FigureRole::ring));
        for (int angle = 0; angle < 360; angle += spokes) {
            if (angle % 90 != 0)
                drawChain({polar(angle, inner), polar(angle, outer)});
        }
    }

    void drawArrowHead(QPointF tip, double degrees, double length, double width, const QColor &fill) {
        const double angle = radians(degrees);
        const QPointF along(std::cos(angle), -std::sin(angle));
        const QPointF across(-along.y(), along.x());
        p.setPen(Qt::NoPen);
        p.setBrush(fill);
        p.drawPolygon(QPolygonF{tip, tip - length * along + width / 2 * across,
                                tip - length * along - width / 2 * across});
    }

    void drawAxes() {
        const double tip = m_figure.figureRadius + axisTip;
        const double tail = m_figure.figureRadius + axisTail;
        QPen line = pen(FigureRole::planeAxis);
        line.setCapStyle(Qt::FlatCap);
        // In a sector the visible ends carry the letters.
        const double first = m_figure.firstAxis.startsWith(u'−') ? 180 : 0;
        const double second = m_figure.secondAxis.startsWith(u'−') ? 270 : 90;
        for (const double angle : {first, second}) {
            p.setPen(line);
            const double head = circleArrowLength / 2 / m_figure.view.zoom;
            drawChain({polar(angle + 180, tail), polar(angle, tip - head)});
            drawArrowHead(polar(angle, tip), angle, circleArrowLength * m_unit, circleArrowWidth * m_unit,
                          colour(FigureRole::planeAxis));
        }
        const double width = textWidth(m_figure.firstAxis);
        drawLetter(polar(first, tip) +
                       QPointF((first > 0 ? 1 : -1) * width / 2 - 0.2 * mm, letterBeside * mm),
                   m_figure.firstAxis);
        drawLetter(polar(second, tip) + QPointF(-1.6 * mm - textWidth(m_figure.secondAxis) / 2,
                                                (second > 90 ? -1 : 1) * textHeight / 2),
                   m_figure.secondAxis);
    }

    void drawLetter(QPointF centre, const QString &letter) {
        const double width = textWidth(letter);
        if (take(boxOf(centre, width)))
            drawText(p, centre - QPointF(width / 2, 0), letter, colour(FigureRole::text));
    }

    void drawLimitsOfF() {
        for (const DeviationCircle &limit : m_figure.limits)
            drawCircle(limit.deviation, FigureRole::limit);
    }

    void drawEnvelope() {
        if (!m_figure.envelope)
            return;
        drawCircle(m_figure.envelope->outer, FigureRole::envelope);
        drawCircle(m_figure.envelope->inner, FigureRole::envelope);
    }

    void drawTraces(bool repetitions) {
        p.setBrush(Qt::NoBrush);
        for (const CircleTrace &trace : m_figure.traces) {
            if (trace.repetition != repetitions || trace.synthetic)
                continue;
            QPen line = trace.layer ? layerPen(*trace.layer, m_medium) : pen(roleOf(trace.sense));
            if (trace.layer && trace.sense == Sense::clockwise)
                line.setWidthF(line.widthF() / 2);
            if (repetitions) {
                line.setColor(blend(line.color(), colour(FigureRole::background), repetitionStrength));
                line.setWidthF(line.widthF() / 2);
            }
            drawTrace(trace.points, line);
        }
    }

    void drawSyntheticTraces() {
        p.setBrush(Qt::NoBrush);
        for (const CircleTrace &trace : m_figure.traces) {
            if (!trace.synthetic)
                continue;
            p.setPen(pen(FigureRole::synthetic));
            QPolygonF chain;
            chain.reserve(static_cast<qsizetype>(trace.points.size()));
            for (const TracePoint &point : trace.points)
                chain << place(point);
            if (whole())
                p.drawPolyline(chain);
            else
                drawChain(chain);
        }
    }

    /// A raster painter takes a second for the joins of thousands of overlapping points: a dense path is
    /// drawn as parallel one-pixel lines, which looks the same.
    void drawTrace(const std::vector<TracePoint> &points, QPen line) {
        const double pixel = 1 / std::sqrt(std::abs(p.deviceTransform().determinant()));
        const double width = line.widthF();
        int lines = 1;
        if (isPicture() && isDense(points, pixel) && width > pixel) {
            lines = static_cast<int>(std::ceil(width / pixel));
            line.setWidthF(0.99 * pixel); // fast path of the painter
        }
        p.setPen(line);
        std::vector<QPointF> directions; // shared by all lines: the sine costs as much as everything else
        directions.reserve(points.size());
        for (const TracePoint &point : points)
            directions.push_back(directionOf(point.angle));
        for (int i = 0; i < lines; ++i) {
            const double offset =
                lines == 1 ? 0 : (width - pixel) * (static_cast<double>(i) / (lines - 1) - 0.5);
            QPolygonF chain;
            chain.reserve(static_cast<qsizetype>(points.size()));
            for (std::size_t k = 0; k < points.size(); ++k)
                chain << placeOn(directions[k], m_figure.radius(points[k].deviation) + offset / m_scale);
            if (chain.size() == 1)
                p.drawPoint(chain.front());
            else if (whole())
                stroke(chain);
            else
                drawChain(chain);
        }
    }

    /// True if points of a path overlap at this pixel size: a number that only a whole turn has, or several
    /// points per pixel in a zoomed view.
    [[nodiscard]] bool isDense(const std::vector<TracePoint> &points, double pixel) const {
        if (points.size() >= denseTrace)
            return true;
        if (whole() || points.size() < denseTraceInView)
            return false;
        const double angle = radians(std::abs(points.back().angle - points.front().angle));
        const double length = angle * m_figure.plotRadius * m_scale / pixel;
        return static_cast<double>(points.size()) * densePixels > length;
    }

    // ---- Marks -------------------------------------------------------------------------------------------

    void drawStar(QPointF at, const QColor &ink, double width, Qt::PenCapStyle cap = Qt::FlatCap) {
        QPen line(ink);
        line.setWidthF(width);
        line.setCapStyle(cap);
        p.setPen(line);
        for (const double angle : {30.0, 90.0, 150.0}) {
            const QPointF arm =
                QPointF(std::cos(radians(angle)), std::sin(radians(angle))) * (startRadius * mm);
            p.drawLine(at - arm, at + arm);
        }
    }

    /// All halos first, because starting points are often close together.
    void drawStarts() {
        for (const bool ground : {true, false}) {
            for (const TraceMark &start : m_figure.starts) {
                const QPen line = pen(roleOf(start.sense));
                const double width = std::max(0.24 * mm, 0.75 * line.widthF());
                if (ground)
                    drawStar(place(start.at), colour(FigureRole::background), width + 2 * halo * mm,
                             Qt::RoundCap);
                else
                    drawStar(place(start.at), line.color(), width);
            }
        }
    }

    /// Squares: filled on the outer circle, open on the inner one.
    void drawContact(QPointF at, bool outer) {
        const double half = contactWidth * mm / 2;
        QPen line = pen(FigureRole::nominal);
        line.setJoinStyle(Qt::MiterJoin);
        p.setPen(line);
        p.setBrush(outer ? line.color() : colour(FigureRole::background));
        p.drawRect(QRectF(at - QPointF(half, half), at + QPointF(half, half)));
    }

    void drawContacts() {
        for (const ContactMark &contact : m_figure.contacts)
            drawContact(place(contact.mark.at), contact.outer);
    }

    void drawPlus(QPointF at) {
        QPen line = pen(FigureRole::centre);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        const double arm = centreMark * mm;
        p.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
        p.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
    }

    void drawCentre() { drawPlus(m_centre); }

    // ---- Dimensions and texts ----------------------------------------------------------------------------

    [[nodiscard]] static QRectF boxOf(QPointF centre, double width) {
        return {centre.x() - width / 2 - 1, centre.y() - textHeight / 2, width + 2, textHeight};
    }

    /// Reserves the box of a text; false if it is not in view or overlaps another text.
    bool take(const QRectF &box) {
        if (!hasRoom(box))
            return false;
        m_taken.push_back(box);
        return true;
    }
    [[nodiscard]] bool hasRoom(const QRectF &box) const {
        return m_plot.contains(box) &&
               std::ranges::none_of(m_taken, [&](const QRectF &other) { return other.intersects(box); });
    }

    /// True if a path crosses the box.
    [[nodiscard]] bool isCrossed(const QRectF &box) {
        if (m_lines.empty()) {
            for (const CircleTrace &trace : m_figure.traces) {
                QPolygonF line;
                line.reserve(static_cast<qsizetype>(trace.points.size()));
                for (const TracePoint &point : trace.points)
                    line << place(point);
                m_lines.push_back(std::move(line));
            }
        }
        return std::ranges::any_of(m_lines, [&](const QPolygonF &line) {
            for (qsizetype i = 0; i < line.size(); ++i) {
                QPointF from = line[std::max<qsizetype>(i - 1, 0)];
                QPointF to = line[i];
                if (clip(from, to, box))
                    return true;
            }
            return false;
        });
    }
    /// True if the box is in view and free of texts and paths.
    [[nodiscard]] bool isFree(const QRectF &box) { return hasRoom(box) && !isCrossed(box); }

    void drawOnGround(QPointF centre, const TextLine &line, const QColor &ink, bool bold = false) {
        const double width = textWidth(line, bold);
        p.fillRect(boxOf(centre, width), colour(FigureRole::background));
        drawText(p, {centre.x() - width / 2, centre.y()}, line, ink, bold);
    }

    /// The first angle without a marked point nearby, otherwise the one farthest from them.
    [[nodiscard]] double freeAngle(const std::vector<double> &angles) const {
        double best = angles.front();
        double widest = -1;
        for (const double angle : angles) {
            double least = 180;
            for (const ContactMark &contact : m_figure.contacts)
                least = std::min(least, std::abs(std::remainder(contact.mark.at.angle - angle, 360.0)));
            if (least > freeOfMarks)
                return angle;
            if (least > widest) {
                widest = least;
                best = angle;
            }
        }
        return best;
    }

    void drawDimension() {
        if (!m_figure.envelope || !m_figure.envelope->dimension)
            return;
        const CircleEnvelope &envelope = *m_figure.envelope;
        const double best = freeAngle(m_dimensionAngles);
        const auto isFreeThere = [&](double angle) { return labelOfDimension(angle, true).has_value(); };
        const auto free = std::ranges::find_if(m_dimensionAngles, isFreeThere);
        const double degrees = isFreeThere(best) || free == m_dimensionAngles.end() ? best : *free;
        const double inner = m_figure.radius(envelope.inner);
        const double outer = m_figure.radius(envelope.outer);
        const double width = (outer - inner) * m_scale; // as drawn, points
        const bool inside = width >= 2.4 * dimensionArrowLength * mm;
        const double beyond = inside ? 0 : 2.5 * dimensionArrowLength * mm / m_scale;
        QPen line = pen(FigureRole::dimension);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        if (inside) {
            drawChain({polar(degrees, inner), polar(degrees, outer)});
        } else {
            drawChain({polar(degrees, inner - beyond), polar(degrees, inner)});
            drawChain({polar(degrees, outer), polar(degrees, outer + beyond)});
        }
        const double away = degrees + 180;
        drawArrowHead(polar(degrees, outer), inside ? degrees : away, dimensionArrowLength * mm,
                      dimensionArrowWidth * mm, colour(FigureRole::dimension));
        drawArrowHead(polar(degrees, inner), inside ? away : degrees, dimensionArrowLength * mm,
                      dimensionArrowWidth * mm, colour(FigureRole::dimension));
        auto at = labelOfDimension(degrees, true);
        if (!at)
            at = labelOfDimension(degrees, false);
        const TextLine label = dimensionLabel();
        if (at && take(boxOf(*at, textWidth(label, true))))
            drawOnGround(*at, label, colour(FigureRole::text), true);
    }

    [[nodiscard]] TextLine dimensionLabel() const {
        TextLine label{{m_figure.envelope->label}};
        if (!m_figure.envelope->subscript.isEmpty())
            label.push_back({m_figure.envelope->subscript, true});
        return label;
    }

    /// Position for the label of a dimension in this direction: on its line, otherwise outside the outer
    /// circle, otherwise inside the inner one; `free`: only where no path runs. Null if there is no room.
    [[nodiscard]] std::optional<QPointF> labelOfDimension(double degrees, bool free) {
        const double inner = m_figure.radius(m_figure.envelope->inner);
        const double outer = m_figure.radius(m_figure.envelope->outer);
        const double width = (outer - inner) * m_scale; // as drawn, points
        const bool inside = width >= 2.4 * dimensionArrowLength * mm;
        const double beyond = inside ? 0 : 2.5 * dimensionArrowLength * mm / m_scale;
        const double across = textWidth(dimensionLabel(), true);
        const double clear =
            (0.5 * across * std::abs(std::cos(radians(degrees))) + 0.75 * textHeight) / m_scale;
        std::vector<double> radii{outer + beyond + clear, inner - beyond - clear};
        if (width >= roomForLabel * mm) {
            for (const double part : {0.75, 0.5, 0.25, 0.4, 0.6})
                radii.insert(radii.end() - 2, inner + part * (outer - inner));
        }
        for (const double radius : radii) {
            const QPointF at = polar(degrees, radius);
            const QRectF box = boxOf(at, across);
            if (radius > 0 && hasRoom(box) && !(free && isCrossed(box)))
                return at;
        }
        return std::nullopt;
    }

    /// Draws the guard band about a limit: both ends may be as much farther in or out, all in mm.
    void drawGuard(double degrees, double middle, double half, double guard) {
        const double angle = radians(degrees);
        const QPointF across = QPointF(std::sin(angle), std::cos(angle)) * (circleGuardWidth / 2 * mm);
        p.setPen(pen(FigureRole::guardBand));
        p.setBrush(colour(FigureRole::guardFill));
        for (const double side : {-1.0, 1.0}) {
            const QPointF inner = polar(degrees, middle + side * std::max(half - guard, 0.0));
            const QPointF outer = polar(degrees, middle + side * (half + guard));
            p.drawPolygon(QPolygonF{inner - across, outer - across, outer + across, inner + across});
        }
        p.setBrush(Qt::NoBrush);
    }

    /// Draws the limit of a width to scale, centred between the circles it limits.
    void drawLimitOfG() {
        if (!m_figure.envelope || !m_figure.envelope->limit)
            return;
        const CircleEnvelope &envelope = *m_figure.envelope;
        const double best = freeAngle(m_limitAngles);
        const auto isFreeThere = [&](double angle) { return limitLabelIsFree(angle); };
        const auto free = std::ranges::find_if(m_limitAngles, isFreeThere);
        const double limitAngle = isFreeThere(best) || free == m_limitAngles.end() ? best : *free;
        const double middle = (m_figure.radius(envelope.inner) + m_figure.radius(envelope.outer)) / 2;
        const double half = *envelope.limit * m_figure.magnification / 1000 / 2;
        const QPointF from = polar(limitAngle, middle - half);
        const QPointF to = polar(limitAngle, middle + half);
        if (envelope.guard)
            drawGuard(limitAngle, middle, half, *envelope.guard * m_figure.magnification / 1000 / 2);
        QPen line = pen(FigureRole::limit);
        line.setStyle(Qt::SolidLine);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        drawChain({from, to});
        const double angle = radians(limitAngle);
        const QPointF tick = QPointF(std::sin(angle), std::cos(angle)) * (circleLimitTick * mm);
        p.drawLine(from - tick, from + tick);
        p.drawLine(to - tick, to + tick);
        if (!isFreeThere(limitAngle)) {
            if (const auto beside = limitLabelBeside(limitAngle, middle + half)) {
                take(boxOf(*beside, textWidth(envelope.limitLabel)));
                return drawOnGround(*beside, {{envelope.limitLabel}}, colour(FigureRole::text));
            }
        }
        // Above the line, along it.
        const QTransform along = alongLimit(limitAngle);
        const QPointF above(0, -0.8 * textHeight);
        if (!take(along.mapRect(boxOf(above, textWidth(envelope.limitLabel)))))
            return;
        p.save();
        p.setTransform(along, true);
        drawOnGround(above, {{envelope.limitLabel}}, colour(FigureRole::text));
        p.restore();
    }

    /// Transform to the middle of the limit in this direction, along its line.
    [[nodiscard]] QTransform alongLimit(double degrees) const {
        const double middle =
            (m_figure.radius(m_figure.envelope->inner) + m_figure.radius(m_figure.envelope->outer)) / 2;
        const QPointF at = polar(degrees, middle);
        QTransform along = QTransform::fromTranslate(at.x(), at.y());
        double turn = std::remainder(180 - degrees, 360);
        if (std::abs(turn) > 90) // keep the text upright
            turn = std::remainder(turn + 180, 360);
        along.rotate(turn);
        return along;
    }

    /// Position if paths cross the limit in every direction: beyond its outer end, otherwise in a corner,
    /// since the text names what it limits. Null if there is no room.
    [[nodiscard]] std::optional<QPointF> limitLabelBeside(double degrees, double end) {
        const double width = textWidth(m_figure.envelope->limitLabel);
        const double clear = (0.5 * width * std::abs(std::cos(radians(degrees))) + textHeight) / m_scale;
        const double x = width / 2 + textHeight;
        const double y = 0.75 * textHeight;
        const std::array places{polar(degrees, end + clear), m_plot.bottomRight() - QPointF(x, y),
                                m_plot.topRight() + QPointF(-x, y), m_plot.topLeft() + QPointF(x, y),
                                m_plot.bottomLeft() + QPointF(x, -y)};
        const auto free = std::ranges::find_if(places, [&](QPointF at) { return isFree(boxOf(at, width)); });
        return free == places.end() ? std::nullopt : std::optional(*free);
    }

    [[nodiscard]] bool limitLabelIsFree(double degrees) {
        const QPointF above(0, -0.8 * textHeight);
        const double width = textWidth(m_figure.envelope->limitLabel);
        // In pieces, because the bounding box of a sloping text is mostly empty.
        const QTransform along = alongLimit(degrees);
        if (!hasRoom(along.mapRect(boxOf(above, width))))
            return false;
        const double step = textHeight;
        double x = -width / 2;
        while (x <= width / 2) {
            if (isCrossed(boxOf(along.map(above + QPointF(x, 0)), step / 2)))
                return false;
            x += step;
        }
        return true;
    }

    /// Radius of the largest empty circle about the centre, mm.
    [[nodiscard]] double hole() const {
        double least = m_figure.plotRadius;
        for (const CircleTrace &trace : m_figure.traces) {
            for (const TracePoint &point : trace.points)
                least = std::min(least, m_figure.radius(point.deviation));
        }
        if (m_figure.envelope)
            least = std::min(least, m_figure.radius(m_figure.envelope->inner));
        for (const DeviationCircle &limit : m_figure.limits)
            least = std::min(least, m_figure.radius(limit.deviation));
        return least;
    }

    void drawSense(const SenseArrow &arrow, double radius, double from, double to, double labelRadius) {
        const bool forwards = arrow.sense == Sense::counterclockwise;
        const bool mirrored = !forwards && !m_figure.sector;
        const double start = mirrored ? 180 - from : from;
        const double end = mirrored ? 180 - to : to;
        const QPen trace = pen(roleOf(arrow.sense));
        QPen line = trace;
        line.setWidthF(std::max(0.34 * mm, trace.widthF()));
        line.setCapStyle(Qt::FlatCap);
        // The line ends inside the arrow head.
        const double headAngle = circleArrowLength / radius * 180 / std::numbers::pi;
        const double lineEnd = forwards ? end - headAngle * 0.7 : end + headAngle * 0.7;
        QPolygonF chain;
        for (int i = 0; i <= 16; ++i)
            chain << polar(start + (lineEnd - start) * i / 16, radius);
        p.setPen(line);
        p.setBrush(Qt::NoBrush);
        p.drawPolyline(chain);
        const double heading = end + (forwards ? 90 : -90) + (forwards ? -0.5 : 0.5) * headAngle;
        drawArrowHead(polar(end, radius), heading, circleArrowLength * m_unit,
                      circleArrowWidth * 1.15 * m_unit, trace.color());
        const double middle = m_figure.sector ? (from + to) / 2 : forwards ? 48 : leftSenseLabel;
        drawLetter(polar(middle, labelRadius), arrow.index);
    }

    /// Draws the sense arrows side by side about the middle of the sector.
    void drawSensesOfSector() {
        constexpr double largest = 34;
        constexpr double between = 4; // degrees from the middle
        constexpr double most = 36;
        const double middle = (m_figure.sector->from + m_figure.sector->to) / 2;
        const double half = (m_figure.sector->to - m_figure.sector->from) / 2;
        const double end = std::min(most, 0.85 * half);
        const double labelWidth = 3.4 * mm / m_unit;
        const double radius = std::min(largest, hole() - senseRoom);
        for (const SenseArrow &arrow : m_figure.arrows) {
            const double side = arrow.sense == Sense::counterclockwise ? 1 : -1;
            drawSense(arrow, radius, middle + side * between, middle + side * end, radius - labelWidth - 0.3);
        }
    }

    /// Radius of the sense arrows inside the drawing; if it is too small, they are drawn outside.
    [[nodiscard]] double innerSenseRadius() const { return std::min(senseRadius, hole() - senseRoom); }
    [[nodiscard]] bool sensesAreInside() const { return innerSenseRadius() >= 8 * mm / m_unit; }
    [[nodiscard]] double halfOfSenseLabel() const { return 3.4 * mm / m_unit; }
    [[nodiscard]] double outerSenseLabel() const {
        return m_figure.figureRadius + 3.5 + 1.4 * halfOfSenseLabel();
    }

    void drawSenses() {
        if (!whole())
            return; // meaningless for a part
        if (m_figure.sector)
            return drawSensesOfSector();
        const double radius = innerSenseRadius();
        for (const SenseArrow &arrow : m_figure.arrows) {
            if (sensesAreInside())
                drawSense(arrow, radius, 28, 75, radius - halfOfSenseLabel() - 0.3);
            else
                drawSense(arrow, m_figure.figureRadius + 2.5, 37, 53, outerSenseLabel());
        }
    }

    void drawRingLabels() {
        for (const DeviationCircle &ring : m_figure.rings) {
            const double width = textWidth(ring.label);
            const auto at = [&](double angle) { return polar(angle, m_figure.radius(ring.deviation)); };
            const auto angle = std::ranges::find_if(
                m_labelAngles, [&](double degrees) { return isFree(boxOf(at(degrees), width)); });
            const QPointF centre = at(angle == m_labelAngles.end() ? m_labelAngles.front() : *angle);
            if (take(boxOf(centre, width)))
                drawOnGround(centre, {{ring.label}}, colour(FigureRole::text));
        }
    }

    // ---- Scale and key -----------------------------------------------------------------------------------

    void drawScale() {
        const double length = m_figure.division * m_figure.magnification / 1000 * m_scale;
        double left =
            m_medium == Medium::paper ? m_plot.left() + scaleLeft * m_unit : m_plot.left() + screenInset;
        if (m_figure.sector && m_figure.home.x() < 0) // paths end at the lower left
            left = m_plot.right() - length - (scaleLeft * m_unit + scaleText * mm) -
                   std::max(textWidth(m_figure.divisionLabel), textWidth(m_figure.ratio) - length);
        const double y =
            m_medium == Medium::paper ? m_plot.bottom() - scaleBottom * m_unit : m_plot.bottom() - screenRow;
        const double textLeft = left + length + scaleText * mm;
        if (!whole()) {
            const double right = textLeft + textWidth(m_figure.divisionLabel) + 2;
            p.fillRect(QRectF(left - 2, y - textHeight, right - left + 4, 2 * textHeight),
                       colour(FigureRole::background));
        }
        QPen line = pen(FigureRole::nominal);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        p.drawLine(QPointF(left, y), QPointF(left + length, y));
        for (const double x : {left, left + length})
            p.drawLine(QPointF(x, y - scaleTick * mm), QPointF(x, y + scaleTick * mm));
        drawText(p, {textLeft, y}, m_figure.divisionLabel, colour(FigureRole::text));
        const double width = textWidth(m_figure.divisionLabel);
        m_taken.push_back(boxOf({textLeft + width / 2, y}, width));
        if (m_medium == Medium::paper && whole()) {
            const QPointF above(left, y - ratioAbove * mm);
            drawText(p, above, m_figure.ratio, colour(FigureRole::text));
            const double across = textWidth(m_figure.ratio);
            m_taken.push_back(boxOf(above + QPointF(across / 2, 0), across));
        }
    }

    void drawSample(const QRectF &box, const CircleLegendEntry &entry) {
        const QPointF middle = box.center();
        const auto line = [&](FigureRole role) {
            QPen ink = pen(role);
            ink.setCapStyle(Qt::FlatCap);
            p.setPen(ink);
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
            p.setPen(layerPen(entry.layer, m_medium));
            return p.drawLine(QPointF(box.left(), middle.y()), QPointF(box.right(), middle.y()));
        case CircleLegendSample::continued:
            return;
        case CircleLegendSample::centre:
            return drawPlus(middle);
        case CircleLegendSample::start:
            return drawStar(middle, colour(FigureRole::centre), 0.32 * mm);
        case CircleLegendSample::contacts:
            drawContact(middle - QPointF(contactWidth * mm, 0), true);
            return drawContact(middle + QPointF(contactWidth * mm, 0), false);
        case CircleLegendSample::repetitions: {
            double y = middle.y() - 0.6 * mm;
            for (const FigureRole role : {FigureRole::counterclockwise, FigureRole::clockwise}) {
                QPen ink = pen(role);
                ink.setColor(blend(ink.color(), colour(FigureRole::background), repetitionStrength));
                ink.setWidthF(ink.widthF() / 2);
                p.setPen(ink);
                p.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
                y += 1.2 * mm;
            }
            return;
        }
        }
    }

    void drawKey() {
        const double half = m_figure.size.width() / 2;
        const double unit = m_units.key;
        const double keyLeft = m_area.left() + (m_area.width() - m_figure.size.width() * unit) / 2;
        for (std::size_t i = 0; i < m_figure.legend.size(); ++i) {
            const auto columns = static_cast<std::size_t>(m_figure.keyColumns);
            const std::size_t column = i % columns;
            const double left = column == 0                ? 0
                                : m_figure.keyColumns == 2 ? half
                                : column == 1              ? secondColumn
                                                           : thirdColumn;
            const std::size_t line = i / columns;
            const double row = keyTop + (static_cast<double>(line) + 0.5) * keyRow;
            const QPointF at(keyLeft + left * unit, m_plot.bottom() + row * unit);
            drawSample(QRectF(at.x(), at.y() - mm, circleSampleWidth * mm, 2 * mm), m_figure.legend[i]);
            drawText(p, at + QPointF(sampleText * mm, 0), m_figure.legend[i].text, colour(FigureRole::text));
        }
    }

    /// Legend: paths at the upper right, the rest at the lower right; the centre is named at the upper left.
    void drawCorners() {
        std::vector<const CircleLegendEntry *> paths;
        std::vector<const CircleLegendEntry *> others;
        for (const CircleLegendEntry &entry : m_figure.legend) {
            const bool path = entry.sample == CircleLegendSample::counterclockwise ||
                              entry.sample == CircleLegendSample::clockwise ||
                              entry.sample == CircleLegendSample::repetitions ||
                              entry.sample == CircleLegendSample::synthetic ||
                              entry.sample == CircleLegendSample::layer;
            (path ? paths : others).push_back(&entry);
        }
        const auto leftOf = [&](const std::vector<const CircleLegendEntry *> &entries) {
            double widest = 0;
            for (const CircleLegendEntry *entry : entries)
                widest = std::max(widest, textWidth(entry->text));
            return m_plot.right() - screenInset - widest - screenSample - screenSampleGap;
        };
        double y = m_plot.top() + screenRow;
        for (const CircleLegendEntry *entry : paths) {
            drawCornerEntry(*entry, leftOf(paths), y);
            y += screenRow;
        }
        y = m_plot.bottom() - screenRow;
        for (auto entry = others.rbegin(); entry != others.rend(); ++entry) {
            drawCornerEntry(**entry, leftOf(others), y);
            y -= screenRow;
        }
    }

    void drawCornerEntry(const CircleLegendEntry &entry, double left, double y) {
        const double width = screenSample + screenSampleGap + textWidth(entry.text);
        const QRectF box(left - 2, y - screenRow / 2, width + 4, screenRow);
        if (whole()) {
            const double dx = std::max({box.left() - m_centre.x(), m_centre.x() - box.right(), 0.0});
            const double dy = std::max({box.top() - m_centre.y(), m_centre.y() - box.bottom(), 0.0});
            if (std::hypot(dx, dy) < m_figure.figureRadius * m_scale || !take(box))
                return; // no room next to the circles
        } else {
            p.fillRect(box, colour(FigureRole::background));
        }
        drawSample(QRectF(left, y - mm, screenSample, 2 * mm), entry);
        drawText(p, {left + screenSample + screenSampleGap, y}, entry.text, colour(FigureRole::text));
    }

    QPainter &p;
    Units m_units;
    std::optional<CircleFigure> m_smaller; ///< drawn instead of the figure, if reduced
    const CircleFigure &m_figure;
    Medium m_medium;
    QRectF m_area;
    double m_unit; ///< points per mm of the whole figure
    QRectF m_plot;
    QRectF m_guard; ///< long lines are clipped to this
    QPointF m_centre;
    // Directions in degrees, in order of preference.
    std::vector<double> m_dimensionAngles{135, 123, 147, 111, 159};
    std::vector<double> m_limitAngles{225, 213, 237, 201, 249, 315, 303, 327,
                                      45,  57,  33,  262, 278, 190, 350, 10};
    std::vector<double> m_labelAngles{-60, -54, -66, -48, -72, -40, -80, -30, -20, -120, -130, -110};
    std::vector<QRectF> m_taken;    ///< boxes of texts
    std::vector<QPolygonF> m_lines; ///< paths, filled on first use
    double m_scale = 1;             ///< points per mm of the figure in view
};

} // namespace

double leastHeight(const CircleFigure &figure) {
    constexpr double innermost = 0.06; // fraction of the figure radius; leaves room for the centre mark
    double lowest = figure.rings.empty() ? 0 : figure.rings.front().deviation;
    for (const CircleTrace &trace : figure.traces) {
        for (const TracePoint &point : trace.points)
            lowest = std::min(lowest, point.deviation);
    }
    const double span = figure.figureRadius - figure.radius(lowest);
    double less = span / ((1 - innermost) * figure.figureRadius);
    if (figure.envelope && figure.envelope->limit) // the limit must stay within the figure
        less = std::max(less, *figure.envelope->limit * figure.magnification / 1000 / figure.figureRadius);
    return std::min(less, 1.0) * figure.size.height() + figure.keyHeight;
}

double leftOfSenses(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium) {
    return CircleFigurePainter(painter, area, figure, medium).leftOfSenses();
}

FigureTransform drawCircleFigure(QPainter &painter, const QRectF &area, const CircleFigure &figure,
                                 Medium medium) {
    return CircleFigurePainter(painter, area, figure, medium).draw();
}

} // namespace palmer
