// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/pathrows.h"

#include "kernel/numerics/angles.h"
#include "kernel/numerics/leastsquarescircle.h"

#include <algorithm>
#include <numbers>

namespace palmer {

namespace {

constexpr std::size_t mostRows = 7200; ///< per arc; one row then covers 0.05° of a circle

double extentInTurns(const DiagnosedArc &arc) {
    return arc.angles.empty() ? 0 : std::abs(arc.angles.back() - arc.angles.front()) / 360;
}

} // namespace

std::optional<Point> centreOf(const DiagnosedCircle &circle) {
    if (circle.centre)
        return circle.centre;
    Points all;
    std::vector<std::size_t> groups;
    for (const DiagnosedArc &arc : circle.arcs) {
        all.append(arc.points);
        groups.push_back(arc.points.size());
    }
    const LeastSquaresCircle fit = leastSquaresCircle(all.view(), {.groups = groups});
    return fit.valid() ? std::optional(fit.centre) : std::nullopt;
}

ArcWalk::ArcWalk(const DiagnosedCircle &circle, std::size_t arc, Point centre, double lagAngle, double pause,
                 double rotation)
    : m_arc(circle.arcs[arc])
    , m_centre(centre) {
    m_position.sense = m_arc.sense == Sense::counterclockwise ? 1 : -1;
    m_position.radius = circle.nominalRadius;
    m_position.feed = circle.feed.value_or(1);
    const double lag = (m_arc.commanded ? m_position.sense * lagAngle : 0) + rotation;
    m_lagCosine = std::cos(lag * degree);
    m_lagSine = std::sin(lag * degree);
    double whole = 0;
    for (std::size_t k = 0; k < circle.arcs.size(); ++k) {
        if (k == arc)
            m_start = whole;
        whole += extentInTurns(circle.arcs[k]) + (k + 1 < circle.arcs.size() ? pause : 0);
    }
    m_start -= whole / 2;
}

PathRows::PathRows(std::span<const DiagnosedCircle> circles, std::span<const Point> centres, double lagAngle,
                   double pause, double reach, double rotation)
    : m_circles(circles)
    , m_centres(centres.begin(), centres.end())
    , m_lagAngle(lagAngle)
    , m_pause(pause)
    , m_rotation(rotation) {
    std::size_t rows = 0;
    for (std::size_t k = 0; k < circles.size(); ++k) {
        const double angle = largestDeviation(k) / circles[k].nominalRadius;
        m_reversal.push_back(std::sin(std::clamp(angle, reach * degree, 5 * degree)));
        for (std::size_t a = 0; a < circles[k].arcs.size(); ++a) {
            const std::size_t n = circles[k].arcs[a].points.size();
            const std::size_t perRow = std::max<std::size_t>(1, (n + mostRows - 1) / mostRows);
            const std::size_t size = (n + perRow - 1) / perRow;
            m_arcs.push_back({k, a, perRow, {rows, size, 0}});
            rows += size;
            if (size > 1)
                m_step = std::max(m_step, extentInTurns(circles[k].arcs[a]) * 2 * std::numbers::pi /
                                              static_cast<double>(size - 1));
        }
    }
    m_deviations = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows));
    m_weights = m_deviations;
    m_positions.resize(rows);
    for (ArcRows &arc : m_arcs)
        fill(arc);
    m_deviations = m_deviations.cwiseProduct(m_weights);
}

double PathRows::largestDeviation(std::size_t circle) const {
    double largest = 0;
    for (std::size_t a = 0; a < m_circles[circle].arcs.size(); ++a) {
        const ArcWalk walk(m_circles[circle], a, m_centres[circle], m_lagAngle, m_pause, m_rotation);
        PathPosition position;
        double sum = 0;
        double low = 0;
        double high = 0;
        for (std::size_t i = 0; i < walk.size(); ++i) {
            const double r = walk.at(i, position) - m_circles[circle].nominalRadius;
            sum += r;
            low = i == 0 ? r : std::min(low, r);
            high = i == 0 ? r : std::max(high, r);
        }
        const double mean = walk.size() > 0 ? sum / static_cast<double>(walk.size()) : 0;
        largest = std::max({largest, high - mean, mean - low});
    }
    return largest;
}

void PathRows::fill(ArcRows &arc) {
    const ArcWalk walk(m_circles[arc.circle], arc.arc, m_centres[arc.circle], m_lagAngle, m_pause,
                       m_rotation);
    PathPosition position;
    for (std::size_t i = 0; i < walk.size(); ++i) {
        const double r = walk.at(i, position);
        const std::size_t row = arc.record.begin + i / arc.perRow;
        if (i % arc.perRow == arc.perRow / 2 || i + 1 == walk.size())
            m_positions[row] = position;
        if (isReversal(position, arc.circle))
            continue;
        m_deviations[Eigen::Index(row)] += r - m_circles[arc.circle].nominalRadius;
        m_weights[Eigen::Index(row)] += 1;
    }
    for (std::size_t i = 0; i < arc.record.size; ++i) {
        double &weight = m_weights[Eigen::Index(arc.record.begin + i)];
        if (weight > 0) {
            ++arc.record.used;
            weight = 1 / weight;
        }
    }
}

bool PathRows::isReversal(const PathPosition &position, std::size_t circle) const {
    return std::min(std::abs(position.cosine), std::abs(position.sine)) <= m_reversal[circle];
}

std::vector<Record> PathRows::records() const {
    std::vector<Record> result;
    for (const ArcRows &arc : m_arcs)
        result.push_back(arc.record);
    return result;
}

std::size_t PathRows::used() const {
    std::size_t result = 0;
    for (const ArcRows &arc : m_arcs)
        result += arc.record.used;
    return result;
}

std::size_t PathRows::circleOf(Eigen::Index row) const {
    const auto found = std::ranges::find_if(m_arcs, [row](const ArcRows &arc) {
        return static_cast<std::size_t>(row) < arc.record.begin + arc.record.size;
    });
    return found->circle;
}

Eigen::MatrixXd PathRows::columns(std::span<const FitTerm> terms) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size(), Eigen::Index(terms.size()));
    for (const ArcRows &arc : m_arcs) {
        std::vector<Column> columns;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            const FitTerm &term = terms[j];
            const Influence &row = influence(term.id);
            if (term.id != InfluenceId::centre || term.circle == arc.circle)
                columns.push_back({&term, term.second ? row.second : row.column,
                                   result.col(Eigen::Index(j)).data() + arc.record.begin});
        }
        addMeans(arc, columns);
    }
    return result;
}

void PathRows::addMeans(const ArcRows &arc, std::vector<Column> &columns) const {
    const ArcWalk walk(m_circles[arc.circle], arc.arc, m_centres[arc.circle], m_lagAngle, m_pause,
                       m_rotation);
    PathPosition position;
    for (std::size_t i = 0, row = arc.record.begin; i < walk.size(); ++row) {
        for (const std::size_t end = std::min(i + arc.perRow, walk.size()); i < end; ++i) {
            walk.at(i, position);
            if (isReversal(position, arc.circle))
                continue;
            for (Column &column : columns) {
                if (isInPart(*column.term, position))
                    column.sum += column.value(position, column.term->axis, column.term->shape);
            }
        }
        const double weight = m_weights[Eigen::Index(row)];
        for (Column &column : columns) {
            *column.row++ = column.sum * weight;
            column.sum = 0;
        }
    }
}

} // namespace palmer
