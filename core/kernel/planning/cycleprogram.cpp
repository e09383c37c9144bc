#include "kernel/planning/cycleprogram.h"

namespace palmer {

std::vector<Move> cyclePath(const CycleProgram &program) {
    std::vector<Move> path;
    std::optional<Direction> direction;
    std::size_t target = program.targets.size();
    for (const Stop &stop : measuringCycle(program.targets.size(), program.runs, program.cycle)) {
        const double position = program.targets[stop.target];
        const bool newTarget = program.cycle == Cycle::step && stop.target != target;
        if (direction != stop.approach || newTarget)
            path.push_back(
                {position + (stop.approach == Direction::positive ? -1 : 1) * program.approach, {}});
        path.push_back({position, stop});
        direction = stop.approach;
        target = stop.target;
    }
    return path;
}

} // namespace palmer
