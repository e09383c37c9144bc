// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/accordance.h"
#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/drift.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"
#include "kernel/evaluation/statistics.h"

#include "kernel/measurement/circular.h"
#include "kernel/numerics/points.h"
#include "kernel/uncertainty/contribution.h"
#include "kernel/uncertainty/simulation.h"

#include <memory>
#include <optional>
#include <string>
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
    At20 at20 = At20::hold;          ///< of lengths: E, A, M say so
    std::optional<DriftStatistic> drift;
    bool judgedAsZone = false;       ///< a zone test of a long axis, judged as a short one
    bool countByPractice = false;    ///< number of targets and approaches: not of a short linear axis
    bool stepCycleAgreed = false;    ///< in writing, where the edition asks for that
    bool stepCycleNotAgreed = false; ///< the title says: not an acceptance result under the edition
};

/// The evaluated part of an arc. Points in mm about the programmed centre; of commanded angles rebuilt from
/// the centring error of the test (kernel/numerics/centringerror.h).
struct EvaluatedPath {
    std::size_t arc = 0; ///< index in the measurement
    Sense sense = Sense::counterclockwise;
    std::string index;  ///< "XY": axes in the order in which the path crosses their positive ends
    Interval evaluated; ///< unwrapped degrees
    double extent = 0;  ///< degrees; 360 for a full circle
    /// The step that closes it is at most twice its largest inner step, and its holes, steps above four times
    /// the median step, the closing one among them, make up at most 90°.
    bool fullCircle = false;
    Points points;        ///< evaluated points
    std::vector<std::size_t> source; ///< of each point: its index in the arc; rising
};

enum class CircleOf { both, counterclockwise, clockwise };

/// A reference circle. Centre in mm relative to the programmed centre.
struct CircleResult {
    CircleOf of = CircleOf::both;
    ReferenceCircle kind = ReferenceCircle::minimumZone;
    Point centre;
    double radius = 0;             ///< of minimum zone circles: the mean of both, mm
    double innerRadius = 0;        ///< min r about the centre, mm
    double outerRadius = 0;        ///< max r, mm
    double width = 0;              ///< outer − inner, mm
    std::optional<bool> certified; ///< minimum zone: proven the least; null for least squares
};

/// What a circular test yields besides its parameters.
struct CircularResults {
    std::vector<EvaluatedPath> paths;     ///< the first of each sense, in the order of measurement
    std::vector<std::size_t> repetitions; ///< further arcs: for repeatability, shown on request
    std::vector<CircleResult> circles;
    std::optional<double> correction;   ///< C to 20 °C, mm, added to F and D; null: not applied here
    std::optional<Point> centringError; ///< of commanded angles, mm
    At20 at20 = At20::hold;             ///< of F and D, which say so

    [[nodiscard]] const CircleResult *circle(CircleOf of, ReferenceCircle kind) const;
};

/// A drift test: E_VE = max − min of its deviations.
struct DriftResults {
    std::optional<double> range; ///< mm, rotary: degrees; null without readings
};

/// How the uncertainty of the results was found. The U of each stand with its parameter.
struct UncertaintyEvaluation {
    UncertaintyMethod method = UncertaintyMethod::none; ///< the one that is to decide
    std::vector<Contribution> contributions;            ///< of the budget, in its order
    std::optional<double> length;                       ///< L of the budget of a linear axis, mm
    std::optional<double> systematic;                   ///< S of a positioning test, mm or degrees
    bool complete = false;                        ///< every result that is asked for has a U by the budget
    std::shared_ptr<const Simulation> simulation; ///< null: not run
    bool outdated = false;                        ///< the test was edited since the simulation

    /// A simulation decides or is to be shown beside the budget, and can be run.
    [[nodiscard]] bool wantsSimulation() const { return complete && usesContributions(method); }
};

/// How an agreed limit stands, from good to bad.
enum class LimitState { respected, notProven, notEvaluable, exceeded };

/// Why a limit cannot be evaluated. The first that holds is given.
enum class NotEvaluable {
    oneRun,          ///< needs two runs of a direction
    oneDirection,    ///< needs runs in both directions, or in the other one
    oneSense,        ///< needs a path of each sense
    feedbackSignal,  ///< a quantity of an external instrument
    notCalibrated,   ///< a length of an uncalibrated reference
    calibrationOpen, ///< a length of a reference of which nobody says whether it is calibrated
    noSuchParameter, ///< the edition has no such quantity
    otherEdition,    ///< agreed for another edition
    noValue          ///< the quantity has no value; a finding says why
};

/// An agreed limit of the test file and how it stands.
struct AgreedLimit {
    std::string key;    ///< of `limits` in the file
    std::string symbol; ///< as pages write it: "A↑" for "A+"
    Limit limit;        ///< its value is never null
    LimitState state = LimitState::notEvaluable;
    std::optional<NotEvaluable> reason;  ///< null unless not evaluable
    std::vector<std::string> parameters; ///< ids of the results it holds for; empty where there are none
};

/// The evaluation of one test; total: any measurement gives one, what is missing is a finding.
struct TestEvaluation {
    const Edition *edition = nullptr; ///< null for drift tests
    bool view = false;                ///< under another edition than the file's: no verdicts
    std::vector<Parameter> parameters;
    std::vector<Finding> findings;
    /// One entry for each limit of the file that has a value, in the order of their keys; empty for a view.
    std::vector<AgreedLimit> limits;
    /// The worst of the parameters; not proven where a limit is not evaluable; null without a limit.
    std::optional<Verdict> verdict;
    bool provisional = false; ///< a verdict rests on an outdated simulation
    UncertaintyEvaluation uncertainty;
    std::variant<PositioningResults, CircularResults, DriftResults> results;

    [[nodiscard]] Accordance accordance() const { return accordanceOf(findings, edition); }
};

} // namespace palmer
