// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/planning/targetplan.h"

#include "kernel/evaluation/iso230_2/targetrules.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/numerics/angles.h"
#include "kernel/numerics/poweroften.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

namespace palmer {
namespace {

constexpr int mostDraws = 100; ///< of random parts; few plans need a second one

/// Uniform random numbers, identical on every platform, unlike the standard library's distributions.
class Uniform {
public:
    explicit Uniform(std::uint64_t seed)
        : m_generator(seed) {}

    /// Returns a number in [0, 1).
    double next() { return static_cast<double>(m_generator() >> 11U) * 0x1p-53; }

private:
    std::mt19937_64 m_generator;
};

/// Returns the travel that determines the number of targets, which may exceed the measured one.
double countedTravel(const TargetRequest &request) {
    if (request.zone)
        return std::max(request.travel, request.zone->to - request.zone->from);
    const double axis = request.axisTravel.value_or(0);
    return axis <= longestShort(request.motion) ? std::max(request.travel, axis) : request.travel;
}

/// True if the travel is a full turn, which ends where it begins.
bool isFullTurn(const TargetRequest &request) {
    return request.motion == Motion::rotary && std::abs(request.travel - fullTurn) < 1e-9;
}

/// Returns at most `mostTargets` + 1.
std::size_t numberOfTargets(const TargetRequest &request) {
    const double travel = countedTravel(request);
    double wanted = 0;
    if (request.motion == Motion::linear)
        wanted = std::max(iso230_2::fewestTargets, std::ceil(request.perMetre * travel / 1000 - 1e-9));
    else if (request.travel < fullTurn || isFullTurn(request))
        wanted = iso230_2::targetsWithinATurn(travel);
    else // 8 per turn, and the end
        wanted = std::ceil(iso230_2::targetsOfATurn * request.travel / fullTurn - 1e-9) + 1;
    return static_cast<std::size_t>(std::min(wanted, static_cast<double>(mostTargets + 1)));
}

/// Rounds to the resolution and keeps the result inside [low, high].
double rounded(double position, double low, double high, int decimals) {
    const double scale = powerOfTen(decimals);
    double steps = std::round(std::clamp(position, low, high) * scale);
    if (steps / scale > high)
        steps = std::floor(high * scale + 1e-9);
    if (steps / scale < low)
        steps = std::ceil(low * scale - 1e-9);
    return steps / scale;
}

/// True for whole pitches of 1988; false if the pitch exceeds the bound of 2006.
bool byPitches(const TargetRequest &request, const TargetPlan &plan) {
    return request.rule == TargetRule::pitches1988 && request.period && plan.randomPart == *request.period;
}

std::vector<double> drawnTargets(const TargetRequest &request, const TargetPlan &plan, std::size_t count,
                                 Uniform &uniform) {
    std::vector<double> targets;
    targets.reserve(count);
    const double last = request.from + request.travel;
    const bool pitches = byPitches(request, plan);
    for (std::size_t i = 0; i < count; ++i) {
        const double nominal = request.from + static_cast<double>(i) * *plan.interval;
        double position = nominal + 2 * uniform.next() * plan.randomPart;
        if (pitches) {
            // N whole pitches, at most as many as leave a whole pitch inside the travel
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

/// Returns the multiples of 90° inside the travel, and one random target in each part of it.
std::vector<double> drawnQuarterTurns(const TargetRequest &request, const TargetPlan &plan,
                                      Uniform &uniform) {
    const double last = request.from + request.travel;
    std::vector<double> targets;
    const double beyond = isFullTurn(request) ? last - 1e-9 : last + 1e-9;
    const double first = std::ceil(request.from / iso230_2::quarterTurn - 1e-9);
    for (int i = 0; (first + i) * iso230_2::quarterTurn <= beyond; ++i)
        targets.push_back(rounded((first + i) * iso230_2::quarterTurn, request.from, last, request.decimals));
    const double parts = std::round(request.travel / plan.randomPart);
    for (int i = 0; i < parts; ++i)
        targets.push_back(rounded(request.from + (i + uniform.next()) * plan.randomPart, request.from, last,
                                  request.decimals));
    std::ranges::sort(targets);
    return targets;
}

/// True if the targets are distinct and their positions meet the requirements of the edition.
bool isAsAskedFor(const TargetRequest &request, const TargetPlan &plan, std::span<const double> targets) {
    if (std::ranges::adjacent_find(targets, std::greater_equal<>()) != targets.end())
        return false;
    if (!plan.interval)
        return iso230_2::furtherTargets(targets) >= iso230_2::fewestFurther;
    if (request.rule == TargetRule::pitches1988)
        return iso230_2::spacedAsOf1988(targets, request.period) &&
               !(request.period && iso230_2::samePhase(targets, *request.period));
    return iso230_2::staysWithin(iso230_2::spreadAbout(targets, *plan.interval),
                                 iso230_2::boundOf2006(*plan.interval, request.period), *plan.interval) &&
           !(request.period ? iso230_2::stepsOfWholePeriods(targets, *request.period)
                            : iso230_2::evenlySpaced(targets));
}

/// Returns 1 per direction for a long axis, otherwise 5. If the axis travel is unknown, the axis counts as
/// long only if its targets span a long one whatever their random parts.
int approaches(const TargetRequest &request, const TargetPlan &plan) {
    if (!plan.interval || request.zone)
        return 5;
    // pitches: up to one before the first target, two after the last
    const double lost = (byPitches(request, plan) ? 3 : 4) * plan.randomPart;
    const double rounding = 2 * powerOfTen(-request.decimals);
    const double judged = std::max(request.axisTravel.value_or(0), request.travel - lost - rounding);
    return judged > longestShort(request.motion) ? 1 : 5;
}

/// Sets the nominal interval and the largest random part. The first target is at most two random parts after
/// the start of the travel, the last one at most two before its end.
void space(const TargetRequest &request, std::size_t count, TargetPlan &plan) {
    const auto steps = static_cast<double>(count - 1);
    if (request.rule == TargetRule::pitches1988 && request.period &&
        *request.period <= iso230_2::randomShare * request.travel / steps) {
        plan.interval = request.travel / steps;
        plan.randomPart = *request.period;
        return;
    }
    const bool turn = isFullTurn(request); // the step from the last target to the first counts, too
    const auto intervalFor = [&](double randomPart) {
        return turn ? request.travel / static_cast<double>(count) : (request.travel - 2 * randomPart) / steps;
    };
    const double share = iso230_2::randomShare;
    plan.interval = turn ? intervalFor(0) : request.travel / (steps + 2 * share);
    plan.randomPart = share * *plan.interval;
    for (const double part : {1.0, 0.5}) {
        const double randomPart = part * request.period.value_or(request.travel);
        if (randomPart > share * intervalFor(randomPart))
            continue;
        plan.interval = intervalFor(randomPart);
        plan.randomPart = randomPart;
        return;
    }
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
    const std::size_t count = numberOfTargets(request);
    if (count > mostTargets)
        return plan;
    const bool rule1988 = request.rule == TargetRule::pitches1988;
    if (rule1988 && request.motion == Motion::rotary) {
        const double parts = std::max(iso230_2::fewestFurther,
                                      std::ceil(iso230_2::fewestFurther * request.travel / fullTurn - 1e-9));
        plan.randomPart = request.travel / parts;
    } else {
        space(request, count, plan);
        plan.boundOf2006 = rule1988 && !byPitches(request, plan);
    }
    plan.runs = approaches(request, plan);
    Uniform uniform(request.seed);
    for (int draw = 0; draw < mostDraws; ++draw) {
        std::vector<double> targets = plan.interval ? drawnTargets(request, plan, count, uniform)
                                                    : drawnQuarterTurns(request, plan, uniform);
        if (isAsAskedFor(request, plan, targets)) {
            plan.targets = std::move(targets);
            break;
        }
    }
    return plan;
}

TargetRequest withinAxis(TargetRequest request, const Interval &ends, double approach) {
    const double length = ends.to - ends.from;
    const bool endless = request.motion == Motion::rotary && length >= fullTurn;
    const bool quarters = request.motion == Motion::rotary && request.rule == TargetRule::pitches1988;
    const double room = endless || quarters || length <= 2 * approach ? 0 : approach;
    request.from = ends.from + room;
    request.travel = length - 2 * room;
    request.axisTravel = length;
    request.axisRange.reset();
    if (quarters && !endless) {
        request.axisRange = Interval{ends.from - approach, ends.to + approach};
        request.axisTravel = length + 2 * approach;
    } else if (!endless) {
        request.axisRange = ends;
    }
    return request;
}

std::vector<PlannedMeasurement> planMeasurements(TargetRequest request, std::optional<Interval> zone) {
    zone = zone ? zone : request.zone;
    if (request.zone &&
        (request.from < request.zone->from || request.from + request.travel > request.zone->to))
        request.zone.reset();
    std::vector<PlannedMeasurement> result{{request, planTargets(request)}};
    if (result.front().plan.targets.empty())
        return {};
    if (result.front().plan.runs != 1)
        return result;
    const double scale = powerOfTen(request.decimals);
    const double length = longestShort(request.motion);
    const double middle = request.from + request.travel / 2;
    const double begin = std::round((middle - length / 2) * scale) / scale;
    TargetRequest full = request;
    full.zone = zone.value_or(Interval{begin, begin + length});
    full.from = std::max(full.zone->from, request.from);
    full.travel = std::min(full.zone->to, request.from + request.travel) - full.from;
    full.perMetre = std::max(request.perMetre, iso230_2::targetsOfAMetre);
    result.push_back({full, planTargets(full)});
    return result;
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
