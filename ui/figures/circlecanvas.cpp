// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/circlecanvas.h"

#include "kernel/measurement/testfacts.h"
#include "print/figures/drawkinds.h"
#include "print/figures/metrics.h"
#include "ui/figures/canvaslabel.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int angleDecimals = 2;
constexpr int deviationDecimals = 2;
constexpr int timeDecimals = 2;
constexpr int centreFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
constexpr std::size_t circleAtOnce = 200'000; ///< points; more are made in the background

/// Visits the points of a non-empty path at most `window` degrees from the direction.
template <class Visit>
void visitNear(const PathProfile &profile, double direction, double window, const Visit &visit) {
    const auto &angles = profile.angles;
    if (!profile.ordered) {
        for (std::size_t i = 0; i < angles.size(); ++i) {
            if (std::abs(std::remainder(angles[i] - direction, 360.0)) <= window)
                visit(i);
        }
        return;
    }
    const bool ascending = angles.back() >= angles.front();
    const double lowest = std::min(angles.front(), angles.back());
    const double highest = std::max(angles.front(), angles.back());
    double middle = direction + std::ceil((lowest - window - direction) / 360) * 360;
    for (; middle - window <= highest; middle += 360) {
        const auto before = [&](double angle) {
            return ascending ? angle < middle - window : angle > middle + window;
        };
        auto i = static_cast<std::size_t>(std::ranges::partition_point(angles, before) - angles.begin());
        for (; i < angles.size() && std::abs(angles[i] - middle) <= window; ++i)
            visit(i);
    }
}

} // namespace

CircleCanvas::CircleCanvas(Selection &selection, QWidget *parent)
    : CirclePlot(parent)
    , m_selection(selection) {
    setObjectName(QStringLiteral("circleCanvas"));
    connect(&selection, &Selection::hoveredChanged, this, qOverload<>(&QWidget::update));
}

void CircleCanvas::show(const EvaluatedDocument &evaluated, std::size_t test,
                        const CircleCanvasContent &content, const Language &language) {
    const TestPointer shown = evaluated.document->tests[test];
    const TestEvaluationPointer evaluation = evaluated.tests[test];
    const auto samePaths = [](const CircleFigureOptions &a, const CircleFigureOptions &b) {
        return a.of == b.of && a.subject == b.subject && a.repetitions == b.repetitions;
    };
    const bool others = m_asked.evaluated.tests.empty() ||
                        m_asked.evaluated.tests[m_asked.test] != evaluation ||
                        !samePaths(m_asked.content.options, content.options);
    m_asked = {evaluated, test, content};
    m_language = language;
    if (!others) {
        if (!isMaking())
            receive({});
        return;
    }
    m_making.cancel();
    if (readingsOf(*shown) <= circleAtOnce) {
        receive(pathProfiles(*shown, *evaluation, content.options));
        return;
    }
    m_making.start([shown, evaluation, options = content.options](
                       const Background::Job &) { return pathProfiles(*shown, *evaluation, options); },
                   [this](std::vector<PathProfile> profiles) {
                       receive(std::move(profiles));
                       emit made();
                   });
}

/// Shows the last request, with new profiles if given.
void CircleCanvas::receive(std::optional<std::vector<PathProfile>> profiles) {
    const TestPointer &test = m_asked.evaluated.document->tests[m_asked.test];
    if (profiles)
        m_profiles = std::move(*profiles);
    m_profilesOf = m_asked.evaluated.tests[m_asked.test];
    if (profiles || m_content.synthetic != m_asked.content.synthetic) {
        m_content.options = m_asked.content.options;
        addSynthetic(*test, m_asked.content.synthetic);
    }
    m_evaluated = m_asked.evaluated;
    m_test = m_asked.test;
    m_content = m_asked.content;
    discardFigure();
}

void CircleCanvas::addSynthetic(const Test &test, const SyntheticPaths &synthetic) {
    std::erase_if(m_profiles, &PathProfile::synthetic);
    if (synthetic.of != m_profilesOf || !synthetic.paths)
        return;
    for (PathProfile &profile : profilesOfPaths(test, *m_profilesOf, m_content.options, *synthetic.paths)) {
        profile.synthetic = true;
        m_profiles.push_back(std::move(profile));
    }
}

void CircleCanvas::clear() {
    m_making.cancel();
    m_asked = {};
    m_evaluated = {};
    m_profilesOf.reset();
    m_profiles.clear();
    discardFigure();
}

void CircleCanvas::setMarking(const QString &label, const std::vector<RulingPoint> &points) {
    m_markingLabel = label;
    m_ruling = points;
    update();
}

bool CircleCanvas::shows(Sense sense) const {
    return sense == Sense::counterclockwise ? m_content.counterclockwise : m_content.clockwise;
}

CircleFigure CircleCanvas::withoutHidden(CircleFigure figure) const {
    std::erase_if(figure.traces, [&](const CircleTrace &trace) { return !shows(trace.sense); });
    std::erase_if(figure.starts, [&](const TraceMark &start) { return !shows(start.sense); });
    std::erase_if(figure.arrows, [&](const SenseArrow &arrow) { return !shows(arrow.sense); });
    std::erase_if(figure.contacts, [&](const ContactMark &contact) { return !shows(contact.mark.sense); });
    std::erase_if(figure.legend, [&](const CircleLegendEntry &entry) {
        return (entry.sample == CircleLegendSample::counterclockwise && !shows(Sense::counterclockwise)) ||
               (entry.sample == CircleLegendSample::clockwise && !shows(Sense::clockwise));
    });
    return figure;
}

CircleFigure CircleCanvas::wholeFigure(QSizeF size, double pointStep) const {
    CircleFigureOptions options = m_content.options;
    options.size = size;
    options.pointStep = pointStep;
    return circleFigure(*m_evaluated.document->tests[m_test], *m_profilesOf, m_profiles, m_language, options);
}

void CircleCanvas::drawPicture(QPainter &painter) {
    if (!m_profilesOf)
        return;
    fitFigure();
    m_shown = withoutHidden(*m_figure);
    // The buttons next to the figure name the paths.
    std::erase_if(m_shown.legend, [](const CircleLegendEntry &entry) {
        return entry.sample == CircleLegendSample::counterclockwise ||
               entry.sample == CircleLegendSample::clockwise ||
               entry.sample == CircleLegendSample::repetitions;
    });
    const Medium medium = screenMedium(palette());
    m_transform = drawFigure(painter, QRectF(rect()), m_shown, medium);
    const QRectF inPoints(QPointF(0, 0), QSizeF(size()) * pointsPerPixel);
    m_leftOfSenses = leftOfSenses(painter, inPoints, m_shown, medium) / pointsPerPixel;
}

std::optional<CircleFigure> CircleCanvas::paperFigure() const {
    if (!m_profilesOf)
        return std::nullopt;
    const CircleFigureOptions paper;
    CircleFigure figure = wholeFigure(paper.size, paper.pointStep);
    if (view() != CircleView{} && m_figure) {
        const double scale = figure.figureRadius / m_figure->figureRadius;
        figure = withView(figure, m_profiles, {view().x * scale, view().y * scale, view().zoom}, m_language);
    }
    return withoutHidden(std::move(figure));
}

// ---- Points ----------------------------------------------------------------------------------------------

QPointF CircleCanvas::shown(const TracePoint &point) const {
    const double angle = point.angle * std::numbers::pi / 180;
    const double radius = m_shown.radius(point.deviation);
    return m_transform.map(radius * std::cos(angle), radius * std::sin(angle));
}

std::optional<CircleCanvas::ProfilePoint> CircleCanvas::nearest(QPointF at) const {
    if (!m_figure)
        return std::nullopt;
    const QPointF centre = m_transform.map(0, 0);
    const QPointF way = at - centre;
    const double distance = std::hypot(way.x(), way.y());
    if (distance < pointerReach)
        return std::nullopt;
    const double direction = std::atan2(-way.y(), way.x()) * 180 / std::numbers::pi;
    const double window = std::asin(pointerReach / distance) * 180 / std::numbers::pi;
    std::optional<ProfilePoint> found;
    double least = pointerReach;
    const auto look = [&](std::size_t profile, std::size_t i) {
        const QPointF away = shown(m_profiles[profile][i]) - at;
        const double far = std::hypot(away.x(), away.y());
        if (far < least) {
            least = far;
            found = ProfilePoint{profile, i};
        }
    };
    for (std::size_t k = 0; k < m_profiles.size(); ++k) {
        const PathProfile &profile = m_profiles[k];
        if (shows(profile.sense) && !profile.angles.empty() && !profile.synthetic)
            visitNear(profile, direction, window, [&](std::size_t i) { look(k, i); });
    }
    return found;
}

std::optional<CircleCanvas::ProfilePoint> CircleCanvas::find(const ReadingPlace &place) const {
    for (std::size_t k = 0; k < m_profiles.size(); ++k) {
        const PathProfile &profile = m_profiles[k];
        if (profile.arc != place.run || profile.synthetic || !shows(profile.sense))
            continue;
        const auto found = std::ranges::lower_bound(profile.source, place.target);
        if (found != profile.source.end() && *found == place.target)
            return ProfilePoint{k, static_cast<std::size_t>(found - profile.source.begin())};
    }
    return std::nullopt;
}

/// The point of the path closest to the angle, as angles differ slightly about another centre.
std::optional<CircleCanvas::ProfilePoint> CircleCanvas::pointOf(const RulingPoint &ruling) const {
    for (std::size_t k = 0; k < m_profiles.size(); ++k) {
        const PathProfile &profile = m_profiles[k];
        if (!profile.isEvaluated() || profile.index != ruling.path.toStdString() || !shows(profile.sense))
            continue;
        const auto away = [&](double angle) { return std::abs(std::remainder(angle - ruling.angle, 360.0)); };
        const auto found = std::ranges::min_element(profile.angles, {}, away);
        if (found != profile.angles.end())
            return ProfilePoint{k, static_cast<std::size_t>(found - profile.angles.begin())};
    }
    return std::nullopt;
}

std::optional<ReadingPlace> CircleCanvas::pointedAt(const QPointF &at) const {
    const auto found = nearest(at);
    if (!found)
        return std::nullopt;
    const PathProfile &profile = m_profiles[found->profile];
    return ReadingPlace{profile.arc, profile.source[found->point]};
}

std::optional<QPointF> CircleCanvas::placeOf(const ReadingPlace &point) {
    drawAnew();
    const auto found = find(point);
    if (!found || !m_figure)
        return std::nullopt;
    const QPointF at = shown(m_profiles[found->profile][found->point]);
    return QRectF(rect()).contains(at) ? std::optional(at) : std::nullopt;
}

QString CircleCanvas::readOut(const ReadingPlace &point) const {
    const auto found = find(point);
    if (!found)
        return {};
    const PathProfile &profile = m_profiles[found->profile];
    const TracePoint at = profile[found->point];
    QString text = QString::fromStdString(profile.index) + QStringLiteral("  ") +
                   m_language.quantity(at.angle, Quantity::angle, angleDecimals) + QStringLiteral("  ") +
                   m_language.quantity(at.deviation, Quantity::micrometres, deviationDecimals);
    if (profile.sampleInterval)
        text += QStringLiteral("  ") +
                m_language.quantity(static_cast<double>(point.target) * *profile.sampleInterval,
                                    Quantity::time, timeDecimals);
    return text;
}

QString CircleCanvas::deviationText(const ReadingPlace &point) const {
    const auto found = find(point);
    return found ? m_language.quantity(m_profiles[found->profile][found->point].deviation,
                                       Quantity::micrometres, deviationDecimals)
                 : QString();
}

// ---- Painting --------------------------------------------------------------------------------------------

void CircleCanvas::paintOver(QPainter &painter) {
    if (!m_profilesOf)
        return;
    paintCentre(painter);
    paintMarking(painter);
    const auto hovered = m_selection.hovered();
    if (const auto at = hovered ? placeOf(*hovered) : std::nullopt)
        paintPointed(painter, *this, *at, readOut(*hovered));
}

QRect CircleCanvas::centreBox() const {
    constexpr int left = 6;
    constexpr int least = 56; // fits the longest word
    const int room = std::min(std::max(width() * 3 / 10, 100), static_cast<int>(m_leftOfSenses) - 2 * left);
    return QFontMetrics(themeFont(TextSize::tiny))
        .boundingRect(QRect(left, 4, std::max(room, least), height()), centreFlags, m_shown.centre);
}

/// In a corner free of circles, always shown: without it the numbers have no meaning.
void CircleCanvas::paintCentre(QPainter &painter) const {
    painter.setFont(themeFont(TextSize::tiny));
    const QRect text = centreBox();
    QColor ground = palette().color(QPalette::Base);
    ground.setAlphaF(0.8F);
    painter.fillRect(text.adjusted(-2, -1, 2, 1), ground);
    painter.setPen(token(Token::secondaryText, palette()));
    painter.drawText(text, centreFlags, m_shown.centre);
}

void CircleCanvas::paintMarking(QPainter &painter) const {
    if (m_markingLabel.isEmpty())
        return;
    const QColor colour = token(Token::explanation, palette());
    painter.setPen(QPen(colour, 2));
    painter.setBrush(Qt::NoBrush);
    for (const RulingPoint &ruling : m_ruling) {
        if (const auto point = pointOf(ruling))
            painter.drawEllipse(shown(m_profiles[point->profile][point->point]), ringRadius, ringRadius);
    }
    paintCanvasLabel(painter, *this, {-10, 14}, m_markingLabel, colour);
}

// ---- Pointer and keys ------------------------------------------------------------------------------------

void CircleCanvas::mousePressEvent(QMouseEvent *event) {
    emit pressed();
    CirclePlot::mousePressEvent(event);
}

void CircleCanvas::click(const QPointF &at) {
    if (const auto found = pointedAt(at))
        m_selection.setReading(*found);
}

} // namespace palmer::ui
