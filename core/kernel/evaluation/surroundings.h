#pragma once

#include "kernel/measurement/machine.h"
#include "kernel/measurement/test.h"
#include "kernel/uncertainty/simulation.h"

#include <memory>
#include <vector>

namespace palmer {

/// What the evaluation of a test sees of the rest of its file. Owns nothing: valid as long as the document
/// is.
struct Surroundings {
    const Machine *machine = nullptr;
    std::vector<const Instrument *> instruments; ///< those the test names
    bool otherTestOfLongAxis =
        false; ///< whole travel and zone: the file holds the other one for the same axis
    std::optional<double> environmentalVariation; ///< range of the drift test the inputs name, mm or degrees
    std::shared_ptr<const Simulation> simulation; ///< that was run of the test; null: none
    bool simulationOutdated = false;              ///< the test was edited since
};

} // namespace palmer
