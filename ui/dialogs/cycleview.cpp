// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/cycleview.h"

#include "figures/ticks.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <vector>

namespace palmer::ui {

namespace {

constexpr double side = 24;
constexpr double titleRoom = 34;
constexpr double foot = 46; ///< px below, for the axis
constexpr double tickDistance = 70;
constexpr double arrowRadius = 2.6;
constexpr std::size_t mostMoves = 4000; ///< drawn one by one; more would overlap

/// Row of each move: one per pass in the standard cycle, one per stop in the step cycle.
std::vector<double> rowsOf(const std::vector<Move> &path) {
    std::vector<double> rows;
    rows.reserve(path.size());
    double row = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const bool turns = !path[i].stop;
        if (i > 0 && turns)
            row += 1;
        rows.push_back(row);
    }
    return rows;
}

QColor colourOf(Direction direction, const QPalette &palette) {
    return token(direction == Direction::positive ? Token::up : Token::down, palette);
}

/// Draws the axis below the cycle: its range with name and unit. `x` maps a position to the widget.
void drawAxis(QPainter &painter, const CycleProgram &program, double from, double to, double top,
              const QPalette &palette, const auto &x) {
    const Language &language = windowLanguage();
    const bool linear = program.motion == Motion::linear;
    const Quantity quantity = linear ? Quantity::position : Quantity::angle;
    const double scale = unitScale(quantity, language.units());
    FigureAxis axis;
    setRange(axis, from * scale, to * scale, std::max(2.0, (x(to) - x(from)) / tickDistance),
             linear ? TickSteps::lengths : TickSteps::angles, language);
    painter.setPen(QPen(palette.color(QPalette::Text), 1));
    painter.drawLine(QPointF(x(from), top), QPointF(x(to), top));
    for (const Tick &tick : axis.ticks) {
        const double at = x(tick.value / scale);
        painter.drawLine(QPointF(at, top), QPointF(at, top + 4));
        painter.drawText(QRectF(at - tickDistance / 2, top + 5, tickDistance, 15),
                         Qt::AlignHCenter | Qt::AlignTop, tick.label);
    }
    painter.drawText(
        QRectF(x(from), top + 20, x(to) - x(from), 16), Qt::AlignHCenter | Qt::AlignTop,
        QStringLiteral("%1 (%2)").arg(QString::fromStdString(program.axis), language.unit(quantity)));
}

/// Pen of the line to the end of a move; dotted if the axis reverses there without stopping.
QPen penOf(const Move &move, const QPalette &palette) {
    if (!move.stop)
        return {token(Token::secondaryText, palette), 1, Qt::DotLine};
    return {colourOf(move.stop->approach, palette), 1.6};
}

/// Draws a cycle of so many moves that single ones cannot be told apart: a line for each row, unless rows
/// are as many and those before it fill its pixels already. `x` and `y` map a position and a row to the
/// widget.
void drawRows(QPainter &painter, const std::vector<Move> &path, const std::vector<double> &rows,
              const QPalette &palette, const auto &x, const auto &y) {
    double line = -1; // of pixels
    Interval filled;
    for (std::size_t from = 0, to = 0; from < path.size(); from = to) {
        double low = path[from].position;
        double high = low;
        for (to = from; to < path.size() && rows[to] == rows[from]; ++to) {
            low = std::min(low, path[to].position);
            high = std::max(high, path[to].position);
        }
        const double at = y(rows[from]);
        if (std::floor(at) != line)
            filled = {low, low};
        else if (rows.back() > mostMoves && filled.from <= low && high <= filled.to)
            continue;
        line = std::floor(at);
        filled = {std::min(filled.from, low), std::max(filled.to, high)};
        painter.setPen(penOf(path[to - 1], palette));
        painter.drawLine(QPointF(x(low), at), QPointF(x(high), at));
    }
}

} // namespace

CycleView::CycleView(QWidget *parent)
    : QWidget(parent) {
    setMinimumSize(320, 180);
}

void CycleView::show(const CycleProgram &program, const Overtravel &over) {
    m_program = program;
    m_over = over;
    update();
}

void CycleView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    const std::vector<Move> path = cyclePath(m_program);
    if (path.empty())
        return;
    const auto ends = std::ranges::minmax(path, {}, &Move::position);
    const double lowest = ends.min.position;
    const double span = std::max(ends.max.position - lowest, 1e-9);
    const auto x = [&](double position) { return side + (position - lowest) / span * (width() - 2 * side); };
    const std::vector<double> rows = rowsOf(path);
    const double last = std::max(rows.back(), 1.0);
    const auto y = [&](double atRow) { return titleRoom + atRow / last * (height() - titleRoom - foot); };

    const double top = titleRoom - 6;
    const double bottom = height() - foot + 10;
    const auto mark = [&](double from, double to) { // beyond the end of the axis
        painter.fillRect(QRectF(QPointF(x(from), top), QPointF(x(to), bottom)),
                         QBrush(token(Token::bad, palette()), Qt::BDiagPattern));
    };
    if (m_over.below > 0)
        mark(lowest, lowest + m_over.below);
    if (m_over.above > 0)
        mark(ends.max.position - m_over.above, ends.max.position);
    painter.setFont(themeFont(TextSize::tiny));
    painter.setPen(QPen(token(Token::line, palette()), 1));
    for (const double target : m_program.targets)
        painter.drawLine(QPointF(x(target), top), QPointF(x(target), bottom));
    painter.setPen(token(Token::secondaryText, palette()));
    const Language &language = windowLanguage();
    const Quantity quantity = m_program.motion == Motion::linear ? Quantity::position : Quantity::angle;
    if (!m_program.targets.empty()) {
        const QRectF above(0, 2, width(), titleRoom - 10);
        painter.drawText(above.adjusted(side - 16, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         language.quantity(m_program.targets.front(), quantity, m_program.decimals));
        painter.drawText(above.adjusted(0, 0, -(side - 16), 0), Qt::AlignRight | Qt::AlignVCenter,
                         language.quantity(m_program.targets.back(), quantity, m_program.decimals));
    }
    drawAxis(painter, m_program, lowest, ends.max.position, bottom, palette(), x);
    if (path.size() > mostMoves)
        return drawRows(painter, path, rows, palette(), x, y);
    for (std::size_t i = 1; i < path.size(); ++i) {
        painter.setPen(penOf(path[i], palette()));
        painter.drawLine(QPointF(x(path[i - 1].position), y(rows[i - 1])),
                         QPointF(x(path[i].position), y(rows[i])));
    }
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (!path[i].stop)
            continue;
        const QPointF at(x(path[i].position), y(rows[i]));
        painter.setBrush(colourOf(path[i].stop->approach, palette()));
        // A triangle in the direction of motion, so that colour is not the only sign.
        const double tip =
            path[i].stop->approach == Direction::positive ? arrowRadius * 1.5 : -arrowRadius * 1.5;
        painter.drawPolygon(QPolygonF({at + QPointF(tip, 0), at + QPointF(-tip / 2, -arrowRadius * 1.2),
                                       at + QPointF(-tip / 2, arrowRadius * 1.2)}));
    }
}

} // namespace palmer::ui
