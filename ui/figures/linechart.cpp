// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/linechart.h"

#include "figures/thinning.h"
#include "figures/ticks.h"
#include "print/figures/drawkinds.h"
#include "ui/figures/canvaslabel.h"
#include "ui/theme.h"

#include <QCategoryAxis>
#include <QChart>
#include <QEvent>
#include <QLineSeries>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double chartReach = 16;   ///< around the pointer, pixels
constexpr double ticksOfWidth = 90; ///< pixels per tick of x
constexpr double ticksOfHeight = 28;
constexpr std::size_t fewPoints = 12; ///< up to which each point is marked
constexpr double markerSize = 4;
constexpr std::size_t leastParts = 200; ///< of a drawn line

QPen onScreen(QPen pen) {
    pen.setWidthF(pen.widthF() / pointsPerPixel);
    return pen;
}

} // namespace

LineChart::LineChart(QWidget *parent)
    : PlotChart(parent, {0, 8, 16, 0}) { // for half of the last labels
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_x = new QCategoryAxis(this);
    m_y = new QCategoryAxis(this);
    for (QCategoryAxis *axis : {m_x, m_y})
        axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    chart()->addAxis(m_x, Qt::AlignBottom);
    chart()->addAxis(m_y, Qt::AlignLeft);
}

void LineChart::setFigure(const LineFigure &figure, const Language &language, const QString &empty) {
    const bool same = figure.x == m_figure.x && figure.y == m_figure.y && !range().isNull();
    m_figure = figure;
    m_language = language;
    m_empty = empty;
    m_pointed.reset();
    if (!same)
        showWhole();
    build();
}

/// Builds series, colours and axes for a new figure or palette.
void LineChart::build() {
    const Medium medium = screenMedium(palette());
    const QColor text = figureColor(FigureRole::text, medium);
    chart()->removeAllSeries();
    chart()->setBackgroundBrush(palette().color(QPalette::Base));
    chart()->setBackgroundPen(Qt::NoPen);
    const bool few = std::ranges::all_of(
        m_figure.lines, [](const FigureLine &line) { return line.points.size() < fewPoints; });
    for (const FigureLine &line : m_figure.lines) {
        auto *series = new QLineSeries;
        series->setName(line.name);
        series->setPen(onScreen(linePen(line.role, medium)));
        series->setPointsVisible(few);
        series->setMarkerSize(markerSize);
        chart()->addSeries(series);
        series->attachAxis(m_x);
        series->attachAxis(m_y);
    }
    for (QCategoryAxis *axis : {m_x, m_y}) {
        axis->setVisible(!m_figure.lines.empty());
        axis->setLabelsFont(themeFont(TextSize::tiny));
        axis->setTruncateLabels(false); // an elided number is useless: leaves out labels
        axis->setLabelsColor(text);
        axis->setTitleFont(themeFont(TextSize::tiny));
        axis->setTitleBrush(text);
        axis->setLinePen(onScreen(figurePen(FigureRole::axis, medium)));
        axis->setGridLinePen(onScreen(figurePen(FigureRole::grid, medium)));
        const FigureAxis &content = axis == m_x ? m_figure.x : m_figure.y;
        QString title = content.quantity;
        if (!content.symbol.isEmpty())
            title += u' ' + content.symbol + content.subscript;
        if (!content.unit.isEmpty() && !title.isEmpty())
            title += QStringLiteral(" (") + content.unit + u')';
        axis->setTitleText(title);
        axis->setTitleVisible(!title.isEmpty());
    }
    m_x->setGridLineVisible(false);
    showRange();
    viewport()->update();
}

void LineChart::showRange() {
    fillAxis(*m_x, m_figure.x, range().left(), range().right());
    fillAxis(*m_y, m_figure.y, range().top(), range().bottom());
    fillLines();
}

void LineChart::fillAxis(QCategoryAxis &axis, const FigureAxis &content, double from, double to) {
    for (const QString &label : axis.categoriesLabels())
        axis.remove(label);
    if (!(to > from))
        return;
    FigureAxis shown = content;
    const bool whole = from == content.from && to == content.to;
    const bool across = &axis == m_x;
    const double room = across ? width() / ticksOfWidth : height() / ticksOfHeight;
    if (!whole || !across)
        palmer::setRange(shown, from, to, std::max(2.0, room),
                         content.angle ? TickSteps::angles : TickSteps::values, m_language);
    axis.setStartValue(from);
    axis.setRange(from, to);
    for (const Tick &tick : shown.ticks)
        axis.append(tick.label, tick.value);
}

void LineChart::fillLines() {
    const auto all = chart()->series();
    const auto parts = std::max<std::size_t>(leastParts, static_cast<std::size_t>(std::max(0, width())));
    for (qsizetype i = 0; i < all.size(); ++i) {
        const std::vector<QPointF> &points = m_figure.lines[static_cast<std::size_t>(i)].points;
        QList<QPointF> shown;
        if (points.size() <= 4 * parts) {
            shown = QList<QPointF>(points.begin(), points.end());
        } else {
            for (const std::size_t place : thinnedPlaces(
                     points.size(), range().left(), range().right(), parts,
                     [&](std::size_t k) { return points[k].x(); },
                     [&](std::size_t k) { return points[k].y(); }))
                shown.append(points[place]);
        }
        qobject_cast<QLineSeries *>(all[i])->replace(shown);
    }
}

// ---- Points ----------------------------------------------------------------------------------------------

std::optional<LineChart::Place> LineChart::nearest(const QPointF &place) const {
    if (m_figure.lines.empty() || !plotArea().contains(place))
        return std::nullopt;
    const double half = chartReach / plotArea().width() * range().width();
    const double x = valueAt(place).x();
    std::optional<Place> found;
    double least = chartReach;
    for (std::size_t k = 0; k < m_figure.lines.size(); ++k) {
        const std::vector<QPointF> &points = m_figure.lines[k].points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (std::abs(points[i].x() - x) > half)
                continue;
            const QPointF away = placeOf(points[i]) - place;
            const double far = std::hypot(away.x(), away.y());
            if (far < least) {
                least = far;
                found = Place{k, i};
            }
        }
    }
    return found;
}

QString LineChart::words(const Place &place) const {
    const FigureLine &line = m_figure.lines[place.line];
    const QPointF at = line.points[place.point];
    if (m_readOut)
        return m_readOut(line, at);
    constexpr int decimals = 2;
    const auto number = [&](double value, const FigureAxis &axis) {
        const QString digits = m_language.number(value, Quantity::number, decimals);
        return axis.unit.isEmpty() ? digits : digits + QStringLiteral("\u00A0") + axis.unit;
    };
    return number(at.x(), m_figure.x) + QStringLiteral("  ") + number(at.y(), m_figure.y);
}

QString LineChart::readOutAt(const QPointF &place) const {
    const auto found = nearest(place);
    return found ? words(*found) : QString();
}

void LineChart::hover(const std::optional<QPointF> &at) {
    const auto pointed = at ? nearest(*at) : std::nullopt;
    if (pointed == m_pointed)
        return;
    m_pointed = pointed;
    viewport()->update();
}

void LineChart::paintOver(QPainter &painter) {
    if (m_figure.lines.empty()) {
        painter.setFont(themeFont(TextSize::small));
        painter.setPen(token(Token::secondaryText, palette()));
        painter.drawText(QRectF(viewport()->rect()), Qt::AlignCenter | Qt::TextWordWrap, m_empty);
    }
    if (m_pointed)
        paintPointed(painter, *this, placeOf(m_figure.lines[m_pointed->line].points[m_pointed->point]),
                     words(*m_pointed));
}

void LineChart::changeEvent(QEvent *event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        build();
}

} // namespace palmer::ui
