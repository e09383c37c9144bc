// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/pathprofile.h"

#include "figures/extremes.h"
#include "kernel/numerics/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

/// True if from … to and `visible` overlap modulo full turns.
bool overlaps(double from, double to, const Interval &visible) {
    const double turns = std::floor((visible.to - from) / fullTurn);
    return to + turns * fullTurn >= visible.from;
}

/// Visits the steps of a profile in the direction in which its angles advance.
class Steps {
public:
    Steps(const PathProfile &profile, double step, std::optional<Interval> visible)
        : m_profile(profile)
        , m_step(step)
        , m_visible(visible)
        , m_towards(profile.angles.back() >= profile.angles.front() ? 1 : -1) {
        if (m_visible) {
            m_visible->from -= step;
            m_visible->to += step;
        }
    }

    std::vector<CircleTrace> traces() {
        std::size_t first = 0;
        while (first < m_profile.angles.size()) {
            const double edge = (std::floor(m_towards * m_profile.angles[first] / m_step) + 1) * m_step;
            if (isVisible(edge)) {
                first = appendStep(first, edge);
            } else {
                m_open = false;
                first = end(first, nextVisible(edge));
            }
        }
        return std::move(m_traces);
    }

private:
    [[nodiscard]] bool isVisible(double edge) const {
        if (!m_visible)
            return true;
        const auto [from, to] = std::minmax({m_towards * edge, m_towards * (edge - m_step)});
        return overlaps(from, to, *m_visible);
    }

    /// End of the invisible part, rounded to a whole number of steps.
    [[nodiscard]] double nextVisible(double edge) const {
        const double entry = m_towards > 0 ? m_visible->from : -m_visible->to;
        const double next = entry + std::ceil((edge - entry) / fullTurn) * fullTurn;
        return std::max(edge, std::floor(next / m_step) * m_step);
    }

    /// First point after `first` that reaches the edge. An ordered profile is searched by doubling and
    /// bisection: a few thousand angles out of 10⁶ points are read.
    [[nodiscard]] std::size_t end(std::size_t first, double edge) const {
        const auto &angles = m_profile.angles;
        const auto before = [&](double angle) { return m_towards * angle < edge; };
        const auto at = [&](std::size_t i) { return angles.begin() + static_cast<std::ptrdiff_t>(i); };
        if (!m_profile.ordered)
            return static_cast<std::size_t>(std::find_if_not(at(first), angles.end(), before) -
                                            angles.begin());
        std::size_t from = first;
        std::size_t further = 1;
        while (from + further < angles.size() && before(angles[from + further])) {
            from += further;
            further *= 2;
        }
        const std::size_t to = std::min(from + further, angles.size());
        return static_cast<std::size_t>(std::partition_point(at(from), at(to), before) - angles.begin());
    }

    /// Indices of the first least and first greatest deviation in first … next − 1, ascending.
    [[nodiscard]] std::array<std::size_t, 2> extremes(std::size_t first, std::size_t next) const {
        const double *const values = m_profile.deviations.data();
        const Interval range = extremesOf({values + first, values + next});
        const auto placeOf = [&](double value) {
            return static_cast<std::size_t>(std::find(values + first, values + next, value) - values);
        };
        const std::size_t low = placeOf(range.from);
        const std::size_t high = placeOf(range.to);
        return {std::min(low, high), std::max(low, high)};
    }

    /// Appends a step to the trace; returns the first point of the next.
    std::size_t appendStep(std::size_t first, double edge) {
        const std::size_t next = std::max(first + 1, end(first, edge));
        if (!m_open)
            m_traces.push_back(
                {m_profile.sense, m_profile.repetition, {}, m_profile.synthetic, m_profile.layer});
        m_open = true;
        std::vector<TracePoint> &points = m_traces.back().points;
        if (next - first <= 4) {
            for (std::size_t i = first; i < next; ++i)
                points.push_back(m_profile[i]);
            return next;
        }
        const auto [one, other] = extremes(first, next);
        const std::array kept{first, one, other, next - 1};
        for (std::size_t k = 0; k < kept.size(); ++k) {
            if (k == 0 || kept[k] != kept[k - 1])
                points.push_back(m_profile[kept[k]]);
        }
        return next;
    }

    const PathProfile &m_profile;
    double m_step;
    std::optional<Interval> m_visible;
    double m_towards;
    bool m_open = false;
    std::vector<CircleTrace> m_traces;
};

} // namespace

std::vector<CircleTrace> decimated(const PathProfile &profile, double step, std::optional<Interval> visible) {
    if (profile.angles.empty())
        return {};
    return Steps(profile, step, visible).traces();
}

} // namespace palmer
