// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace palmer::iso230_2 {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
/// Values equal as decimals differ only by rounding errors of the computation.
constexpr double rounding = 1e-12;

/// Largest and smallest of the values added, and their targets: the first on ties. A NaN persists: a
/// parameter that needs a missing statistic has no value.
template <class Value>
class Extremes;

template <>
class Extremes<double> {
public:
    void add(double upper, double lower, std::size_t target, std::optional<Direction> approach) {
        const Ruling here{static_cast<int>(target) + 1, approach};
        if (!(upper <= m_upper)) {
            if (!(upper - m_upper <= rounding * std::abs(upper)))
                m_highest = here;
            m_upper = std::isnan(m_upper) ? m_upper : upper;
        }
        if (!(lower >= m_lower)) {
            if (!(m_lower - lower <= rounding * std::abs(lower)))
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
    double m_upper = -std::numeric_limits<double>::infinity();
    double m_lower = std::numeric_limits<double>::infinity();
    Ruling m_highest;
    Ruling m_lowest;
};

/// For several tests at once: values only, which must exist.
template <>
class Extremes<Lanes> {
public:
    void add(const Lanes &upper, const Lanes &lower, std::size_t, std::optional<Direction>) {
        m_upper = larger(upper, m_upper);
        m_lower = smaller(lower, m_lower);
    }
    [[nodiscard]] Lanes span() const { return m_upper - m_lower; }
    [[nodiscard]] Lanes highest() const { return m_upper; }

private:
    Lanes m_upper = -std::numeric_limits<double>::infinity();
    Lanes m_lower = std::numeric_limits<double>::infinity();
};

/// Returns the direction that rules alone; null on ties, to rounding.
std::optional<Direction> directionThatRules(const TargetStatistics &target, double c) {
    const double up = repeatability(target.positive, c);
    const double down = repeatability(target.negative, c);
    const double larger = std::max(up, down);
    const double together = c * target.positive.s + c * target.negative.s + std::abs(target.reversal());
    if (!(larger - together > rounding * larger))
        return std::nullopt;
    return up > down ? Direction::positive : Direction::negative;
}

template <class Value>
using All = std::span<const TargetStatisticsOf<Value>>;

/// Outcome for double, otherwise the value only.
template <class Value>
using ResultOf = std::conditional_t<std::is_same_v<Value, double>, Outcome, Value>;

template <class Value>
constexpr DirectionStatisticsOf<Value> TargetStatisticsOf<Value>::*statisticsOf(Direction direction) {
    return direction == Direction::positive ? &TargetStatisticsOf<Value>::positive
                                            : &TargetStatisticsOf<Value>::negative;
}

template <Direction... directions>
constexpr auto limitsSpan = []<class Value>(All<Value> targets, double c) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto add = [&](const DirectionStatisticsOf<Value> &d, Direction direction) {
            const Value band = c * d.s;
            extremes.add(d.mean + band, d.mean - band, i, direction);
        };
        (add(targets[i].*statisticsOf<Value>(directions), directions), ...);
    }
    return extremes.span();
};

template <Direction... directions>
constexpr auto meansSpan = []<class Value>(All<Value> targets, double) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto add = [&](const DirectionStatisticsOf<Value> &d, Direction direction) {
            extremes.add(d.mean, d.mean, i, direction);
        };
        (add(targets[i].*statisticsOf<Value>(directions), directions), ...);
    }
    return extremes.span();
};

constexpr auto spanOfMeans = []<class Value>(All<Value> targets, double) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Value mean = targets[i].mean();
        extremes.add(mean, mean, i, std::nullopt);
    }
    return extremes.span();
};

template <Direction direction>
constexpr auto largestRepeatability = []<class Value>(All<Value> targets, double c) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Value r = repeatability(targets[i].*statisticsOf<Value>(direction), c);
        extremes.add(r, r, i, direction);
    }
    return extremes.highest();
};

/// The largest `value` of all targets.
template <auto value>
constexpr auto largestOf = []<class Value>(All<Value> targets, double c) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Value here = value(targets[i], c);
        extremes.add(here, here, i, std::nullopt);
    }
    return extremes.highest();
};

/// The mean `value` of all targets; no ruling target.
template <auto value>
constexpr auto meanOf = []<class Value>(All<Value> targets, double c) -> ResultOf<Value> {
    Value sum = 0;
    for (const TargetStatisticsOf<Value> &target : targets)
        sum += value(target, c);
    const Value mean = targets.empty() ? Value(undefined) : sum / static_cast<double>(targets.size());
    if constexpr (std::is_same_v<Value, double>)
        return {mean, {}};
    else
        return mean;
};

/// The largest R_i, and its direction if R_i↑ or R_i↓ alone exceeds the combination with the reversal value.
constexpr auto largestOfBoth = []<class Value>(All<Value> targets, double c) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Value here = repeatability(targets[i], c);
        std::optional<Direction> alone;
        if constexpr (std::is_same_v<Value, double>)
            alone = directionThatRules(targets[i], c);
        extremes.add(here, here, i, alone);
    }
    return extremes.highest();
};

constexpr auto repeatabilityHere = [](const auto &target, double c) { return repeatability(target, c); };
constexpr auto reversalHere = [](const auto &target, double) { return target.reversal(); };
constexpr auto sizeOfReversal = [](const auto &target, double) { return magnitude(target.reversal()); };
constexpr auto scatterHere = [](const auto &target, double c) {
    return c * (target.positive.s + target.negative.s);
};
template <Direction direction>
constexpr auto repeatabilityIn = []<class Value>(const TargetStatisticsOf<Value> &target, double c) {
    return repeatability(target.*statisticsOf<Value>(direction), c);
};

constexpr auto smallerOfBoth = []<class Value>(All<Value> targets, double c) -> ResultOf<Value> {
    const auto up = largestRepeatability<Direction::positive>(targets, c);
    const auto down = largestRepeatability<Direction::negative>(targets, c);
    if constexpr (std::is_same_v<Value, double>) {
        if (std::isnan(up.value) || std::isnan(down.value))
            return {undefined, {}};
        return down.value < up.value ? down : up;
    } else {
        return smaller(down, up);
    }
};

constexpr auto vdiSpan = []<class Value>(All<Value> targets, double c) {
    Extremes<Value> extremes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Value mean = targets[i].mean();
        const Value half = (sizeOfReversal(targets[i], c) + scatterHere(targets[i], c)) / 2;
        extremes.add(mean + half, mean - half, i, std::nullopt);
    }
    return extremes.span();
};

constexpr Direction up = Direction::positive;
constexpr Direction down = Direction::negative;

template <const auto &formula>
Outcome valueOf(std::span<const TargetStatistics> targets, double c) {
    return formula(targets, c);
}

template <const auto &formula>
Lanes inLanesOf(All<Lanes> targets, double c) {
    return formula(targets, c);
}

template <const auto &formula>
constexpr ParameterFormula formulaOf{valueOf<formula>, inLanesOf<formula>};

} // namespace

const ParameterFormula accuracyUp = formulaOf<limitsSpan<up>>;
const ParameterFormula accuracyDown = formulaOf<limitsSpan<down>>;
const ParameterFormula accuracy = formulaOf<limitsSpan<up, down>>;
const ParameterFormula systematicUp = formulaOf<meansSpan<up>>;
const ParameterFormula systematicDown = formulaOf<meansSpan<down>>;
const ParameterFormula systematic = formulaOf<meansSpan<up, down>>;
const ParameterFormula meanRange = formulaOf<spanOfMeans>;
const ParameterFormula repeatabilityUp = formulaOf<largestRepeatability<up>>;
const ParameterFormula repeatabilityDown = formulaOf<largestRepeatability<down>>;
const ParameterFormula repeatabilityOfAxis = formulaOf<largestOfBoth>;
const ParameterFormula smallerRepeatability = formulaOf<smallerOfBoth>;
const ParameterFormula meanRepeatabilityUp = formulaOf<meanOf<repeatabilityIn<up>>>;
const ParameterFormula meanRepeatabilityDown = formulaOf<meanOf<repeatabilityIn<down>>>;
const ParameterFormula meanRepeatability = formulaOf<meanOf<repeatabilityHere>>;
const ParameterFormula reversal = formulaOf<largestOf<sizeOfReversal>>;
const ParameterFormula meanReversal = formulaOf<meanOf<reversalHere>>;
const ParameterFormula vdiMeanReversal = formulaOf<meanOf<sizeOfReversal>>;
const ParameterFormula vdiScatter = formulaOf<largestOf<scatterHere>>;
const ParameterFormula vdiMeanScatter = formulaOf<meanOf<scatterHere>>;
const ParameterFormula vdiUncertainty = formulaOf<vdiSpan>;

} // namespace palmer::iso230_2
