// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/arccurvesview.h"

#include "figures/circlefigure.h"
#include "figures/extremes.h"
#include "figures/ticks.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/measurement/testfacts.h"
#include "print/figures/style.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palmer::ui {

namespace {

constexpr double scaleRoom = 44;
constexpr double rightRoom = 14;
constexpr double belowTitle = 4;
constexpr double plotBottom = 22;
constexpr double pointerReach = 12; ///< around the pointer, pixels
constexpr double handleReach = 7;
constexpr double ring = 5;
constexpr double gripWidth = 7;
constexpr double gripHeight = 16;
constexpr double margin = 0.08; ///< above and below the values, as a share of their range
constexpr double mostAngleParts = 4;
constexpr double mostValueParts = 5;
constexpr double quarterTurn = 90;
constexpr double nearTurn = 0.02;            ///< share of the range
constexpr double roundTo = 0.1;              ///< rounding of a dragged handle, degrees
constexpr qsizetype pieceOfCurve = 48;       ///< lines per drawing call
constexpr double leastRange = 1;             ///< degrees
constexpr std::size_t drawnAtOnce = 200'000; ///< points; more are made in the background

} // namespace

ArcCurvesView::ArcCurvesView(Selection &selection, QWidget *parent)
    : PictureWidget(parent)
    , m_selection(selection) {
    setObjectName(QStringLiteral("arcCurves"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(&selection, &Selection::hoveredChanged, this, qOverload<>(&QWidget::update));
}

void ArcCurvesView::show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    const TestPointer shown = evaluated.document->tests[test];
    const TestEvaluationPointer evaluation = evaluated.tests[test];
    if (m_measurement && m_evaluated.document->tests[m_test]->id != shown->id)
        m_curves = {};
    m_evaluated = evaluated;
    m_test = test;
    m_measurement = measured<CircularMeasurement>(evaluated, test);
    m_language = language;
    m_dragged = Handle::none;
    m_preview.reset();
    if (std::exchange(m_curvesOf, evaluation) == evaluation) {
        fitAxes();
    } else if (m_making.cancel(); readingsOf(*shown) <= drawnAtOnce) {
        receive(curvesOf(*shown, *evaluation));
    } else {
        m_making.start([shown, evaluation](const Background::Job &) { return curvesOf(*shown, *evaluation); },
                       [this](Curves curves) { receive(std::move(curves)); });
    }
}

ArcCurvesView::Curves ArcCurvesView::curvesOf(const Test &test, const TestEvaluation &evaluation) {
    Curves curves;
    curves.angles = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    curves.deviations = curves.angles;
    const auto &measurement = std::get<CircularMeasurement>(test.measurement);
    for (std::size_t k = 0; k < measurement.arcs.size(); ++k) {
        const PathProfile &profile = curves.profiles.emplace_back(wholeArc(test, evaluation, k));
        if (profile.angles.empty())
            continue;
        const auto include = [](Interval &all, const Interval &own) {
            all = {std::min(all.from, own.from), std::max(all.to, own.to)};
        };
        include(curves.angles, extremesOf(profile.angles));
        include(curves.deviations, extremesOf(profile.deviations));
    }
    return curves;
}

void ArcCurvesView::receive(Curves curves) {
    m_curves = std::move(curves);
    fitAxes();
}

void ArcCurvesView::fitAxes() {
    Interval angles = m_curves.angles;
    Interval values = m_curves.deviations;
    if (!(angles.from < angles.to))
        angles = {0, 360};
    // A full circle of points begins and ends one step off the full turn.
    const double near = nearTurn * (angles.to - angles.from);
    if (const double quarter = std::floor(angles.from / quarterTurn) * quarterTurn;
        angles.from - quarter < near)
        angles.from = quarter;
    if (const double quarter = std::ceil(angles.to / quarterTurn) * quarterTurn; quarter - angles.to < near)
        angles.to = quarter;
    if (!(values.from < values.to))
        values = {-1, 1};
    const double space = margin * (values.to - values.from);
    setRange(m_angles, angles.from, angles.to, mostAngleParts, TickSteps::angles, m_language);
    const double scale = valueScale();
    setRange(m_deviations, (values.from - space) * scale, (values.to + space) * scale, mostValueParts,
             TickSteps::values, m_language);
    discardPicture();
}

void ArcCurvesView::clear() {
    m_making.cancel();
    m_evaluated = {};
    m_curvesOf.reset();
    m_curves = {};
    m_measurement = nullptr;
    m_preview.reset();
    discardPicture();
}

void ArcCurvesView::setCurrentArc(std::size_t arc) {
    if (m_arc != arc)
        m_preview.reset();
    m_arc = arc;
    update();
}

QRectF ArcCurvesView::plot() const {
    return QRectF(rect()).adjusted(scaleRoom, m_plotTop, -rightRoom, -plotBottom);
}

double ArcCurvesView::xOf(double angle) const {
    return plot().left() + (angle - m_angles.from) / (m_angles.to - m_angles.from) * plot().width();
}

/// Factor from µm to the displayed unit.
double ArcCurvesView::valueScale() const {
    return unitScale(Quantity::micrometres, m_language.units());
}

double ArcCurvesView::yOf(double deviation) const {
    return plot().bottom() - (deviation * valueScale() - m_deviations.from) /
                                 (m_deviations.to - m_deviations.from) * plot().height();
}

double ArcCurvesView::angleAt(double x) const {
    return m_angles.from + (x - plot().left()) / plot().width() * (m_angles.to - m_angles.from);
}

std::optional<Interval> ArcCurvesView::range() const {
    if (m_preview)
        return m_preview;
    if (!m_measurement || m_arc >= m_measurement->arcs.size())
        return std::nullopt;
    return iso230_4::evaluatedRange(m_measurement->arcs[m_arc]);
}

// ---- Painting --------------------------------------------------------------------------------------------

void ArcCurvesView::drawPicture(QPainter &painter) {
    m_plotTop = QFontMetricsF(themeFont(TextSize::tiny)).height() + belowTitle;
    drawAxes(painter);
    drawCurves(painter);
}

void ArcCurvesView::drawAxes(QPainter &painter) const {
    const Medium medium = screenMedium(palette());
    const QRectF area = plot();
    painter.setFont(themeFont(TextSize::tiny));
    const QFontMetricsF metrics(painter.font());
    const QColor secondary = token(Token::secondaryText, palette());
    for (const Tick &tick : m_deviations.ticks) {
        const double y = std::round(yOf(tick.value / valueScale())) + 0.5;
        painter.setPen(
            QPen(figureColor(tick.value == 0 ? FigureRole::zeroLine : FigureRole::grid, medium), 1));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(secondary);
        painter.drawText(QRectF(0, y - 10, scaleRoom - 6, 20), Qt::AlignRight | Qt::AlignVCenter, tick.label);
    }
    // Where the path crosses a machine axis, the axis name is shown next to the angle.
    double lastRight = -1;
    for (const Tick &tick : m_angles.ticks) {
        const double x = std::round(xOf(tick.value)) + 0.5;
        painter.setPen(QPen(figureColor(FigureRole::zeroLine, medium), 1, Qt::DashLine));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        QString text = tick.label + QStringLiteral("°");
        const double quarters = tick.value / quarterTurn;
        if (quarters == std::round(quarters) && m_measurement) {
            const int quarter = (static_cast<int>(std::fmod(quarters, 4)) + 4) % 4;
            const std::string &axis =
                quarter % 2 == 0 ? m_measurement->plane.first : m_measurement->plane.second;
            text += QStringLiteral(" (") + (quarter < 2 ? QStringLiteral("+") : QStringLiteral("−")) +
                    QString::fromStdString(axis) + u')';
        }
        const double width = metrics.horizontalAdvance(text);
        const double begin = std::clamp(x - width / 2, 2.0, std::max(2.0, this->width() - width - 2));
        if (begin < lastRight + 6)
            continue;
        lastRight = begin + width;
        painter.setPen(secondary);
        painter.drawText(QPointF(begin, area.bottom() + metrics.ascent() + 5), text);
    }
    const QString title = tr("Δr %1, least squares centre").arg(m_language.unit(Quantity::deviation));
    painter.setPen(secondary); // above the plot, whose full area curves and shading may cover
    painter.drawText(QPointF(area.left(), metrics.ascent()), title);
}

void ArcCurvesView::drawCurves(QPainter &painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(plot().adjusted(0, -2, 0, 2));
    const double step = (m_angles.to - m_angles.from) / std::max(1.0, plot().width());
    for (auto profile = m_curves.profiles.rbegin(); profile != m_curves.profiles.rend(); ++profile) {
        QPen line = figurePen(pathRole(profile->sense), screenMedium(palette()));
        line.setWidthF(profile->sense == Sense::counterclockwise ? 1.6 : 0.99);
        painter.setPen(line);
        for (const CircleTrace &trace : decimated(*profile, step)) {
            QPolygonF chain;
            chain.reserve(static_cast<qsizetype>(trace.points.size()));
            for (const TracePoint &point : trace.points)
                chain << QPointF(xOf(point.angle), yOf(point.deviation));
            // Filling one path with thousands of peaks takes three times as long as its pieces.
            for (qsizetype i = 0; i + 1 < chain.size(); i += pieceOfCurve)
                painter.drawPolyline(chain.constData() + i, static_cast<int>(std::min<qsizetype>(
                                                                pieceOfCurve + 1, chain.size() - i)));
        }
    }
}

void ArcCurvesView::paintRange(QPainter &painter) const {
    const auto shown = range();
    if (!shown)
        return;
    const QRectF area = plot();
    QColor shade = palette().color(QPalette::Base);
    shade.setAlphaF(0.65F);
    const double from = std::clamp(xOf(shown->from), area.left(), area.right());
    const double to = std::clamp(xOf(shown->to), area.left(), area.right());
    painter.fillRect(QRectF(area.topLeft(), QPointF(from, area.bottom())), shade);
    painter.fillRect(QRectF(QPointF(to, area.top()), area.bottomRight()), shade);
    const QColor accent = token(Token::accent, palette());
    for (const double x : {from, to}) {
        painter.setPen(QPen(accent, 1.5));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRoundedRect(
            QRectF(x - gripWidth / 2, area.center().y() - gripHeight / 2, gripWidth, gripHeight), 3, 3);
    }
}

void ArcCurvesView::paintHovered(QPainter &painter) const {
    const auto place = m_selection.hovered();
    if (!place || place->run >= m_curves.profiles.size() ||
        place->target >= m_curves.profiles[place->run].angles.size())
        return;
    const TracePoint at = m_curves.profiles[place->run][place->target]; // indexed within the whole arc
    painter.setPen(QPen(token(Token::accent, palette()), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(xOf(at.angle), yOf(at.deviation)), ring, ring);
}

void ArcCurvesView::paintOver(QPainter &painter) {
    paintRange(painter);
    paintHovered(painter);
}

// ---- Pointer ---------------------------------------------------------------------------------------------

ArcCurvesView::Handle ArcCurvesView::handleAt(QPointF at) const {
    const auto shown = range();
    if (!shown)
        return Handle::none;
    const double toFrom = std::abs(at.x() - xOf(shown->from));
    const double toTo = std::abs(at.x() - xOf(shown->to));
    if (std::min(toFrom, toTo) > handleReach)
        return Handle::none;
    return toFrom <= toTo ? Handle::from : Handle::to;
}

std::optional<ReadingPlace> ArcCurvesView::nearest(QPointF at) const {
    if (m_making.isBusy())
        return std::nullopt; // the points are changing
    std::optional<ReadingPlace> found;
    double least = pointerReach;
    const double window = pointerReach * (m_angles.to - m_angles.from) / std::max(1.0, plot().width());
    const double middle = angleAt(at.x());
    for (std::size_t k = 0; k < m_curves.profiles.size(); ++k) {
        const auto &angles = m_curves.profiles[k].angles;
        if (angles.empty())
            continue;
        const bool ascending = angles.back() >= angles.front();
        std::size_t i = 0;
        if (m_curves.profiles[k].ordered) {
            const auto before = [&](double angle) {
                return ascending ? angle < middle - window : angle > middle + window;
            };
            i = static_cast<std::size_t>(std::ranges::partition_point(angles, before) - angles.begin());
        }
        for (; i < angles.size(); ++i) {
            if (std::abs(angles[i] - middle) > window) {
                if (m_curves.profiles[k].ordered)
                    break;
                continue;
            }
            const TracePoint point = m_curves.profiles[k][i];
            const double far = std::hypot(xOf(point.angle) - at.x(), yOf(point.deviation) - at.y());
            if (far < least) {
                least = far;
                found = ReadingPlace{k, i};
            }
        }
    }
    return found;
}

void ArcCurvesView::mousePressEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_dragged = handleAt(event->position());
    if (m_dragged == Handle::none) {
        if (const auto point = nearest(event->position()))
            m_selection.setReading(*point);
    }
}

void ArcCurvesView::mouseMoveEvent(QMouseEvent *event) {
    if (m_dragged == Handle::none) {
        setCursor(handleAt(event->position()) == Handle::none ? Qt::ArrowCursor : Qt::SplitHCursor);
        m_selection.setHovered(nearest(event->position()));
        return;
    }
    Interval wanted = *range();
    const double angle =
        std::round(std::clamp(angleAt(event->position().x()), m_angles.from, m_angles.to) / roundTo) *
        roundTo;
    if (m_dragged == Handle::from)
        wanted.from = std::min(angle, wanted.to - leastRange);
    else
        wanted.to = std::max(angle, wanted.from + leastRange);
    m_preview = wanted;
    update();
}

void ArcCurvesView::mouseReleaseEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton || m_dragged == Handle::none)
        return;
    m_dragged = Handle::none;
    if (const auto wanted = m_preview)
        emit rangeWanted(m_arc, *wanted); // the preview remains until the new range is shown
    update();
}

void ArcCurvesView::leaveEvent(QEvent *) {
    m_selection.setHovered({});
}

} // namespace palmer::ui
