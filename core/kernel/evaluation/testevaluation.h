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

/// Results of a positioning test besides its parameters. Deviations in mm, rotary: degrees.
struct PositioningResults {
    std::vector<TargetStatistics> targets; ///< by index of the target; NaN where undefined
    bool upward = false;                   ///< the test has runs in the positive direction
    bool downward = false;
    int positiveRuns = 0;
    int negativeRuns = 0;
    DeviationMethod standardDeviation = DeviationMethod::calculation; ///< method actually used
    std::vector<double> corrections; ///< added to each target's deviations (mm); empty: no correction here
    At20 at20 = At20::hold;          ///< for lengths, as reported with E, A, M
    std::optional<DriftStatistic> drift;
    bool judgedAsZone = false;       ///< a zone test of a long axis, judged as a short one
    bool countByPractice = false;    ///< counts judged by practice: not a short linear axis
    bool stepCycleAgreed = false;    ///< in writing, if the edition asks for it
    bool stepCycleNotAgreed = false; ///< reported in the title: not an acceptance result under the edition
};

/// The evaluated part of an arc. Points in mm about the programmed centre; with commanded angles rebuilt from
/// the centring error of the test (kernel/numerics/centringerror.h).
struct EvaluatedPath {
    std::size_t arc = 0; ///< index in the measurement
    Sense sense = Sense::counterclockwise;
    std::string index;  ///< "XY": axes in the order in which the path crosses their positive ends
    Interval evaluated; ///< unwrapped degrees
    double extent = 0;  ///< degrees; 360 for a full circle
    /// True if the step that closes the path is at most twice its largest inner step, and its holes (steps
    /// above four times the median step, including the closing one) total at most 90°.
    bool fullCircle = false;
    Points points;                   ///< evaluated points
    std::vector<std::size_t> source; ///< of each point: its index in the arc; rising
};

enum class CircleOf { both, counterclockwise, clockwise };

/// A reference circle. Centre in mm relative to the programmed centre.
struct CircleResult {
    CircleOf of = CircleOf::both;
    ReferenceCircle kind = ReferenceCircle::minimumZone;
    Point centre;
    double radius = 0;             ///< minimum zone circles: mean of both, mm
    double innerRadius = 0;        ///< min r about the centre, mm
    double outerRadius = 0;        ///< max r, mm
    double width = 0;              ///< outer − inner, mm
    std::optional<bool> certified; ///< minimum zone: proven minimal; null for least squares
};

/// Results of a circular test besides its parameters.
struct CircularResults {
    std::vector<EvaluatedPath> paths;     ///< the first of each sense, in the order of measurement
    std::vector<std::size_t> repetitions; ///< further arcs: for repeatability, shown on request
    std::vector<CircleResult> circles;
    std::optional<double> correction;   ///< C to 20 °C, mm, added to F and D; null: not applied here
    std::optional<Point> centringError; ///< with commanded angles, mm
    At20 at20 = At20::hold;             ///< for F and D, as reported with them

    [[nodiscard]] const CircleResult *circle(CircleOf of, ReferenceCircle kind) const;
};

/// Result of a drift test: E_VE = max − min of its deviations.
struct DriftResults {
    std::optional<double> range; ///< mm, rotary: degrees; null without readings
};

/// How the uncertainty of the results was determined. Each U is stored with its parameter.
struct UncertaintyEvaluation {
    UncertaintyMethod method = UncertaintyMethod::none; ///< method selected
    std::vector<Contribution> contributions;            ///< from the budget, in its order
    std::optional<double> length;                       ///< L of the budget of a linear axis, mm
    std::optional<double> systematic;                   ///< S of a positioning test, mm or degrees
    bool complete = false;                              ///< every requested result has a U from the budget
    std::shared_ptr<const Simulation> simulation;       ///< null: not run
    bool outdated = false;                              ///< the test was edited since the simulation

    /// True if a simulation decides or is to be shown with the budget, and can be run.
    [[nodiscard]] bool wantsSimulation() const { return complete && usesContributions(method); }
};

/// State of an agreed limit, from good to bad.
enum class LimitState { respected, notProven, notEvaluable, exceeded };

/// Why a limit cannot be evaluated; the first reason that applies.
enum class NotEvaluable {
    oneRun,          ///< needs two runs in a direction
    oneDirection,    ///< needs runs in both directions, or in the other one
    oneSense,        ///< needs a path of each sense
    feedbackSignal,  ///< a quantity of an external instrument
    notCalibrated,   ///< a length of an uncalibrated reference
    calibrationOpen, ///< a length whose reference is not stated to be calibrated
    noSuchParameter, ///< the edition has no such quantity
    otherEdition,    ///< agreed for another edition
    noValue          ///< the quantity has no value; a finding says why
};

/// An agreed limit of the test file and its state.
struct AgreedLimit {
    std::string key;    ///< key of `limits` in the file
    std::string symbol; ///< as shown: "A↑" for "A+"
    Limit limit;        ///< its value is never null
    LimitState state = LimitState::notEvaluable;
    std::optional<NotEvaluable> reason;  ///< null unless not evaluable
    std::vector<std::string> parameters; ///< ids of the results it applies to; empty if none
};

/// The evaluation of one test; total: any measurement gives one, and what is missing is a finding.
struct TestEvaluation {
    const Edition *edition = nullptr; ///< null for drift tests
    bool view = false;                ///< under an edition other than the file's: no verdicts
    std::vector<Parameter> parameters;
    std::vector<Finding> findings;
    /// One entry per limit of the file that has a value, in the order of their keys; empty for a view.
    std::vector<AgreedLimit> limits;
    /// Worst verdict of the parameters; not proven if a limit cannot be evaluated; null without limits.
    std::optional<Verdict> verdict;
    bool provisional = false; ///< a verdict rests on an outdated simulation
    UncertaintyEvaluation uncertainty;
    std::variant<PositioningResults, CircularResults, DriftResults> results;

    [[nodiscard]] Accordance accordance() const { return accordanceOf(findings, edition); }
};

} // namespace palmer
