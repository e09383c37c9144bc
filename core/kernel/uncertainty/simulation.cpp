#include "kernel/uncertainty/simulation.h"

#include <algorithm>
#include <cmath>

namespace palmer {

bool SimulatedParameter::largeShift() const {
    return std::abs(shift()) > expanded() / 3;
}

const SimulatedParameter *Simulation::find(std::string_view id) const {
    const auto found = std::ranges::find(parameters, id, &SimulatedParameter::id);
    return found == parameters.end() ? nullptr : &*found;
}

} // namespace palmer
