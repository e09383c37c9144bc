// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/machine.h"
#include "kernel/measurement/test.h"
#include "kernel/uncertainty/simulation.h"

#include <memory>
#include <vector>

namespace palmer {

/// The statements that the certificate of an accredited laboratory needs: true if the head of the report
/// has them.
struct StatedHead {
    bool laboratoryAddress = false;
    bool number = false;
    bool issueDate = false;
    bool place = false;
    bool customer = false; ///< with its address
    bool authorised = false;

    bool operator==(const StatedHead &) const = default;
};

/// Parts of the file outside a test that its evaluation uses. Owns nothing: valid as long as the document.
struct Surroundings {
    const Machine *machine = nullptr;
    std::vector<const Instrument *> instruments; ///< those named by the test
    bool otherTestOfLongAxis =
        false; ///< whole travel and zone: the file has the other test for the same axis
    /// True if the file has another test of the same axis or plane under the same edition, perhaps before or
    /// after an adjustment.
    bool repeated = false;
    bool adjustmentsStated = false;           ///< in the report
    bool picturesReadable = true;             ///< logo and mark of the laboratory, if any
    std::optional<std::string> reportDate;    ///< YYYY-MM-DD, like the two below
    std::optional<std::string> performedFrom; ///< when the tests of the report were made
    std::optional<std::string> performedTo;
    std::optional<StatedHead> accredited; ///< null: the laboratory states no accreditation
    /// Largest range of the named drift test within the duration of the test, mm or degrees.
    std::optional<double> environmentalVariation;
    bool variationIsLowerBound = false;           ///< its record is shorter than the test or has a long gap
    std::shared_ptr<const Simulation> simulation; ///< run for the test; null: none
    bool simulationOutdated = false;              ///< the test was edited since
};

} // namespace palmer
