// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/diagnosis/synthesize.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/paths.h"

#include <algorithm>
#include <vector>

/// How often the 95 % intervals of the diagnosis hold the truth.
namespace palmer::testdata {

/// Evaluated arcs and the circle that looks at them.
struct MadeCircle {
    explicit MadeCircle(CircularMeasurement made)
        : measurement(std::move(made)) {
        iso230_4::Paths paths = iso230_4::paths(measurement);
        results.paths = std::move(paths.evaluated);
        results.centringError = paths.centringError;
    }
    [[nodiscard]] DiagnosedCircle circle() const { return diagnosedCircle(measurement, results); }

    CircularMeasurement measurement;
    CircularResults results;
};

struct Covered {
    InfluenceId id;
    PlaneAxis axis;
    int trials = 0;
    int hits = 0;
};

/// Makes `trials` circles with the same truth and other noise, seeds 1, 2, …, and diagnoses them.
inline std::vector<Covered> coverage(CircularSynthesis asked, const DiagnosisOptions &options, int trials) {
    std::vector<Covered> result;
    for (int trial = 1; trial <= trials; ++trial) {
        asked.noise.seed = trial;
        const MadeCircle made(synthesizeCircular(asked));
        const Diagnosis diagnosis = diagnose(made.circle(), options);
        for (const SourceEstimate &source : diagnosis.sources) {
            const auto interval = source.interval();
            if (!interval)
                continue;
            auto row = std::find_if(result.begin(), result.end(), [&](const Covered &c) {
                return c.id == source.id && c.axis == source.axis;
            });
            if (row == result.end())
                row = result.insert(row, {source.id, source.axis, 0, 0});
            double truth = 0;
            for (const CircularSource &one : asked.sources) {
                if (one.id == source.id && one.axis == source.axis)
                    truth += one.value;
            }
            ++row->trials;
            row->hits += interval->from <= truth && truth <= interval->to;
        }
    }
    return result;
}

/// What the long run and the test look at: a machine with a little of everything.
inline CircularSynthesis coverageCircle(std::size_t points, double correlation) {
    CircularSynthesis asked;
    asked.points = points;
    asked.noise.deviation = 2e-4;
    asked.noise.correlation = correlation;
    asked.sources = {{InfluenceId::scaleMismatch, PlaneAxis::none, 20e-6},
                     {InfluenceId::squareness, PlaneAxis::none, -15e-6},
                     {InfluenceId::servoMismatch, PlaneAxis::none, 2e-4},
                     {InfluenceId::backlash, PlaneAxis::first, 3e-3},
                     {InfluenceId::lateralPlay, PlaneAxis::second, -1e-3},
                     {InfluenceId::straightness, PlaneAxis::first, 2e-3}};
    return asked;
}

} // namespace palmer::testdata
