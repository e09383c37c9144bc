// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/planning/targetplan.h"

#include "kernel/evaluation/iso230_2/targetcount.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/numerics/fullturn.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>

namespace palmer {
namespace {

constexpr double largestShare = 0.3; ///< of the interval: where the period is unknown
constexpr double quarterTurn = 90;
constexpr std::size_t freeTargetsOf1988 = 3;

/// Uniform numbers that are the same everywhere: the standard library's distributions are not.
class Uniform {
public:
    explicit Uniform(std::uint64_t seed)
        : m_generator(seed) {}

    /// In [0, 1).
    double next() { return static_cast<double>(m_generator() >> 11U) * 0x1p-53; }

private:
    std::mt19937_64 m_generator;
};

/// No more than `mostTargets` and one.
std::size_t numberOfTargets(const TargetRequest &request) {
    double wanted = 0;
    if (request.motion == Motion::linear)
        wanted =
            std::max(iso230_2::fewestTargets, std::ceil(request.perMetre * request.travel / 1000 - 1e-9));
    else if (request.travel < fullTurn)
        wanted = iso230_2::targetsWithinATurn(request.travel);
    else // 8 a turn and the end
        wanted = std::ceil(iso230_2::targetsOfATurn * request.travel / fullTurn - 1e-9) + 1;
    return static_cast<std::size_t>(std::min(wanted, static_cast<double>(mostTargets + 1)));
}

/// Rounded to the resolution, and inside [low, high].
double rounded(double position, double low, double high, int decimals) {
    const double scale = std::pow(10.0, decimals);
    double steps = std::round(std::clamp(position, low, high) * scale);
    if (steps / scale > high)
        steps = std::floor(high * scale + 1e-9);
    if (steps / scale < low)
        steps = std::ceil(low * scale - 1e-9);
    return steps / scale;
}

std::vector<double> freeTargets(const TargetRequest &request, TargetPlan &plan, std::size_t count) {
    Uniform uniform(request.seed);
    std::vector<double> targets;
    const double last = request.from + request.travel;
    const bool pitches = request.rule == TargetRule::pitches1988 && request.period.has_value();
    const double bound =
        std::min(request.period.value_or(largestShare * plan.interval), largestShare * plan.interval);
    plan.randomPart = bound;
    plan.boundOf2006 = request.rule == TargetRule::pitches1988 && !(pitches && bound == *request.period);
    for (std::size_t i = 0; i < count; ++i) {
        const double nominal = request.from + static_cast<double>(i) * plan.interval;
        double position = nominal + (2 * uniform.next() - 1) * bound;
        if (pitches && bound == *request.period) {
            // N whole pitches, the last of them that ends inside the travel
            const double pitch = *request.period;
            const double most = std::floor(request.travel / pitch + 1e-9) - 1;
            const double whole =
                std::clamp(std::floor((nominal - request.from) / pitch + 1e-9), 0.0, std::max(0.0, most));
            position = request.from + (whole + uniform.next()) * pitch;
        }
        targets.push_back(rounded(position, request.from, last, request.decimals));
    }
    return targets;
}

/// 1988: 0°, 90°, 180°, 270° as far as they are inside, and three more.
std::vector<double> quarterTurns(const TargetRequest &request, TargetPlan &plan) {
    Uniform uniform(request.seed);
    const double last = request.from + request.travel;
    std::vector<double> targets;
    const double beyond = request.travel >= fullTurn ? last - 1e-9 : last + 1e-9; // 360° is 0° again
    const double first = std::ceil(request.from / quarterTurn - 1e-9);
    for (int i = 0; (first + i) * quarterTurn <= beyond; ++i)
        targets.push_back(rounded((first + i) * quarterTurn, request.from, last, request.decimals));
    for (std::size_t i = 0; i < freeTargetsOf1988; ++i) {
        // each in its own third, so that they are spread
        const double third = request.travel / static_cast<double>(freeTargetsOf1988);
        const double position = request.from + (static_cast<double>(i) + uniform.next()) * third;
        targets.push_back(rounded(position, request.from, last, request.decimals));
    }
    plan.randomPart = request.travel / static_cast<double>(freeTargetsOf1988);
    std::ranges::sort(targets);
    return targets;
}

} // namespace

TargetPlan planTargets(const TargetRequest &request) {
    TargetPlan plan;
    const bool sound = std::isfinite(request.from) && std::isfinite(request.travel) && request.travel > 0 &&
                       std::isfinite(request.perMetre) && request.perMetre > 0 && request.decimals >= 0 &&
                       request.decimals <= 9 &&
                       (!request.period || (std::isfinite(*request.period) && *request.period > 0));
    if (!sound)
        return plan;
    const bool linear = request.motion == Motion::linear;
    plan.runs = request.travel > longestShort(request.motion) ? 1 : 5;
    const std::size_t count = numberOfTargets(request);
    if (count > mostTargets)
        return plan;
    plan.interval = request.travel / static_cast<double>(count - 1);
    const bool byQuarters = !linear && request.rule == TargetRule::pitches1988 && request.travel <= fullTurn;
    std::vector<double> targets =
        byQuarters ? quarterTurns(request, plan) : freeTargets(request, plan, count);
    if (byQuarters)
        targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    if (std::ranges::adjacent_find(targets, std::greater_equal<>()) == targets.end())
        plan.targets = std::move(targets);
    return plan;
}

std::vector<Stop> measuringCycle(std::size_t targets, int runs, Cycle cycle) {
    std::vector<Stop> stops;
    stops.reserve(2 * targets * static_cast<std::size_t>(std::max(runs, 0)));
    if (cycle == Cycle::step) {
        for (std::size_t target = 0; target < targets; ++target) {
            for (int run = 0; run < runs; ++run) {
                stops.push_back({target, run, Direction::positive});
                stops.push_back({target, run, Direction::negative});
            }
        }
        return stops;
    }
    for (int run = 0; run < runs; ++run) {
        for (std::size_t i = 0; i < targets; ++i)
            stops.push_back({i, run, Direction::positive});
        for (std::size_t i = targets; i-- > 0;)
            stops.push_back({i, run, Direction::negative});
    }
    return stops;
}

} // namespace palmer
