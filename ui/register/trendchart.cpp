// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/trendchart.h"

#include "register/listing.h"
#include "register/trendfigure.h"
#include "report/words/wording.h"
#include "ui/register/numberaxis.h"
#include "ui/register/numbertag.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QAreaSeries>
#include <QCategoryAxis>
#include <QChart>
#include <QEvent>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double chosenRadius = 8;
constexpr double capWidth = 3;
constexpr double hatchHeight = 6;
constexpr double hatchStep = 6;
constexpr double pointerReach = 9; ///< around the pointer, px
constexpr int strip = 24;          ///< above the plot, for interventions
constexpr double bandLight = 0.13;
constexpr double bandDark = 0.20;
constexpr int mostTicks = 12;

} // namespace

TrendChart::TrendChart(QWidget *parent)
    : PlotChart(parent, {0, strip, 8, 0}) {
    setObjectName(QStringLiteral("trendChart"));
    setMinimumHeight(180);
    setAccessibleName(tr("Trend"));
}

void TrendChart::setTrend(const MachineTrend &trend, const QDate &today) {
    m_trend = trend;
    m_today = today;
    m_hovered.reset();
    rebuild();
}

void TrendChart::setChosen(const std::map<QString, int> &numbers) {
    m_chosen = numbers;
    viewport()->update();
}

void TrendChart::changeEvent(QEvent *event) {
    PlotChart::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange)
        rebuild();
}

void TrendChart::addLine(const std::vector<QPointF> &points, const QPen &pen) {
    auto *line = new QLineSeries;
    for (const QPointF &point : points)
        line->append(point);
    line->setPen(pen);
    chart()->addSeries(line);
    line->attachAxis(m_x);
    line->attachAxis(m_y);
}

void TrendChart::addBand(const QColor &accent) {
    auto *upper = new QLineSeries(this);
    auto *lower = new QLineSeries(this);
    for (const BandPoint &point : m_panel.band) {
        upper->append(point.x, point.upper);
        lower->append(point.x, point.lower);
    }
    auto *band = new QAreaSeries(upper, lower);
    QColor fill = accent;
    fill.setAlphaF(static_cast<float>(isDark(palette()) ? bandDark : bandLight));
    band->setBrush(fill);
    band->setPen(QPen(accent, 0.8));
    chart()->addSeries(band);
    band->attachAxis(m_x);
    band->attachAxis(m_y);
}

void TrendChart::rebuild() {
    clear(*chart());
    m_entries.clear();
    for (const TrendSeries &series : m_trend.series) {
        for (const TrendEntry &entry : series.entries)
            m_entries.push_back(&entry);
    }
    m_panel = trendPanel(m_trend, trendSpan({m_trend}, m_today), m_today, windowLanguage(), mostTicks);
    const QPalette look = palette();
    chart()->setBackgroundBrush(look.color(QPalette::Base));
    const QColor accent = token(Token::accent, look);
    const QColor text = look.color(QPalette::Text);
    const auto axis = [&](Qt::Alignment side, const FigureAxis &range) {
        QCategoryAxis *made = makeNumberAxis(range, look);
        made->setLinePenColor(text);
        chart()->addAxis(made, side);
        return made;
    };
    m_x = axis(Qt::AlignBottom, m_panel.x);
    m_y = axis(Qt::AlignLeft, m_panel.y);
    showWhole();
    for (QCategoryAxis *one : {m_x, m_y})
        one->setVisible(!m_panel.values.empty());
    if (!m_panel.band.empty())
        addBand(accent);
    for (const auto &joined : m_panel.joined)
        addLine(joined, QPen(token(Token::secondaryText, look), 1));
    for (const auto &limit : m_panel.limits)
        addLine(limit, QPen(text, 2));
    addLine(m_panel.line, QPen(accent, 2));
    QPen dashed(accent, 2);
    dashed.setDashPattern({4, 3});
    addLine(m_panel.later, dashed);
    viewport()->update();
}

void TrendChart::showRange() {
    m_x->setRange(range().left(), range().right());
    fillTicks(*m_x, m_panel.x);
}

/// Never less than some weeks; values are always shown in full.
QSizeF TrendChart::deepestZoom() const {
    constexpr double shortest = 0.1; // years
    return {std::max(1.0, whole().width() / shortest), 1};
}

std::optional<std::size_t> TrendChart::nearest(const QPointF &position) const {
    std::optional<std::size_t> nearest;
    double least = pointerReach;
    for (std::size_t i = 0; i < m_panel.values.size(); ++i) {
        const QPointF at = placeOf({m_panel.values[i].x, m_panel.values[i].y});
        const double away = std::hypot(at.x() - position.x(), at.y() - position.y());
        if (away <= least) {
            least = away;
            nearest = i;
        }
    }
    return nearest;
}

QString TrendChart::label(std::size_t value) const {
    const TrendEntry &entry = *m_entries[value];
    const ShownValue shown = shownResult(entry.result, m_trend.angular, windowLanguage());
    return windowLanguage().shortDate(entry.date) + QStringLiteral(" · ") + m_panel.symbol + u' ' +
           shown.text() + u' ' + m_panel.y.unit;
}

void TrendChart::paintOver(QPainter &painter) {
    if (m_panel.values.empty())
        return drawEmpty(painter);
    const QRectF plot = chart()->plotArea();
    const QPalette look = palette();
    const double today = std::clamp(placeOf({m_panel.today, 0}).x(), plot.left(), plot.right());
    QColor ground = token(Token::secondaryText, look);
    ground.setAlphaF(0.07F);
    painter.fillRect(QRectF(QPointF(today, plot.top()), plot.bottomRight()), ground);
    if (today < plot.right()) {
        painter.setPen(QPen(token(Token::secondaryText, look), 1));
        painter.drawLine(QPointF(today, plot.top()), QPointF(today, plot.bottom()));
        drawToday(painter, plot, today);
    }
    drawInterventions(painter, plot);
    drawInterventionNames(painter, plot);
    drawForbidden(painter, plot);
    painter.setClipRect(plot.adjusted(-chosenRadius, -chosenRadius, chosenRadius, chosenRadius));
    drawValues(painter, plot);
    drawTags(painter, plot);
    drawNotBefore(painter, plot);
    drawLabel(painter, plot);
}

/// Draws "today" next to its line, away from limits and values.
void TrendChart::drawToday(QPainter &painter, const QRectF &plot, double today) const {
    painter.setFont(themeFont(TextSize::tiny));
    const QFontMetrics metrics = painter.fontMetrics();
    const double width = metrics.horizontalAdvance(tr("today"));
    const bool fits = today + 5 + width < plot.right();
    QRectF place(fits ? today + 5 : today - 5 - width, plot.top() + 3, width, metrics.height());
    for (const double top = place.top(); place.bottom() < plot.bottom(); place.translate(0, 4)) {
        if (isFree(place))
            break;
        if (place.bottom() + 4 >= plot.bottom()) { // no free place
            place.moveTop(top);
            break;
        }
    }
    painter.drawText(place, Qt::AlignCenter, tr("today"));
}

bool TrendChart::isFree(const QRectF &area) const {
    const QRectF wide = area.adjusted(-2, -hatchHeight - 1, 2, hatchHeight + 1);
    for (const auto &limit : m_panel.limits) {
        for (std::size_t i = 0; i + 1 < limit.size(); ++i) {
            const QPointF from = placeOf(limit[i]);
            const QPointF to = placeOf(limit[i + 1]);
            if (wide.intersects(QRectF(from, to).normalized().adjusted(-1, -1, 1, 1)))
                return false;
        }
    }
    return std::ranges::none_of(m_panel.values, [&](const TrendValue &value) {
        const double reach = value.expanded.value_or(0);
        return wide.intersects(
            QRectF(placeOf({value.x, value.y + reach}), placeOf({value.x, value.y - reach}))
                .adjusted(-trendMarkRadius, -trendMarkRadius, trendMarkRadius, trendMarkRadius));
    });
}

void TrendChart::drawInterventions(QPainter &painter, const QRectF &plot) const {
    const QColor colour = token(Token::explanation, palette());
    QColor pale = colour;
    pale.setAlphaF(0.55F);
    for (const TrendIntervention &one : m_panel.interventions) {
        const double at = placeOf({one.x, 0}).x();
        if (at < plot.left() || at > plot.right())
            continue;
        painter.setPen(QPen(pale, 1, Qt::DashLine));
        painter.drawLine(QPointF(at, plot.top()), QPointF(at, plot.bottom()));
        if (!one.found || !one.left)
            continue;
        const QPointF from = placeOf(*one.found);
        const QPointF to = placeOf(*one.left);
        painter.setPen(QPen(colour, 1.4));
        painter.drawLine(from, to);
        const double turn = std::atan2(to.y() - from.y(), to.x() - from.x());
        for (const double side : {-0.45, 0.45})
            painter.drawLine(to, to - 6 * QPointF(std::cos(turn + side), std::sin(turn + side)));
    }
}

/// In the strip above the plot, at their lines; if two are close, left of the first and right of the second,
/// and of one day together; without text if it does not fit.
void TrendChart::drawInterventionNames(QPainter &painter, const QRectF &plot) const {
    constexpr double icon = 14;
    constexpr double gap = 4;
    struct Label {
        double at;
        QString name;
        bool isCollision;
        double width = 0;
    };
    painter.setFont(themeFont(TextSize::tiny));
    std::vector<Label> labels;
    for (std::size_t i = 0; i < m_panel.interventions.size(); ++i) {
        const double at = placeOf({m_panel.interventions[i].x, 0}).x();
        if (at < plot.left() || at > plot.right())
            continue;
        const bool isCollision =
            i < m_trend.interventions.size() && m_trend.interventions[i].kind == InterventionKind::collision;
        if (!labels.empty() && at - labels.back().at < icon)
            labels.back().name += QStringLiteral(", ") + m_panel.interventions[i].name;
        else
            labels.push_back({at, m_panel.interventions[i].name, isCollision});
        labels.back().width = icon + painter.fontMetrics().horizontalAdvance(labels.back().name);
    }
    const QString unit = m_panel.symbol + u' ' + m_panel.unitName;
    painter.setPen(token(Token::secondaryText, palette()));
    painter.drawText(QPointF(2, plot.top() - 8), unit);
    double free = 2 + painter.fontMetrics().horizontalAdvance(unit) + gap;
    const QColor colour = token(Token::explanation, palette());
    painter.setPen(colour);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto &[at, name, isCollision, width] = labels[i];
        const bool isCrowded =
            i + 1 < labels.size() && labels[i + 1].at - at < (width + labels[i + 1].width) / 2 + gap;
        double left = isCrowded ? at - width + icon / 2 : at - width / 2;
        if (left < free)
            left = std::max(free, at - icon / 2); // right of its line
        left = std::min(left, plot.right() - width);
        if (left < free)
            continue;
        drawLineIcon(painter, QRect(static_cast<int>(left), static_cast<int>(plot.top()) - 19, 12, 14),
                     isCollision ? QStringLiteral("bolt") : QStringLiteral("wrench"), colour);
        painter.drawText(QPointF(left + icon, plot.top() - 8), name);
        free = left + width + gap;
    }
}

/// Hatches the forbidden side of the limit.
void TrendChart::drawForbidden(QPainter &painter, const QRectF &plot) const {
    painter.save();
    painter.setClipRect(plot);
    painter.setPen(QPen(token(Token::secondaryText, palette()), 0.8));
    const double above = m_trend.bound == Bound::lower ? -1 : 1;
    for (const auto &limit : m_panel.limits) {
        for (std::size_t i = 0; i + 1 < limit.size(); ++i) {
            if (limit[i].y() != limit[i + 1].y())
                continue;
            const QPointF from = placeOf(limit[i]);
            const QPointF to = placeOf(limit[i + 1]);
            for (int stroke = 0; stroke * hatchStep < to.x() - from.x(); ++stroke) {
                const QPointF foot(from.x() + stroke * hatchStep, from.y());
                painter.drawLine(foot, foot + QPointF(hatchHeight, -above * hatchHeight));
            }
        }
    }
    painter.restore();
}

void TrendChart::drawEmpty(QPainter &painter) const {
    painter.setFont(themeFont(TextSize::small));
    painter.setPen(token(Token::secondaryText, palette()));
    painter.drawText(QRectF(viewport()->rect()), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No test with a date and a value to show."));
}

/// Draws the numbers of the chosen tests on the left of their points without overlaps.
void TrendChart::drawTags(QPainter &painter, const QRectF &plot) const {
    if (m_chosen.size() < 2)
        return;
    constexpr double away = 18;
    constexpr double cross = 18; ///< the mark of an exceeded limit
    std::vector<QPointF> drawn;
    for (std::size_t i = 0; i < m_panel.values.size(); ++i) {
        const auto chosen = m_chosen.find(m_entries[i]->digest);
        const QPointF at = placeOf({m_panel.values[i].x, m_panel.values[i].y});
        if (chosen == m_chosen.end() || at.x() < plot.left() || at.x() > plot.right())
            continue;
        QPointF centre = at - QPointF(away + (m_panel.values[i].exceeds ? cross : 0), 0);
        for (const QPointF &other : drawn) {
            if (std::hypot(centre.x() - other.x(), centre.y() - other.y()) < leastTagDistance)
                centre.setY(other.y() - leastTagDistance);
        }
        drawn.push_back(centre);
        drawNumberTag(painter, centre, chosen->second, palette());
    }
}

void TrendChart::drawValues(QPainter &painter, const QRectF &plot) const {
    const QPalette look = palette();
    for (std::size_t i = 0; i < m_panel.values.size(); ++i) {
        const TrendValue &value = m_panel.values[i];
        const QPointF at = placeOf({value.x, value.y});
        if (at.x() < plot.left() || at.x() > plot.right())
            continue;
        const bool other = value.mark == TrendMark::otherSeries;
        QColor colour = token(other ? Token::secondaryText : Token::accent, look);
        if (value.exceeds)
            colour = token(Token::bad, look);
        if (value.expanded) {
            painter.setPen(QPen(token(Token::secondaryText, look), 1.1));
            const double top = placeOf({value.x, value.y + *value.expanded}).y();
            const double bottom = placeOf({value.x, value.y - *value.expanded}).y();
            painter.drawLine(QPointF(at.x(), top), QPointF(at.x(), bottom));
            painter.drawLine(QPointF(at.x() - capWidth, top), QPointF(at.x() + capWidth, top));
            painter.drawLine(QPointF(at.x() - capWidth, bottom), QPointF(at.x() + capWidth, bottom));
        }
        drawRoleMark(painter, at, value.mark, colour, look);
        if (value.exceeds)
            drawLineIcon(painter, QRect(static_cast<int>(at.x()) - 24, static_cast<int>(at.y()) - 8, 16, 16),
                         QStringLiteral("cross"), colour);
        const auto chosen = m_chosen.find(m_entries[i]->digest);
        if (chosen == m_chosen.end())
            continue;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(token(Token::accent, look), 1.5));
        painter.drawEllipse(at, chosenRadius, chosenRadius);
    }
}

void TrendChart::drawNotBefore(QPainter &painter, const QRectF &plot) const {
    if (!m_panel.notBefore)
        return;
    const QPointF at = placeOf(*m_panel.notBefore);
    if (at.x() < plot.left() || at.x() > plot.right())
        return;
    const QPalette look = palette();
    const QColor accent = token(Token::accent, look);
    painter.setPen(QPen(accent, 1.3, Qt::DotLine));
    painter.drawLine(at, QPointF(at.x(), plot.bottom()));
    painter.setPen(QPen(accent, 1.5));
    painter.setBrush(look.color(QPalette::Base));
    painter.drawPolygon(
        QPolygonF{at + QPointF(0, -5), at + QPointF(5, 0), at + QPointF(0, 5), at + QPointF(-5, 0)});
    QFont font = themeFont(TextSize::tiny);
    font.setBold(true);
    painter.setFont(font);
    const double width = painter.fontMetrics().horizontalAdvance(m_panel.statement) + 12;
    const double left =
        std::clamp(at.x() - width / 2, plot.left(), std::max(plot.left(), plot.right() - width));
    const QRectF box(left, plot.bottom() - 26, width, 20);
    painter.drawRoundedRect(box, 3, 3);
    painter.drawText(box, Qt::AlignCenter, m_panel.statement);
}

void TrendChart::drawLabel(QPainter &painter, const QRectF &plot) const {
    if (!m_hovered || *m_hovered >= m_panel.values.size())
        return;
    const QPointF at = placeOf({m_panel.values[*m_hovered].x, m_panel.values[*m_hovered].y});
    const QPalette look = palette();
    painter.setFont(themeFont(TextSize::small));
    const QString text = label(*m_hovered);
    const double width = painter.fontMetrics().horizontalAdvance(text) + 12;
    const double left =
        std::clamp(at.x() - width - 6, plot.left(), std::max(plot.left(), plot.right() - width));
    const QRectF box(left, std::max(plot.top(), at.y() - 44), width, 22);
    painter.setPen(QPen(token(Token::accent, look), 1));
    painter.setBrush(look.color(QPalette::Base));
    painter.drawEllipse(at, chosenRadius, chosenRadius);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(look.color(QPalette::Text));
    painter.drawText(box, Qt::AlignCenter, text);
}

void TrendChart::hover(const std::optional<QPointF> &at) {
    const auto hovered = at ? nearest(*at) : std::nullopt;
    if (hovered == m_hovered)
        return;
    m_hovered = hovered;
    viewport()->update();
}

void TrendChart::click(const QPointF &at) {
    if (const auto value = nearest(at))
        emit testChosen(m_entries[*value]->digest);
}

void TrendChart::mouseReleaseEvent(QMouseEvent *event) {
    PlotChart::mouseReleaseEvent(event);
    if (event->button() == Qt::RightButton)
        fit();
}

} // namespace palmer::ui
