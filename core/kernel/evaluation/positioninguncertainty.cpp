// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/positioninguncertainty.h"

#include "kernel/evaluation/decideuncertainty.h"
#include "kernel/evaluation/iso230_2/parameters.h"
#include "kernel/numerics/normalquantile.h"
#include "kernel/uncertainty/coefficients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palmer {

namespace {

using Targets = std::span<const TargetStatistics>;

const Row *rowOf(const TestEvaluation &evaluation, const Parameter &p) {
    const auto row = std::ranges::find_if(
        evaluation.edition->rows, [&](const Row &r) { return std::string_view(r.term.id) == p.term.id; });
    return row == evaluation.edition->rows.end() ? nullptr : &*row;
}

const TargetStatistics &targetOf(const Ruling &ruling, Targets targets) {
    return targets[static_cast<std::size_t>(ruling.target) - 1];
}

/// For a mean over the targets, on the safe side: the target with the largest uncertainty, as if it ruled
/// alone, in the directions used by the parameter.
Rulers leastCertain(const Row &row, const Coefficients &coefficients, Targets targets, double c) {
    Rulers result;
    double most = -1;
    for (const TargetStatistics &target : targets) {
        const int up = (row.needs & upward) != 0 ? target.positive.n : target.negative.n;
        const int down = (row.needs & downward) != 0 ? target.negative.n : target.positive.n;
        const Rulers here{{up, down, {}}, {up, down, {}}, false};
        if (const double factor = coefficients.ofEnvironment(here, c); factor > most) {
            most = factor;
            result = here;
        }
    }
    return result;
}

/// Returns the direction that determines R_i; null: both together with B_i.
std::optional<Direction> rulingDirection(const TargetStatistics &target, double c) {
    const double up = repeatability(target.positive, c);
    const double down = repeatability(target.negative, c);
    if (std::max(up, down) < c * target.positive.s + c * target.negative.s + std::abs(target.reversal()))
        return std::nullopt;
    return up >= down ? Direction::positive : Direction::negative;
}

/// Returns the direction of the larger (or smaller) mean of a target.
Direction directionOfMean(const TargetStatistics &target, bool larger) {
    return (target.positive.mean >= target.negative.mean) == larger ? Direction::positive
                                                                    : Direction::negative;
}

Rulers rulersOf(const Parameter &p, const Row &row, const Coefficients &coefficients, Targets targets,
                double c) {
    const auto &[first, second] = p.ruling;
    if (!first)
        return leastCertain(row, coefficients, targets, c);
    const auto end = [&](const Ruling &ruling) {
        const TargetStatistics &target = targetOf(ruling, targets);
        return RulingReadings{target.positive.n, target.negative.n, ruling.approach};
    };
    const Ruling &other = second.value_or(*first);
    Rulers result{end(*first), end(other), first->target == other.target};
    if (row.value == &iso230_2::repeatabilityOfAxis && !result.upper.approach)
        result.upper.approach = rulingDirection(targetOf(*first, targets), c);
    if (row.value == &iso230_2::vdiUncertainty) {
        result.upper.approach = directionOfMean(targetOf(*first, targets), true);
        result.lower.approach = directionOfMean(targetOf(other, targets), false);
    }
    return result;
}

/// A parameter of readings tilted by t at the distance L from the first target: s is unchanged.
class Tilted {
public:
    Tilted(const PositioningMeasurement &measurement, double length, Targets targets)
        : m_measurement(measurement)
        , m_length(length)
        , m_targets(targets)
        , m_tilted(targets.begin(), targets.end()) {}

    double value(const Row &row, double t, double c) {
        for (std::size_t i = 0; i < m_tilted.size(); ++i) {
            const double part = t * (m_measurement.targets[i] - m_measurement.targets.front()) / m_length;
            m_tilted[i].positive.mean = m_targets[i].positive.mean + part;
            m_tilted[i].negative.mean = m_targets[i].negative.mean + part;
        }
        return (*row.value)(m_tilted, c).value;
    }

private:
    const PositioningMeasurement &m_measurement;
    double m_length;
    Targets m_targets;
    std::vector<TargetStatistics> m_tilted;
};

/// Returns half of the shortest interval that contains 95.45 % of a parameter whose readings are tilted by S
/// only: normally distributed (S is 2 standard deviations) or uniformly.
double halfIntervalOfTilts(Tilted &tilted, const Row &row, double systematic, double c, bool normal) {
    constexpr int count = 200;
    const double deviation = systematic / 2;
    std::vector<double> values;
    for (int k = 0; k < count; ++k) {
        const double place = (k + 0.5) / count;
        const double t = normal ? normalQuantile(place) : std::sqrt(3.0) * (2 * place - 1);
        values.push_back(tilted.value(row, deviation * t, c));
    }
    std::ranges::sort(values);
    const auto held = static_cast<std::size_t>(std::ceil(coverageProbability * count));
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + held <= values.size(); ++k)
        shortest = std::min(shortest, values[k + held - 1] - values[k]);
    return shortest / 2;
}

/// The part of S that grows with the length, and the square of the rest.
struct Systematic {
    double growing = 0;
    double restSquared = 0;
};

Systematic partsOf(const PositioningBudget &budget, double systematic) {
    const Contribution *device = budget.find(deviceId);
    const double whole = device ? device->expanded.value_or(0) : 0;
    const double growing = std::max(0.0, whole - budget.fixedDevice);
    const double others = systematic * systematic - whole * whole;
    Systematic result;
    result.growing = std::sqrt(std::max(0.0, others + growing * growing));
    result.restSquared = std::max(0.0, whole * whole - growing * growing);
    return result;
}

/// Returns the factor by which the drift of a simulation widens the scatter of the readings at a ruling
/// target and direction; 1: not at all.
double widening(const Parameter &p, const Row &row, const PositioningBudget &budget,
                const PositioningMeasurement &measurement, Targets targets) {
    constexpr double twelve = 12; // variance of a uniform distribution
    if ((row.needs & scatter) == 0 || measurement.uncertainty.driftModel == DriftModel::linear)
        return 1;
    const double range = budget.environmental().value_or(0) / rectangularFactor;
    double widest = 1;
    const auto look = [&](const DirectionStatistics &d) {
        if (!std::isfinite(d.s) || range == 0)
            return;
        const double wide = std::sqrt(d.s * d.s + range * range / twelve);
        widest = std::max(widest, d.s > 0 ? wide / d.s : std::numeric_limits<double>::infinity());
    };
    for (const auto &ruling : p.ruling) {
        if (!ruling)
            continue;
        const TargetStatistics &target = targetOf(*ruling, targets);
        if (ruling->approach != Direction::negative)
            look(target.positive);
        if (ruling->approach != Direction::positive)
            look(target.negative);
    }
    return widest;
}

/// True if the parameter falls by no more than `uncertainty` without its ruling targets: another target may
/// then rule from trial to trial.
bool othersComeClose(const Parameter &p, const Row &row, Targets targets, double c, double uncertainty) {
    std::vector<TargetStatistics> others;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const bool rules = std::ranges::any_of(p.ruling, [&](const std::optional<Ruling> &ruling) {
            return ruling && static_cast<std::size_t>(ruling->target) == i + 1;
        });
        if (!rules)
            others.push_back(targets[i]);
    }
    const double without = (*row.value)(others, c).value;
    return std::isfinite(without) && *p.value - without <= uncertainty;
}

/// Returns the reason if errors that tilt the readings explain the difference, otherwise null. `environment`:
/// U without S.
std::optional<Text> reasonOfTilt(const Parameter &p, const Row &row, Tilted &tilted, double systematic,
                                 double environment, double c, bool fixedPart) {
    const SimulatedParameter &simulated = *p.simulated;
    const double all =
        std::max(tilted.value(row, systematic, c), tilted.value(row, -systematic, c)) - *p.value;
    const double followed = std::hypot(all, environment);
    if (fixedPart &&
        (methodsAgree(simulated.expanded(), followed) || methodsAgree(2 * simulated.u, followed)))
        return REPORT_TEXT(
            "report", "%1: budget and Monte Carlo differ by more than 20 %: the simulation lets the fixed "
                      "part of the instrument's uncertainty grow with the length, the budget counts it in "
                      "full.");
    for (const bool normal : {true, false}) {
        const double half = halfIntervalOfTilts(tilted, row, systematic, c, normal);
        if (methodsAgree(simulated.expanded(), std::hypot(half, environment)))
            return REPORT_TEXT("report", "%1: budget and Monte Carlo differ by more than 20 %: readings that "
                                         "the errors tilt one way or the other move the governing targets, "
                                         "which the budget does not follow.");
    }
    return std::nullopt;
}

} // namespace

void addPositioningBudget(TestEvaluation &evaluation, const PositioningMeasurement &measurement,
                          const PositioningBudget &budget, Targets targets) {
    UncertaintyEvaluation &uncertainty = evaluation.uncertainty;
    uncertainty.contributions = budget.contributions;
    uncertainty.length = budget.length;
    uncertainty.systematic = budget.systematic();
    const auto environmental = budget.environmental();
    if (!uncertainty.systematic || !environmental)
        return;
    uncertainty.complete = true;
    const double c = evaluation.edition->c;
    const Systematic parts = partsOf(budget, *uncertainty.systematic);
    const double length = budget.length.value_or(0);
    Tilted tilted(measurement, length, targets);
    for (Parameter &p : evaluation.parameters) {
        const Row *row = rowOf(evaluation, p);
        const Coefficients *coefficients = palmer::coefficients(p.term.id);
        if (!p.value || !coefficients || !row)
            continue;
        const Rulers rulers = rulersOf(p, *row, *coefficients, targets, c);
        p.budgetUncertainty = combined(*coefficients, *uncertainty.systematic, *environmental, rulers, c);
        if (!coefficients->systematic || !p.budgetUncertainty)
            continue;
        double carried = 0;
        if (parts.growing > 0 && length > 0) {
            const double largest =
                std::max(tilted.value(*row, parts.growing, c), tilted.value(*row, -parts.growing, c));
            carried = std::max(0.0, largest - *p.value);
        }
        p.effectiveSystematic = std::sqrt(carried * carried + parts.restSquared);
        p.actualUncertainty = combined(*coefficients, *p.effectiveSystematic, *environmental, rulers, c);
    }
}

Message reasonOfDifference(const Parameter &p, const TestEvaluation &evaluation,
                           const PositioningMeasurement &measurement, const PositioningBudget &budget,
                           Targets targets) {
    const Row *row = rowOf(evaluation, p);
    const SimulatedParameter &simulated = *p.simulated;
    const double byBudget = *p.budgetUncertainty;
    const double c = evaluation.edition->c;
    const Number length{budget.length.value_or(0),
                        measurement.axis.motion == Motion::linear ? Quantity::position : Quantity::angle};
    const auto position = [&](const Ruling &ruling) {
        return measurement.targets[static_cast<std::size_t>(ruling.target) - 1];
    };
    const bool close = p.actualUncertainty && p.ruling[0] && p.ruling[1] && budget.length &&
                       *p.actualUncertainty < byBudget &&
                       std::abs(position(*p.ruling[0]) - position(*p.ruling[1])) < *budget.length;
    if (close && methodsAgree(simulated.expanded(), *p.actualUncertainty))
        return {REPORT_TEXT("report",
                            "%1: budget and Monte Carlo differ by more than 20 %: the ruling targets "
                            "lie closer together than the length L = %2 of the budget."),
                {length}};
    const double ofMean = byBudget / std::sqrt(static_cast<double>(std::max<std::size_t>(targets.size(), 1)));
    if (!p.ruling[0] && simulated.expanded() < byBudget && methodsAgree(simulated.expanded(), ofMean))
        return {REPORT_TEXT("report",
                            "%1: budget and Monte Carlo differ by more than 20 %: the mean over all targets "
                            "is less uncertain than the single target used in the budget.")};
    const double asNormal = 2 * simulated.u;
    if (methodsAgree(asNormal, byBudget))
        return {notNormallyDistributed};
    if (close && methodsAgree(asNormal, *p.actualUncertainty))
        return {REPORT_TEXT("report",
                            "%1: budget and Monte Carlo differ by more than 20 %: the ruling targets lie "
                            "closer together than the length L = %2 of the budget, and the results of the "
                            "trials are not normally distributed."),
                {length}};
    const double systematic = p.effectiveSystematic ? evaluation.uncertainty.systematic.value_or(0) : 0;
    const double environment = std::sqrt(std::max(0.0, byBudget * byBudget - systematic * systematic));
    if (row && systematic > 0 && budget.length.value_or(0) > 0) {
        Tilted tilted(measurement, *budget.length, targets);
        if (const auto reason =
                reasonOfTilt(p, *row, tilted, systematic, environment, c, budget.fixedDevice > 0))
            return {*reason};
    }
    if (environment > systematic && row &&
        widening(p, *row, budget, measurement, targets) > 1 + agreementOfMethods)
        return {REPORT_TEXT("report",
                            "%1: budget and Monte Carlo differ by more than 20 %: the drift that the "
                            "simulation adds to the readings widens the s of the ruling targets by more than "
                            "20 %.")};
    if (environment > systematic && row && p.ruling[0] && othersComeClose(p, *row, targets, c, byBudget))
        return {REPORT_TEXT(
            "report", "%1: budget and Monte Carlo differ by more than 20 %: other targets come within U "
                      "of those that rule; from trial to trial another one rules.")};
    return {noKnownReason};
}

} // namespace palmer
