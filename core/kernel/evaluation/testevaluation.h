#pragma once

#include "kernel/evaluation/drift.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"
#include "kernel/evaluation/statistics.h"

#include <optional>
#include <variant>
#include <vector>

namespace palmer {

/// What a positioning test yields besides its parameters. Deviations in mm, rotary: degrees.
struct PositioningResults {
    std::vector<TargetStatistics> targets; ///< by index of the target; NaN where undefined
    bool upward = false;                   ///< the test has runs in the positive direction
    bool downward = false;
    int positiveRuns = 0;
    int negativeRuns = 0;
    DeviationMethod standardDeviation = DeviationMethod::calculation; ///< the one that was used
    std::vector<double> corrections; ///< added to each target's deviations (mm); empty: no correction here
    bool notCorrected = false;       ///< away from 20 °C and not corrected: E, A, M say so
    std::optional<DriftStatistic> drift;
    bool judgedAsZone = false;       ///< a zone test of a long axis, judged as a short one
    bool stepCycleNotAgreed = false; ///< the title says: not an acceptance result under the edition
};

/// Results of a circular test; filled by the evaluation of circles.
struct CircularResults {};

/// A drift test: E_VE = max − min of its deviations.
struct DriftResults {
    std::optional<double> range; ///< mm, rotary: degrees; null without readings
};

/// The evaluation of one test; total: any measurement gives one, what is missing is a finding.
struct TestEvaluation {
    const Edition *edition = nullptr; ///< null for drift tests
    bool view = false;                ///< under another edition than the file's: no verdicts
    std::vector<Parameter> parameters;
    std::vector<Finding> findings;
    std::optional<Verdict> verdict; ///< the worst of the parameters; null without a limit
    std::variant<PositioningResults, CircularResults, DriftResults> results;

    /// No requirement is unmet.
    [[nodiscard]] bool inAccordance() const;
};

} // namespace palmer
