// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "print/figures/circlelabels.h"
#include "print/figures/circletraces.h"

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
constexpr double letterBeside = 3.2;
constexpr double senseRadius = 14;
constexpr double leftSenseLabel = 132; ///< degrees
constexpr double senseRoom = 3;        ///< between the sense arrows and the drawing around them
constexpr int spokes = 30;             ///< degrees
constexpr double scaleLeft = 2.8;      ///< from the left edge
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

constexpr double screenInset = 4; ///< points
constexpr double screenRow = 11;
constexpr double screenSample = 20;
constexpr double screenSampleGap = 5;

class CircleFigurePainter {
public:
    CircleFigurePainter(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium)
        : p(painter)
        , m_area(area)
        , m_frame(painter, area, figure, medium)
        , m_labels(m_frame)
        , m_figure(m_frame.figure())
        , m_plot(m_frame.plot())
        , m_unit(m_frame.units().figure) {}

    /// Left end of the sense labels next to the circles.
    [[nodiscard]] double leftOfSenses() const {
        double left = m_plot.right();
        if (!m_frame.whole() || m_figure.sector || sensesAreInside())
            return left;
        for (const SenseArrow &arrow : m_figure.arrows) {
            if (arrow.sense == Sense::clockwise)
                left = m_frame.polar(leftSenseLabel, outerSenseLabel()).x() - textWidth(arrow.index) / 2 - 1;
        }
        return left;
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
        if (m_frame.whole())
            drawScale();
        m_frame.drawCircle(0, FigureRole::nominal);
        for (const DeviationCircle &limit : m_figure.limits)
            m_frame.drawCircle(limit.deviation, FigureRole::limit);
        if (m_figure.envelope) {
            m_frame.drawCircle(m_figure.envelope->outer, FigureRole::envelope);
            m_frame.drawCircle(m_figure.envelope->inner, FigureRole::envelope);
        }
        drawTraces(m_frame);
        drawMarks(m_frame);
        drawDimension(m_frame, m_labels);
        drawSenses();
        for (const QRectF &box : m_arrows) // which the numbers of rings keep clear of
            m_labels.reserve(box);
        if (!m_frame.onPaper() && m_frame.whole())
            drawCorners();
        drawRingLabels();
        drawLimitOfG(m_frame, m_labels);
        p.restore();
        if (!m_frame.whole()) { // draw on top of the zoomed figure
            drawScale();
            if (!m_frame.onPaper())
                drawCorners();
        }
        if (m_frame.onPaper())
            drawKey();
        const double scale = m_frame.scale();
        return {m_plot, QTransform(scale, 0, 0, -scale, m_frame.centre().x(), m_frame.centre().y()), 0};
    }

private:
    void drawRings() {
        for (const DeviationCircle &ring : m_figure.rings) {
            if (ring.deviation != 0)
                m_frame.drawCircle(ring.deviation, FigureRole::ring);
        }
        if (m_figure.rings.size() < 2)
            return;
        const double inner =
            m_figure.radius(m_frame.whole() ? m_figure.rings.front().deviation
                                            : -m_figure.plotRadius * 1000 / m_figure.magnification);
        const double outer =
            m_frame.whole() ? m_figure.radius(m_figure.rings.back().deviation) : m_figure.figureRadius;
        p.setPen(m_frame.pen(FigureRole::ring));
        for (int angle = 0; angle < 360; angle += spokes) {
            if (angle % 90 != 0)
                m_frame.drawChain({m_frame.polar(angle, inner), m_frame.polar(angle, outer)});
        }
    }

    void drawAxes() {
        const double tip = m_figure.figureRadius + axisTip;
        const double tail = m_figure.figureRadius + axisTail;
        const QPen line = m_frame.pen(FigureRole::planeAxis, Qt::FlatCap);
        // In a sector the visible ends carry the letters.
        const double first = m_figure.firstAxis.startsWith(u'−') ? 180 : 0;
        const double second = m_figure.secondAxis.startsWith(u'−') ? 270 : 90;
        for (const double angle : {first, second}) {
            p.setPen(line);
            const double head = circleArrowLength / 2 / m_figure.view.zoom;
            m_frame.drawChain({m_frame.polar(angle + 180, tail), m_frame.polar(angle, tip - head)});
            m_frame.drawArrowHead(m_frame.polar(angle, tip), angle, circleArrowLength * m_unit,
                                  circleArrowWidth * m_unit, m_frame.colour(FigureRole::planeAxis));
        }
        const double width = textWidth(m_figure.firstAxis);
        m_labels.drawLetter(m_frame.polar(first, tip) +
                                QPointF((first > 0 ? 1 : -1) * width / 2 - 0.2 * mm, letterBeside * mm),
                            m_figure.firstAxis);
        m_labels.drawLetter(m_frame.polar(second, tip) +
                                QPointF(-1.6 * mm - textWidth(m_figure.secondAxis) / 2,
                                        (second > 90 ? -1 : 1) * CircleLabels::height / 2),
                            m_figure.secondAxis);
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
        const QPen trace = m_frame.pen(arrow.sense);
        QPen line = trace;
        line.setWidthF(std::max(0.34 * mm, trace.widthF()));
        line.setCapStyle(Qt::FlatCap);
        // The line ends inside the arrow head.
        const double headAngle = circleArrowLength / radius * 180 / std::numbers::pi;
        const double lineEnd = forwards ? end - headAngle * 0.7 : end + headAngle * 0.7;
        QPolygonF chain;
        for (int i = 0; i <= 16; ++i)
            chain << m_frame.polar(start + (lineEnd - start) * i / 16, radius);
        p.setPen(line);
        p.setBrush(Qt::NoBrush);
        p.drawPolyline(chain);
        for (qsizetype i = 0; i < chain.size(); i += 4)
            m_arrows.push_back(CircleLabels::boxOf(chain[i], circleArrowLength * m_unit));
        const double heading = end + (forwards ? 90 : -90) + (forwards ? -0.5 : 0.5) * headAngle;
        m_frame.drawArrowHead(m_frame.polar(end, radius), heading, circleArrowLength * m_unit,
                              circleArrowWidth * 1.15 * m_unit, trace.color());
        const double middle = m_figure.sector ? (from + to) / 2 : forwards ? 48 : leftSenseLabel;
        m_labels.drawLetter(m_frame.polar(middle, labelRadius), arrow.index);
    }

    /// Draws the sense arrows side by side about the middle of the sector.
    void drawSensesOfSector() {
        constexpr double largest = 34;
        constexpr double between = 4; // degrees from the middle
        constexpr double most = 36;
        const double middle = (m_figure.sector->from + m_figure.sector->to) / 2;
        const double half = (m_figure.sector->to - m_figure.sector->from) / 2;
        const double end = std::min(most, 0.85 * half);
        const double radius = std::min(largest, hole() - senseRoom);
        for (const SenseArrow &arrow : m_figure.arrows) {
            const double side = arrow.sense == Sense::counterclockwise ? 1 : -1;
            drawSense(arrow, radius, middle + side * between, middle + side * end,
                      radius - halfOfSenseLabel() - 0.3);
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
        if (!m_frame.whole())
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
        const std::vector<double> angles =
            m_frame.angles({0.12, 0.16, 0.2, 0.24, 0.3, 0.45, 0.55, 0.8, 0.88},
                           {-60, -54, -66, -48, -72, -40, -80, -30, -20, -120, -130, -110});
        for (const DeviationCircle &ring : m_figure.rings) {
            const double width = textWidth(ring.label);
            const auto at = [&](double angle) {
                return m_frame.polar(angle, m_figure.radius(ring.deviation));
            };
            const auto angle = std::ranges::find_if(angles, [&](double degrees) {
                return m_labels.isFree(CircleLabels::boxOf(at(degrees), width));
            });
            const QPointF centre = at(angle == angles.end() ? angles.front() : *angle);
            if (m_labels.claim(CircleLabels::boxOf(centre, width)))
                m_labels.drawOnGround(centre, {{ring.label}});
        }
    }

    // ---- Scale and key -----------------------------------------------------------------------------------

    /// True if the nominal circle or the envelope crosses the box.
    [[nodiscard]] bool meetsCircle(const QRectF &box) const {
        const QPointF centre = m_frame.centre();
        const double dx = std::max({box.left() - centre.x(), centre.x() - box.right(), 0.0});
        const double dy = std::max({box.top() - centre.y(), centre.y() - box.bottom(), 0.0});
        const double near = std::hypot(dx, dy);
        const double far = std::hypot(std::max(box.right() - centre.x(), centre.x() - box.left()),
                                      std::max(box.bottom() - centre.y(), centre.y() - box.top()));
        std::vector<double> deviations{0};
        if (m_figure.envelope)
            deviations.insert(deviations.end(), {m_figure.envelope->inner, m_figure.envelope->outer});
        return std::ranges::any_of(deviations, [&](double deviation) {
            const double radius = m_figure.radius(deviation) * m_frame.scale();
            return radius > near && radius < far;
        });
    }

    /// Where the scale bar begins on paper: in the first corner where its texts meet neither axis nor line.
    [[nodiscard]] QPointF placeOfScale(double length) {
        const double across =
            std::max(length + scaleText * mm + textWidth(m_figure.divisionLabel), textWidth(m_figure.ratio));
        const double left = m_plot.left() + scaleLeft * m_unit;
        const double right = m_plot.right() - scaleLeft * m_unit - across;
        const double bottom = m_plot.bottom() - scaleBottom * m_unit;
        const double top = m_plot.top() + (scaleBottom + ratioAbove) * mm;
        const std::array corners{QPointF(left, bottom), QPointF(right, bottom), QPointF(left, top),
                                 QPointF(right, top)};
        const auto isFree = [&](QPointF corner) {
            const QRectF box(corner.x() - mm, corner.y() - ratioAbove * mm - CircleLabels::height / 2,
                             across + 2 * mm, ratioAbove * mm + CircleLabels::height);
            const QPointF centre = m_frame.centre();
            const bool onAxis = (centre.x() > box.left() && centre.x() < box.right()) ||
                                (centre.y() > box.top() && centre.y() < box.bottom());
            return !onAxis && !meetsCircle(box) && m_labels.hasRoom(box) && !m_labels.isCrossed(box);
        };
        const auto free = std::ranges::find_if(corners, isFree);
        return free == corners.end() ? corners.front() : *free;
    }

    void drawScale() {
        const double length = m_figure.division * m_figure.magnification / 1000 * m_frame.scale();
        const QPointF place = m_frame.onPaper()
                                  ? placeOfScale(length)
                                  : QPointF(m_plot.left() + screenInset, m_plot.bottom() - screenRow);
        const double left = place.x();
        const double y = place.y();
        const double textLeft = left + length + scaleText * mm;
        if (!m_frame.whole()) {
            const double right = textLeft + textWidth(m_figure.divisionLabel) + 2;
            p.fillRect(QRectF(left - 2, y - CircleLabels::height, right - left + 4, 2 * CircleLabels::height),
                       m_frame.colour(FigureRole::background));
        }
        p.setPen(m_frame.pen(FigureRole::nominal, Qt::FlatCap));
        p.drawLine(QPointF(left, y), QPointF(left + length, y));
        for (const double x : {left, left + length})
            p.drawLine(QPointF(x, y - scaleTick * mm), QPointF(x, y + scaleTick * mm));
        drawText(p, {textLeft, y}, m_figure.divisionLabel, m_frame.colour(FigureRole::text));
        const double width = textWidth(m_figure.divisionLabel);
        m_labels.reserve(CircleLabels::boxOf({textLeft + width / 2, y}, width));
        if (m_frame.onPaper() && m_frame.whole()) {
            const QPointF above(left, y - ratioAbove * mm);
            drawText(p, above, m_figure.ratio, m_frame.colour(FigureRole::text));
            const double across = textWidth(m_figure.ratio);
            m_labels.reserve(CircleLabels::boxOf(above + QPointF(across / 2, 0), across));
        }
    }

    void drawKey() {
        const double half = m_figure.size.width() / 2;
        const double unit = m_frame.units().key;
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
            drawSample(m_frame, QRectF(at.x(), at.y() - mm, circleSampleWidth * mm, 2 * mm),
                       m_figure.legend[i]);
            drawText(p, at + QPointF(sampleText * mm, 0), m_figure.legend[i].text,
                     m_frame.colour(FigureRole::text));
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
        if (m_frame.whole()) {
            const double dx =
                std::max({box.left() - m_frame.centre().x(), m_frame.centre().x() - box.right(), 0.0});
            const double dy =
                std::max({box.top() - m_frame.centre().y(), m_frame.centre().y() - box.bottom(), 0.0});
            if (std::hypot(dx, dy) < m_figure.figureRadius * m_frame.scale() || !m_labels.claim(box))
                return; // no room next to the circles
        } else {
            p.fillRect(box, m_frame.colour(FigureRole::background));
        }
        drawSample(m_frame, QRectF(left, y - mm, screenSample, 2 * mm), entry);
        drawText(p, {left + screenSample + screenSampleGap, y}, entry.text, m_frame.colour(FigureRole::text));
    }

    QPainter &p;
    QRectF m_area;
    CircleFrame m_frame;
    CircleLabels m_labels;
    const CircleFigure &m_figure;
    const QRectF &m_plot;
    double m_unit;                ///< points per mm of the whole figure
    std::vector<QRectF> m_arrows; ///< of the senses
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

FigureTransform drawKind(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium) {
    return CircleFigurePainter(painter, area, figure, medium).draw();
}

} // namespace palmer
