// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"
#include "kernel/measurement/conditions.h"
#include "kernel/measurement/uncertaintyinputs.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

enum class Cycle { standard, step };

/// How s is computed: from the squares, or from the range (ISO 230-2:1988 only).
enum class DeviationMethod { calculation, range };

enum class TargetChoiceKind { notStated, free, polygon, fixed };

struct TargetChoice {
    TargetChoiceKind kind = TargetChoiceKind::notStated;
    std::optional<double> interval; ///< nominal interval p, mm or degrees
    std::optional<double> period;   ///< of the periodic error, mm or degrees
    std::optional<long long> seed;
    std::optional<int> faces = {}; ///< of the polygon

    bool operator==(const TargetChoice &) const = default;
};

/// One pass over the targets in one direction. Deviations x_ij = actual − target position in mm (rotary:
/// degrees), by index of the target; null = no reading.
struct Run {
    Direction approach = Direction::positive;
    std::vector<std::optional<double>> deviations;

    bool operator==(const Run &) const = default;
};

/// A reading set aside; run and target count from 1. Its entry in the run is null.
struct ExcludedReading {
    int run = 1;
    int target = 1;
    double value = 0; ///< mm, rotary: degrees
    std::string reason;

    bool operator==(const ExcludedReading &) const = default;
};

/// Text typed in place of a reading that is not a number: shown, but missing in every statistic. Run and
/// target count from 1; the entry in the run is null. Saved in the test's extensions as "refusedReadings".
struct RefusedReading {
    int run = 1;
    int target = 1;
    std::string text; ///< as typed, UTF-8

    bool operator==(const RefusedReading &) const = default;
};

/// Position of a reading in a positioning test: zero-based indices of run and target.
struct ReadingPlace {
    std::size_t run = 0;
    std::size_t target = 0;

    bool operator==(const ReadingPlace &) const = default;
    /// Orders by run, then by target.
    friend bool operator<(const ReadingPlace &a, const ReadingPlace &b) {
        return a.run != b.run ? a.run < b.run : a.target < b.target;
    }
};

/// A positioning test as measured (ISO 230-2): the axis, the targets and the runs in chronological order.
struct PositioningMeasurement {
    Axis axis;
    DeviationMethod standardDeviation = DeviationMethod::calculation;
    std::optional<Cycle> cycle;   ///< null: not stated
    std::optional<Interval> zone; ///< agreed working zone of a long axis
    std::vector<double> targets;  ///< P_i, strictly ascending, mm or degrees
    TargetChoice targetChoice;
    std::vector<Run> runs;
    std::vector<ExcludedReading> excluded;
    std::vector<RefusedReading> refused;
    PositioningConditions conditions;
    PositioningUncertaintyInputs uncertainty;

    bool operator==(const PositioningMeasurement &) const = default;
};

/// Returns the indices of the targets at which no run has a reading.
[[nodiscard]] std::vector<std::size_t> targetsWithoutReading(const PositioningMeasurement &measurement);

/// Returns the measurement travel: last − first target, mm or degrees; 0 without targets.
[[nodiscard]] double measurementTravel(const PositioningMeasurement &measurement);

} // namespace palmer
