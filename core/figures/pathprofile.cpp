// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/pathprofile.h"

#include "kernel/numerics/fullturn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

/// Whether from … to and `visible` overlap in any turn.
bool overlaps(double from, double to, const Interval &visible) {
    const double turns = std::floor((visible.to - from) / fullTurn);
    return to + turns * fullTurn >= visible.from;
}

/// Steps of a profile one after the other, in the sense in which its angles advance.
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
                first = take(first, edge);
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

    /// Where the invisible part ends, as a whole number of steps.
    [[nodiscard]] double nextVisible(double edge) const {
        const double entry = m_towards > 0 ? m_visible->from : -m_visible->to;
        const double next = entry + std::ceil((edge - entry) / fullTurn) * fullTurn;
        return std::max(edge, std::floor(next / m_step) * m_step);
    }

    /// The first point behind `first` that reaches the edge.
    [[nodiscard]] std::size_t end(std::size_t first, double edge) const {
        const auto &angles = m_profile.angles;
        const auto before = [&](double angle) { return m_towards * angle < edge; };
        const auto begin = angles.begin() + static_cast<std::ptrdiff_t>(first);
        const auto found = m_profile.ordered ? std::partition_point(begin, angles.end(), before)
                                             : std::find_if_not(begin, angles.end(), before);
        return static_cast<std::size_t>(found - angles.begin());
    }

    /// Puts a step behind the trace; returns the first point of the next.
    std::size_t take(std::size_t first, double edge) {
        const auto &angles = m_profile.angles;
        const auto &deviations = m_profile.deviations;
        std::size_t least = first;
        std::size_t greatest = first;
        std::size_t next = first + 1;
        for (; next < angles.size() && m_towards * angles[next] < edge; ++next) {
            if (deviations[next] < deviations[least])
                least = next;
            if (deviations[next] > deviations[greatest])
                greatest = next;
        }
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
        const std::array kept{first, std::min(least, greatest), std::max(least, greatest), next - 1};
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
