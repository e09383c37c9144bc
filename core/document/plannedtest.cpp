// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/plannedtest.h"

namespace palmer {

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
    measurement.targetChoice = {TargetChoiceKind::free, plan.interval, request.period,
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

} // namespace palmer
