// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/plannedtest.h"

#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/numerics/poweroften.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <variant>

namespace palmer {

namespace {

/// Returns the travel to measure (see plannedFor), or null if unknown.
std::optional<Interval> travelOf(const PositioningMeasurement &measurement, double approach) {
    constexpr double turn = 360;
    std::optional<Interval> travel;
    if (measurement.axis.range)
        travel = Interval{measurement.axis.range->from + approach, measurement.axis.range->to - approach};
    else if (measurement.targets.size() > 1)
        travel = Interval{measurement.targets.front(),
                          measurement.targets.front() + measurementTravel(measurement)};
    else if (measurement.axis.travel)
        travel = Interval{approach, *measurement.axis.travel - approach};
    if (!travel || !(travel->to > travel->from))
        return std::nullopt;
    if (measurement.axis.motion == Motion::rotary && travel->to - travel->from > turn) {
        // A little more than a turn is for approaching the ends, not for measuring.
        const double from = travel->from <= 0 && travel->to >= turn ? 0 : travel->from;
        return Interval{from, from + turn};
    }
    return travel;
}

} // namespace

std::optional<double> statedInterval(const TargetPlan &plan) {
    constexpr double fineness = 1e6;
    return plan.interval ? std::optional(std::round(*plan.interval * fineness) / fineness) : std::nullopt;
}

Test plannedTest(const TargetRequest &request, const TargetPlan &plan, const CycleProgram &program,
                 const std::string &edition) {
    PositioningMeasurement measurement;
    measurement.axis.name = program.axis;
    measurement.axis.motion = request.motion;
    measurement.axis.travel = request.axisTravel;
    measurement.axis.range = request.axisRange;
    measurement.zone = request.zone;
    measurement.cycle = program.cycle;
    measurement.targets = plan.targets;
    measurement.targetChoice = {TargetChoiceKind::free, statedInterval(plan), request.period,
                                static_cast<long long>(request.seed)};
    for (int run = 0; run < program.runs; ++run) {
        for (const Direction direction : {Direction::positive, Direction::negative})
            measurement.runs.push_back(
                {direction, std::vector<std::optional<double>>(plan.targets.size(), std::nullopt)});
    }
    measurement.conditions.feed = program.feed;
    measurement.conditions.feedMode = program.feed ? FeedMode::programmed : FeedMode::rapid;
    measurement.conditions.dwell = program.dwell;
    measurement.conditions.approachDistance = program.approach;
    Test test;
    test.edition = edition;
    test.measurement = std::move(measurement);
    return test;
}

std::pair<TargetRequest, CycleProgram> plannedFor(const Test &test) {
    TargetRequest request;
    CycleProgram program;
    const auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
    if (!measurement)
        return {request, program};
    if (const Edition *edition = findEdition(test.edition))
        request.rule = edition->targetRule;
    request.motion = measurement->axis.motion;
    if (!measurement->axis.name.empty())
        program.axis = measurement->axis.name;
    if (measurement->conditions.approachDistance && *measurement->conditions.approachDistance > 0)
        program.approach = *measurement->conditions.approachDistance;
    if (const auto travel = travelOf(*measurement, program.approach)) {
        request.from = travel->from;
        request.travel = travel->to - travel->from;
    }
    request.axisTravel = measurement->axis.travel;
    request.axisRange = measurement->axis.range;
    if (measurement->zone && isLongAxis(*measurement)) {
        request.zone = measurement->zone;
        request.from = measurement->zone->from;
        request.travel = measurement->zone->to - measurement->zone->from;
    }
    request.period = measurement->targetChoice.period;
    request.seed = static_cast<std::uint64_t>(std::max(0LL, measurement->targetChoice.seed.value_or(1)));
    program.cycle = measurement->cycle.value_or(program.cycle);
    program.feed = measurement->conditions.feed;
    if (measurement->conditions.dwell && *measurement->conditions.dwell > 0)
        program.dwell = *measurement->conditions.dwell;
    return {request, program};
}

std::optional<PlanOfTest> planOf(const Test &test) {
    const auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
    if (!measurement || measurement->targets.empty())
        return std::nullopt;
    PlanOfTest result;
    TargetRequest &request = result.planned.request;
    TargetPlan &plan = result.planned.plan;
    std::tie(request, result.program) = plannedFor(test);
    plan.targets = measurement->targets;
    plan.interval = measurement->targetChoice.interval;
    plan.ofTest = true;
    request.from = plan.targets.front();
    request.travel = plan.targets.back() - request.from;
    constexpr int mostDecimals = 9;
    const auto isExact = [&request](double target) {
        const double steps = target * powerOfTen(request.decimals);
        constexpr double noise = 1e-5; // of a step
        return std::abs(steps - std::round(steps)) < noise;
    };
    while (request.decimals < mostDecimals && !std::ranges::all_of(plan.targets, isExact))
        ++request.decimals;
    const auto runs = [&](Direction direction) {
        return static_cast<int>(std::ranges::count(measurement->runs, direction, &Run::approach));
    };
    const int up = runs(Direction::positive);
    const int down = runs(Direction::negative);
    if (up + down > 0) {
        plan.runs = std::max(up, down);
        if (up == 0 || down == 0)
            result.program.only = up == 0 ? Direction::negative : Direction::positive;
    }
    result.program.runs = plan.runs;
    result.program = programOf(result.planned, result.program);
    return result;
}

} // namespace palmer
