// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/circlelabels.h"

#include "print/figures/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace palmer {

namespace {

// On the printed page, mm unless stated.
constexpr double dimensionArrowLength = 1.3;
constexpr double dimensionArrowWidth = 0.9;
constexpr double freeOfMarks = 9;  ///< degrees
constexpr double roomForLabel = 9; ///< between the circles of a dimension
constexpr double circleLimitTick = 1;
constexpr double circleGuardWidth = 1.2;

/// Dimension and limit of the width of an envelope.
class EnvelopePainter {
public:
    /// Precondition: the figure has an envelope.
    EnvelopePainter(CircleFrame &frame, CircleLabels &labels)
        : p(frame.painter())
        , m_frame(frame)
        , m_labels(labels)
        , m_envelope(*frame.figure().envelope)
        , m_inner(frame.figure().radius(m_envelope.inner))
        , m_outer(frame.figure().radius(m_envelope.outer)) {}

    void drawDimension() {
        const std::vector<double> angles =
            m_frame.angles({0.7, 0.62, 0.78, 0.55, 0.85, 0.5}, {135, 123, 147, 111, 159});
        const double degrees =
            bestAngle(angles, [&](double angle) { return placeOfLabel(angle, true).has_value(); });
        p.setPen(m_frame.pen(FigureRole::dimension, Qt::FlatCap));
        if (arrowsInside()) {
            m_frame.drawChain({m_frame.polar(degrees, m_inner), m_frame.polar(degrees, m_outer)});
        } else {
            m_frame.drawChain({m_frame.polar(degrees, m_inner - beyond()), m_frame.polar(degrees, m_inner)});
            m_frame.drawChain({m_frame.polar(degrees, m_outer), m_frame.polar(degrees, m_outer + beyond())});
        }
        const double away = degrees + 180;
        drawArrow(m_frame.polar(degrees, m_outer), arrowsInside() ? degrees : away);
        drawArrow(m_frame.polar(degrees, m_inner), arrowsInside() ? away : degrees);
        auto at = placeOfLabel(degrees, true);
        if (!at)
            at = placeOfLabel(degrees, false);
        if (at && m_labels.claim(CircleLabels::boxOf(*at, textWidth(label(), true))))
            m_labels.drawOnGround(*at, label(), true);
    }

    void drawLimit() {
        const std::vector<double> angles =
            m_frame.angles({0.35, 0.28, 0.42, 0.2, 0.15, 0.5},
                           {225, 213, 237, 201, 249, 315, 303, 327, 45, 57, 33, 262, 278, 190, 350, 10});
        const double degrees = bestAngle(angles, [&](double angle) { return isLimitFree(angle); });
        const double magnification = m_frame.figure().magnification;
        const double half = *m_envelope.limit * magnification / 1000 / 2;
        const QPointF from = m_frame.polar(degrees, middle() - half);
        const QPointF to = m_frame.polar(degrees, middle() + half);
        if (m_envelope.guard)
            drawGuard(degrees, half, *m_envelope.guard * magnification / 1000 / 2);
        QPen line = m_frame.pen(FigureRole::limit, Qt::FlatCap);
        line.setStyle(Qt::SolidLine);
        p.setPen(line);
        m_frame.drawChain({from, to});
        const QPointF tick = acrossLimit(degrees) * (circleLimitTick * mm);
        p.drawLine(from - tick, from + tick);
        p.drawLine(to - tick, to + tick);
        const TextLine text{{m_envelope.limitLabel}};
        if (!isLimitFree(degrees)) {
            if (const auto beside = placeBesideLimit(degrees, middle() + half)) {
                m_labels.claim(CircleLabels::boxOf(*beside, textWidth(text)));
                return m_labels.drawOnGround(*beside, text);
            }
        }
        const QTransform along = alongLimit(degrees);
        if (!m_labels.claim(along.mapRect(CircleLabels::boxOf(aboveLimit, textWidth(text)))))
            return;
        p.save();
        p.setTransform(along, true);
        m_labels.drawOnGround(aboveLimit, text);
        p.restore();
    }

private:
    /// Place of the label of a limit, along its line.
    static constexpr QPointF aboveLimit{0, -0.8 * CircleLabels::height};

    [[nodiscard]] double width() const { return (m_outer - m_inner) * m_frame.scale(); } ///< as drawn, points
    [[nodiscard]] double middle() const { return (m_inner + m_outer) / 2; }
    [[nodiscard]] bool arrowsInside() const { return width() >= 2.4 * dimensionArrowLength * mm; }
    /// Length of a dimension beyond its circles, mm of the figure.
    [[nodiscard]] double beyond() const {
        return arrowsInside() ? 0 : 2.5 * dimensionArrowLength * mm / m_frame.scale();
    }
    [[nodiscard]] static QPointF acrossLimit(double degrees) {
        return {std::sin(radians(degrees)), std::cos(radians(degrees))};
    }
    [[nodiscard]] TextLine label() const {
        TextLine line{{m_envelope.label}};
        if (!m_envelope.subscript.isEmpty())
            line.push_back({m_envelope.subscript, true});
        return line;
    }

    void drawArrow(QPointF tip, double degrees) {
        m_frame.drawArrowHead(tip, degrees, dimensionArrowLength * mm, dimensionArrowWidth * mm,
                              m_frame.colour(FigureRole::dimension));
    }

    /// The first angle without a marked point nearby, otherwise the one farthest from them; if it is not
    /// free, the first free one.
    [[nodiscard]] double bestAngle(const std::vector<double> &angles,
                                   const std::function<bool(double)> &isFree) const {
        const auto distance = [&](double angle) {
            double least = 180;
            for (const ContactMark &contact : m_frame.figure().contacts)
                least = std::min(least, std::abs(std::remainder(contact.mark.at.angle - angle, 360.0)));
            return least;
        };
        auto best = std::ranges::find_if(angles, [&](double angle) { return distance(angle) > freeOfMarks; });
        if (best == angles.end())
            best = std::ranges::max_element(angles, {}, distance);
        const auto free = std::ranges::find_if(angles, isFree);
        return isFree(*best) || free == angles.end() ? *best : *free;
    }

    /// Position for the label of a dimension in this direction: on its line, otherwise outside the outer
    /// circle, otherwise inside the inner one; `free`: only where no path runs. Null if there is no room.
    [[nodiscard]] std::optional<QPointF> placeOfLabel(double degrees, bool free) {
        const double across = textWidth(label(), true);
        const double clear =
            (0.5 * across * std::abs(std::cos(radians(degrees))) + 0.75 * CircleLabels::height) /
            m_frame.scale();
        std::vector<double> radii;
        if (width() >= roomForLabel * mm) {
            for (const double part : {0.75, 0.5, 0.25, 0.4, 0.6})
                radii.push_back(m_inner + part * (m_outer - m_inner));
        }
        radii.insert(radii.end(), {m_outer + beyond() + clear, m_inner - beyond() - clear});
        for (const double radius : radii) {
            const QPointF at = m_frame.polar(degrees, radius);
            const QRectF box = CircleLabels::boxOf(at, across);
            if (radius > 0 && m_labels.hasRoom(box) && !(free && m_labels.isCrossed(box)))
                return at;
        }
        return std::nullopt;
    }

    /// Draws the guard band about a limit: both ends may be as much farther in or out, all in mm.
    void drawGuard(double degrees, double half, double guard) {
        const QPointF across = acrossLimit(degrees) * (circleGuardWidth / 2 * mm);
        p.setPen(m_frame.pen(FigureRole::guardBand));
        p.setBrush(m_frame.colour(FigureRole::guardFill));
        for (const double side : {-1.0, 1.0}) {
            const QPointF inner = m_frame.polar(degrees, middle() + side * std::max(half - guard, 0.0));
            const QPointF outer = m_frame.polar(degrees, middle() + side * (half + guard));
            p.drawPolygon(QPolygonF{inner - across, outer - across, outer + across, inner + across});
        }
        p.setBrush(Qt::NoBrush);
    }

    /// Transform to the middle of the limit in this direction, along its line.
    [[nodiscard]] QTransform alongLimit(double degrees) const {
        const QPointF at = m_frame.polar(degrees, middle());
        QTransform along = QTransform::fromTranslate(at.x(), at.y());
        double turn = std::remainder(180 - degrees, 360);
        if (std::abs(turn) > 90) // keep the text upright
            turn = std::remainder(turn + 180, 360);
        along.rotate(turn);
        return along;
    }

    /// Position if paths cross the limit in every direction: beyond its outer end, otherwise in a corner,
    /// since the text names what it limits. Null if there is no room.
    [[nodiscard]] std::optional<QPointF> placeBesideLimit(double degrees, double end) {
        const QRectF &plot = m_frame.plot();
        const double across = textWidth(m_envelope.limitLabel);
        const double clear =
            (0.5 * across * std::abs(std::cos(radians(degrees))) + CircleLabels::height) / m_frame.scale();
        const double x = across / 2 + CircleLabels::height;
        const double y = 0.75 * CircleLabels::height;
        const std::array places{m_frame.polar(degrees, end + clear), plot.bottomRight() - QPointF(x, y),
                                plot.topRight() + QPointF(-x, y), plot.topLeft() + QPointF(x, y),
                                plot.bottomLeft() + QPointF(x, -y)};
        const auto free = std::ranges::find_if(
            places, [&](QPointF at) { return m_labels.isFree(CircleLabels::boxOf(at, across)); });
        return free == places.end() ? std::nullopt : std::optional(*free);
    }

    [[nodiscard]] bool isLimitFree(double degrees) {
        const double across = textWidth(m_envelope.limitLabel);
        const QTransform along = alongLimit(degrees);
        if (!m_labels.hasRoom(along.mapRect(CircleLabels::boxOf(aboveLimit, across))))
            return false;
        // In pieces, because the bounding box of a sloping text is mostly empty.
        const double step = CircleLabels::height;
        double x = -across / 2;
        while (x <= across / 2) {
            if (m_labels.isCrossed(CircleLabels::boxOf(along.map(aboveLimit + QPointF(x, 0)), step / 2)))
                return false;
            x += step;
        }
        return true;
    }

    QPainter &p;
    CircleFrame &m_frame;
    CircleLabels &m_labels;
    const CircleEnvelope &m_envelope;
    double m_inner; ///< radii of the envelope, mm
    double m_outer;
};

} // namespace

bool CircleLabels::claim(const QRectF &box) {
    if (!hasRoom(box))
        return false;
    reserve(box);
    return true;
}

bool CircleLabels::hasRoom(const QRectF &box) const {
    return m_frame.plot().contains(box) &&
           std::ranges::none_of(m_taken, [&](const QRectF &other) { return other.intersects(box); });
}

bool CircleLabels::isCrossed(const QRectF &box) {
    if (m_lines.empty()) {
        for (const CircleTrace &trace : m_frame.figure().traces)
            m_lines.push_back(m_frame.chainOf(trace.points));
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

void CircleLabels::drawLetter(QPointF centre, const QString &letter) {
    const double width = textWidth(letter);
    if (claim(boxOf(centre, width)))
        drawText(m_frame.painter(), centre - QPointF(width / 2, 0), letter, m_frame.colour(FigureRole::text));
}

void CircleLabels::drawOnGround(QPointF centre, const TextLine &line, bool bold) {
    const double width = textWidth(line, bold);
    m_frame.painter().fillRect(boxOf(centre, width), m_frame.colour(FigureRole::background));
    drawText(m_frame.painter(), {centre.x() - width / 2, centre.y()}, line, m_frame.colour(FigureRole::text),
             bold);
}

void drawDimension(CircleFrame &frame, CircleLabels &labels) {
    if (frame.figure().envelope && frame.figure().envelope->dimension)
        EnvelopePainter(frame, labels).drawDimension();
}

void drawLimitOfG(CircleFrame &frame, CircleLabels &labels) {
    if (frame.figure().envelope && frame.figure().envelope->limit)
        EnvelopePainter(frame, labels).drawLimit();
}

} // namespace palmer
