#include "kernel/evaluation/iso230_2/parameters.h"

#include <cmath>
#include <limits>

namespace palmer::iso230_2 {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// The largest and the smallest of the values it is shown, and where they stand: the first on ties.
/// A NaN stays for good: a parameter that needs a missing statistic has no value.
class Extremes {
public:
    void add(double upper, double lower, std::size_t target, std::optional<Direction> approach) {
        const Ruling here{static_cast<int>(target) + 1, approach};
        if (!(upper <= m_upper)) {
            if (!(upper - m_upper <= tie * std::abs(upper)))
                m_highest = here;
            m_upper = std::isnan(m_upper) ? m_upper : upper;
        }
        if (!(lower >= m_lower)) {
            if (!(m_lower - lower <= tie * std::abs(lower)))
                m_lowest = here;
            m_lower = std::isnan(m_lower) ? m_lower : lower;
        }
    }
    [[nodiscard]] Outcome span() const {
        const double value = m_upper - m_lower;
        return std::isfinite(value) ? Outcome{value, {m_highest, m_lowest}} : Outcome{undefined, {}};
    }
    [[nodiscard]] Outcome highest() const {
        return std::isfinite(m_upper) ? Outcome{m_upper, {m_highest, std::nullopt}} : Outcome{undefined, {}};
    }

private:
    /// Values that are equal in decimals differ by rounding errors of their computation only.
    static constexpr double tie = 1e-12;

    double m_upper = -std::numeric_limits<double>::infinity();
    double m_lower = std::numeric_limits<double>::infinity();
    Ruling m_highest;
    Ruling m_lowest;
};

constexpr DirectionStatistics TargetStatistics::*statisticsOf(Direction direction) {
    return direction == Direction::positive ? &TargetStatistics::positive : &TargetStatistics::negative;
}

template <Direction... directions>
Outcome limitsSpan(Targets targets, double c) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto add = [&](const DirectionStatistics &d, Direction direction) {
            extremes.add(d.mean + c * d.s, d.mean - c * d.s, i, direction);
        };
        (add(targets[i].*statisticsOf(directions), directions), ...);
    }
    return extremes.span();
}

template <Direction... directions>
Outcome meansSpan(Targets targets) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto add = [&](const DirectionStatistics &d, Direction direction) {
            extremes.add(d.mean, d.mean, i, direction);
        };
        (add(targets[i].*statisticsOf(directions), directions), ...);
    }
    return extremes.span();
}

template <Direction direction>
Outcome largestRepeatability(Targets targets, double c) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double r = repeatability(targets[i].*statisticsOf(direction), c);
        extremes.add(r, r, i, direction);
    }
    return extremes.highest();
}

/// Mean over the targets of what `value` says of each; no ruling target.
template <typename Value>
Outcome meanOf(Targets targets, Value value) {
    double sum = 0;
    for (const TargetStatistics &target : targets)
        sum += value(target);
    return {targets.empty() ? undefined : sum / static_cast<double>(targets.size()), {}};
}

double scatter(const TargetStatistics &target, double c) {
    return c * (target.positive.s + target.negative.s);
}

} // namespace

Outcome accuracyUp(Targets targets, double c) {
    return limitsSpan<Direction::positive>(targets, c);
}
Outcome accuracyDown(Targets targets, double c) {
    return limitsSpan<Direction::negative>(targets, c);
}
Outcome accuracy(Targets targets, double c) {
    return limitsSpan<Direction::positive, Direction::negative>(targets, c);
}

Outcome systematicUp(Targets targets, double) {
    return meansSpan<Direction::positive>(targets);
}
Outcome systematicDown(Targets targets, double) {
    return meansSpan<Direction::negative>(targets);
}
Outcome systematic(Targets targets, double) {
    return meansSpan<Direction::positive, Direction::negative>(targets);
}

Outcome meanRange(Targets targets, double) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double mean = targets[i].mean();
        extremes.add(mean, mean, i, std::nullopt);
    }
    return extremes.span();
}

Outcome repeatabilityUp(Targets targets, double c) {
    return largestRepeatability<Direction::positive>(targets, c);
}
Outcome repeatabilityDown(Targets targets, double c) {
    return largestRepeatability<Direction::negative>(targets, c);
}

Outcome repeatabilityOfAxis(Targets targets, double c) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double r = repeatability(targets[i], c);
        extremes.add(r, r, i, std::nullopt);
    }
    return extremes.highest();
}

Outcome smallerRepeatability(Targets targets, double c) {
    const Outcome up = repeatabilityUp(targets, c);
    const Outcome down = repeatabilityDown(targets, c);
    if (std::isnan(up.value) || std::isnan(down.value))
        return {undefined, {}};
    return down.value < up.value ? down : up;
}

Outcome meanRepeatabilityUp(Targets targets, double c) {
    return meanOf(targets, [c](const TargetStatistics &target) { return repeatability(target.positive, c); });
}
Outcome meanRepeatabilityDown(Targets targets, double c) {
    return meanOf(targets, [c](const TargetStatistics &target) { return repeatability(target.negative, c); });
}
Outcome meanRepeatability(Targets targets, double c) {
    return meanOf(targets, [c](const TargetStatistics &target) { return repeatability(target, c); });
}

Outcome reversal(Targets targets, double) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double b = std::abs(targets[i].reversal());
        extremes.add(b, b, i, std::nullopt);
    }
    return extremes.highest();
}

Outcome meanReversal(Targets targets, double) {
    return meanOf(targets, [](const TargetStatistics &target) { return target.reversal(); });
}

Outcome vdiMeanReversal(Targets targets, double) {
    return meanOf(targets, [](const TargetStatistics &target) { return std::abs(target.reversal()); });
}

Outcome vdiScatter(Targets targets, double c) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double ps = scatter(targets[i], c);
        extremes.add(ps, ps, i, std::nullopt);
    }
    return extremes.highest();
}

Outcome vdiMeanScatter(Targets targets, double c) {
    return meanOf(targets, [c](const TargetStatistics &target) { return scatter(target, c); });
}

Outcome vdiUncertainty(Targets targets, double c) {
    Extremes extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double mean = targets[i].mean();
        const double half = (std::abs(targets[i].reversal()) + scatter(targets[i], c)) / 2;
        extremes.add(mean + half, mean - half, i, std::nullopt);
    }
    return extremes.span();
}

} // namespace palmer::iso230_2
