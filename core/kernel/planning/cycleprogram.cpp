// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/planning/cycleprogram.h"

#include "kernel/numerics/poweroften.h"

#include <algorithm>
#include <cmath>

namespace palmer {

CycleProgram programOf(const PlannedMeasurement &planned, CycleProgram program) {
    program.motion = planned.request.motion;
    program.decimals = planned.request.decimals;
    program.targets = planned.plan.targets;
    if (planned.request.zone)
        program.runs = std::max(program.runs, planned.plan.runs);
    return program;
}

double turningPoint(const CycleProgram &program, double target, Direction approach) {
    constexpr double noise = 1e-6; // in steps: 0.1 as a double is not a whole number of hundredths
    const double steps = powerOfTen(program.decimals);
    const double beyond = std::max(std::ceil(program.approach * steps - noise), 1.0);
    const double from = std::round(target * steps);
    return (approach == Direction::positive ? from - beyond : from + beyond) / steps;
}

std::vector<Move> cyclePath(const CycleProgram &program) {
    std::vector<Move> path;
    std::optional<Direction> direction;
    std::size_t target = program.targets.size();
    int run = -1;
    for (const Stop &stop : measuringCycle(program.targets.size(), program.runs, program.cycle)) {
        if (program.only && stop.approach != *program.only)
            continue;
        const double position = program.targets[stop.target];
        const bool newTarget = program.cycle == Cycle::step && stop.target != target;
        const bool isPassed = program.only && stop.run != run; // the axis stands at or beyond the target
        if (direction != stop.approach || newTarget || isPassed)
            path.push_back({turningPoint(program, position, stop.approach), {}});
        path.push_back({position, stop});
        direction = stop.approach;
        target = stop.target;
        run = stop.run;
    }
    return path;
}

Interval movedThrough(const CycleProgram &program) {
    CycleProgram start = program;
    start.runs = std::min(program.runs, 2); // all later ones are like the second
    const std::vector<Move> path = cyclePath(start);
    if (path.empty())
        return {};
    const auto [low, high] = std::ranges::minmax(path, {}, &Move::position);
    return {low.position, high.position};
}

Overtravel overtravelOf(const CycleProgram &program, const TargetRequest &request) {
    constexpr double turn = 360;
    constexpr double rounding = 1e-9;
    const auto over = [](double excess) { return excess > rounding ? excess : 0; };
    const Interval moved = movedThrough(program);
    if (request.axisRange)
        return {over(request.axisRange->from - moved.from), over(moved.to - request.axisRange->to)};
    const bool hasEnds =
        request.axisTravel && (request.motion == Motion::linear || *request.axisTravel < turn);
    return {0, hasEnds ? over(moved.to - moved.from - *request.axisTravel) : 0};
}

} // namespace palmer
