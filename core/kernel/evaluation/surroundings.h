// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
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
    /// The file holds another test of the same axis or plane under the same edition: before and after an
    /// adjustment, for anything that is known.
    bool repeated = false;
    bool adjustmentsStated = false;           ///< of the report
    bool picturesReadable = true;             ///< logo and mark of the laboratory, where there are any
    std::optional<std::string> reportDate;    ///< YYYY-MM-DD, as the two below
    std::optional<std::string> performedFrom; ///< when the tests of the report were made
    std::optional<std::string> performedTo;
    std::optional<double> environmentalVariation; ///< range of the drift test the inputs name, mm or degrees
    std::shared_ptr<const Simulation> simulation; ///< that was run of the test; null: none
    bool simulationOutdated = false;              ///< the test was edited since
};

} // namespace palmer
