// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/numerics/correlatednoise.h"

#include <Eigen/Core>

#include <cmath>

namespace palmer {

/// One column of the fit.
struct FitTerm {
    InfluenceId id = InfluenceId::centre;
    PlaneAxis axis = PlaneAxis::none;
    bool second = false;    ///< the second column of the influence
    double shape = 0;       ///< pitch or width
    std::size_t circle = 0; ///< for a centre: its circle
    int part = 0;           ///< 1 … 4: only what belongs to one of the reversals of the axis in one sense
};

/// True if a position belongs to the part of a term: for a spike to the reversal before it, otherwise to
/// the nearest one.
[[nodiscard]] inline bool isInPart(const FitTerm &term, const PathPosition &p) {
    const bool first = term.axis == PlaneAxis::first;
    const double side = term.id == InfluenceId::reversalSpike ? p.sense * (first ? p.sine : -p.cosine)
                        : first                               ? p.cosine
                                                              : p.sine;
    return term.part == 0 || term.part == 1 + (p.sense < 0 ? 1 : 0) + (side < 0 ? 2 : 0);
}

[[nodiscard]] inline double columnValue(const FitTerm &term, const PathPosition &position) {
    const Influence &row = influence(term.id);
    return isInPart(term, position) ? (term.second ? row.second : row.column)(position, term.axis, term.shape)
                                    : 0;
}

/// Returns the least squares centre of all arcs together, each with equal weight; null if there is none.
[[nodiscard]] std::optional<Point> centreOf(const DiagnosedCircle &circle);

/// An arc and the range of its rows. A row is the mean of `perRow` neighbouring points.
struct ArcRows {
    std::size_t circle = 0;
    std::size_t arc = 0;
    std::size_t perRow = 1;
    Record record;
};

/// Iterates over the points of an arc as fitted.
class ArcWalk {
public:
    ArcWalk(const DiagnosedCircle &circle, std::size_t arc, Point centre, double lagAngle, double pause,
            double rotation = 0);

    [[nodiscard]] std::size_t size() const { return m_arc.points.size(); }
    /// Returns the distance from the centre, mm, and sets the inputs of the columns.
    double at(std::size_t i, PathPosition &position) const {
        const double x = m_arc.points.x[i] - m_centre.x;
        const double y = m_arc.points.y[i] - m_centre.y;
        const double r = std::sqrt(x * x + y * y);
        const double cosine = r > 0 ? x / r : 1;
        const double sine = r > 0 ? y / r : 0;
        position = m_position;
        position.cosine = cosine * m_lagCosine + sine * m_lagSine;
        position.sine = sine * m_lagCosine - cosine * m_lagSine;
        position.turns = m_start + std::abs(m_arc.angles[i] - m_arc.angles.front()) / 360;
        return r;
    }

private:
    const DiagnosedArc &m_arc;
    Point m_centre;
    PathPosition m_position;
    double m_lagCosine = 1;
    double m_lagSine = 0;
    double m_start = 0;
};

/// The rows of a fit: all arcs of all circles, in order.
class PathRows {
public:
    /// `centres`: least squares centre of each circle. Points nearer to a reversal than `reach` (degrees,
    /// at least 0.1° and the angle of the largest deviation) are omitted. `lagAngle` is taken off commanded
    /// angles in the direction of travel, `rotation` off all; degrees.
    PathRows(std::span<const DiagnosedCircle> circles, std::span<const Point> centres, double lagAngle,
             double pause, double reach = 0.1, double rotation = 0);

    [[nodiscard]] Eigen::Index size() const { return m_deviations.size(); }
    [[nodiscard]] const std::vector<ArcRows> &arcs() const { return m_arcs; }
    [[nodiscard]] std::vector<Record> records() const;
    [[nodiscard]] std::size_t used() const;
    /// Returns distance − nominal radius; 0 in omitted rows.
    [[nodiscard]] const Eigen::VectorXd &deviations() const { return m_deviations; }
    /// True if a row is not omitted.
    [[nodiscard]] bool counts(Eigen::Index row) const { return m_weights[row] > 0; }
    /// Returns the middle of each row, including omitted ones.
    [[nodiscard]] const std::vector<PathPosition> &positions() const { return m_positions; }
    /// Returns the circle of a row.
    [[nodiscard]] std::size_t circleOf(Eigen::Index row) const;
    /// Returns the largest angle between consecutive rows, rad.
    [[nodiscard]] double step() const { return m_step; }

    /// Returns one column per term; 0 in omitted rows.
    [[nodiscard]] Eigen::MatrixXd columns(std::span<const FitTerm> terms) const;

private:
    /// A column while its means are computed.
    struct Column {
        const FitTerm *term = nullptr;
        Influence::Column value = nullptr;
        double *row = nullptr; ///< position of the next mean
        double sum = 0;
    };
    void addMeans(const ArcRows &arc, std::vector<Column> &columns) const;
    /// Returns the largest deviation from the mean distance of its arc, mm.
    [[nodiscard]] double largestDeviation(std::size_t circle) const;
    void fill(ArcRows &arc);
    [[nodiscard]] bool isReversal(const PathPosition &position, std::size_t circle) const;

    std::span<const DiagnosedCircle> m_circles;
    std::vector<Point> m_centres;
    double m_lagAngle;
    double m_pause;
    double m_rotation;
    std::vector<double>
        m_reversal; ///< per circle: points with a smaller sine of the angle from a reversal are omitted
    std::vector<ArcRows> m_arcs;
    Eigen::VectorXd m_deviations;
    Eigen::VectorXd m_weights; ///< 1 over the number of points used
    std::vector<PathPosition> m_positions;
    double m_step = 0;
};

} // namespace palmer
