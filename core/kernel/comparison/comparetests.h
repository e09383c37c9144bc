// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

// The difference of two tests of one axis or plane: an interpretation of two results, not one of the
// standard.

/// A test with what its evaluation depends on.
struct PairedTest {
    const Test *test = nullptr;
    Surroundings surroundings;
};

/// between: two sessions, what was changed in between; laboratories: two results for one machine, judged by
/// E_n.
enum class ComparisonRole { between, laboratories };

struct ComparisonOptions {
    ComparisonRole role = ComparisonRole::between;
    std::optional<double> tolerance; ///< agreed t, mm or degrees; null or 0: none
    bool setUpUntouched = false;     ///< stated: the misalignment is that of the other test
    long long trials = 200'000;      ///< at most; fewer for more than 500 readings
    int threads = 0;                 ///< 0: the number of processors
};

/// Why two tests are not compared at all.
enum class NotComparable { otherKind, otherAxis, otherDirections, otherRadius, noEdition, sharedInstrument };

/// Why no word is said although there is a difference; the first that applies.
enum class NoWord { fewTargets, oneRun, noRepeatability, noUncertainty };

/// Statement on one parameter. worse and better: changed, where less is better.
enum class ChangeWord {
    noChangeProven,
    changed,
    better,
    worse,
    unchangedWithin, ///< the agreed tolerance
    changedByMore,   ///< than the agreed tolerance
    notProven,       ///< neither of both
    agree,           ///< |E_n| ≤ 1
    disagree
};

/// Sources of error that both tests share: one draw a trial for both.
enum class SharedError {
    device,
    machineTemperature,
    machineExpansion,
    instrumentTemperature,
    instrumentExpansion,
    misalignment
};

/// A parameter of both tests; values in mm (rotary: degrees).
struct ComparedParameter {
    Term term;
    std::string index; ///< axes of a circular result; empty for positioning
    double before = 0; ///< of the first n cycles at the common targets
    double after = 0;
    double difference = 0;                         ///< after − before
    std::optional<double> uncertainty = {};        ///< U(d)
    std::optional<double> errorsAlone = {};        ///< part of it from the errors of measurement
    std::optional<double> repeatabilityAlone = {}; ///< U_rep: from the residuals
    std::optional<double> shift = {};   ///< mean of the simulated differences − difference; decides nothing
    std::optional<double> enRatio = {}; ///< d/U(d); only for laboratories
    std::optional<ChangeWord> word = {};
};

/// Differences of the mean deviations of one direction, or of both (null), less the mean of all.
struct ComparedCurve {
    std::optional<Direction> direction;
    std::vector<std::optional<double>> values; ///< null: not measured
    std::vector<std::optional<double>> band;   ///< ±, 95.45 % for all points together; null: no U
};

struct TestComparison {
    std::optional<NotComparable> refusal;
    std::optional<NoWord> noWord;
    const Edition *edition = nullptr; ///< both were evaluated under
    Quantity quantity = Quantity::deviation;
    std::vector<ComparedParameter> parameters;
    std::vector<double> targets;   ///< of the curves
    std::size_t commonTargets = 0; ///< of both tests, within 1e-6 mm
    bool interpolated = false;     ///< curves at other targets: linear between neighbours of the first test
    std::vector<ComparedCurve> curves; ///< of axes only
    int cycles = 0;                    ///< n of each that were used
    std::array<int, 2> cyclesOf{};     ///< n that were there
    std::vector<SharedError> shared;
    bool simulated = false; ///< else the root of the sum of squares: nothing shared is known
    bool pooled = false;    ///< residuals of both tests were drawn from
    long long trials = 0;
};

inline constexpr std::size_t fewestComparedTargets = 5;
inline constexpr double sameTarget = 1e-6; ///< mm or degrees

/// Returns after − before of every parameter with U of the difference, words and curves.
///
/// Positioning: one simulation of both tests. Per trial and test x*_ij = x̄_i + e_i + f·√(n/(n − 1))·(x_iσ(j)
/// − x̄_i): whole cycles σ(j) are drawn with replacement from the test's own, from those of both if n = 2 or
/// one of them drifts; f = t(0.97725, 2n − 2)/2 makes few cycles as unsure as they are. e_i are the errors of
/// the budget without independent drift, which the residuals hold; those that both share have one draw. Each
/// trial goes through the real evaluation; U(d) = 95.45 % quantile of |d* − mean(d*)|. Incomplete budgets:
/// √(U_a² + U_b² + U_rep²). Circles: √(U_a² + U_b²), each with its repeatability.
[[nodiscard]] TestComparison compareTwoTests(const PairedTest &before, const PairedTest &after,
                                             const ComparisonOptions &options = {});

/// The word for a difference; `before` and `after` only for the sign of what is compared by magnitude.
[[nodiscard]] ChangeWord changeWord(double before, double after, Bound bound, double uncertainty,
                                    std::optional<double> tolerance);

/// f = t(0.97725; 2n − 2)/2, n ≥ 2.
[[nodiscard]] double smallSampleFactor(int cycles);

/// t(1 − 0.02275/K; 2n − 2)/t(0.97725; 2n − 2): widens U of one mean to a band of K.
[[nodiscard]] double bandFactor(std::size_t means, int cycles);

/// Means of a curve at other positions: linear between neighbouring ones; null outside.
[[nodiscard]] std::optional<double> betweenTargets(const std::vector<double> &targets,
                                                   const std::vector<std::optional<double>> &values,
                                                   double position);

} // namespace palmer
