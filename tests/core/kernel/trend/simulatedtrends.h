// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/trend/notbefore.h"
#include "kernel/trend/trendline.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

/// Tests over time with known truth: how often the statements of a trend hold.
namespace palmer::testdata {

struct Situation {
    const char *name;
    int tests;         ///< one each half year
    double own;        ///< µm, standard deviation of what belongs to one test
    double shared;     ///< µm, of what an instrument gets wrong
    int testsOfDevice; ///< before another instrument takes its place
    double scatter;    ///< µm, beyond what is stated
    double slope;      ///< µm/year
};

struct Coverage {
    int trials = 0;
    int shown = 0;      ///< a trend was shown
    int slopeHolds = 0; ///< the 95 % interval of the slope holds the true one
    int dates = 0;      ///< a day was given
    int datesHold = 0;  ///< nothing was said that the true line makes false
    int levelHolds = 0; ///< the upper bound at the last test lies above the true level
};

inline Coverage coverageOf(const Situation &situation, int trials, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Coverage result;
    constexpr double interval = 0.5;
    constexpr double start = 9;
    constexpr double limit = 13;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<TrendPoint> points;
        double device = 0;
        for (int i = 0; i < situation.tests; ++i) {
            if (i % situation.testsOfDevice == 0)
                device = normal(random) * situation.shared;
            TrendPoint point;
            point.time = 20 + interval * i;
            point.value = start + situation.slope * interval * i + device + normal(random) * situation.own +
                          normal(random) * situation.scatter;
            point.own = situation.own;
            point.shared = {{"device " + std::to_string(i / situation.testsOfDevice), situation.shared}};
            points.push_back(point);
        }
        const auto line = trendLine(points);
        if (!line)
            continue;
        ++result.trials;
        const double truth = start + situation.slope * (line->last - 20);
        result.slopeHolds +=
            std::abs(line->slope - situation.slope) <= line->twoSided * line->slopeUncertainty() ? 1 : 0;
        result.levelHolds +=
            line->at(line->last) + line->oneSided * line->uncertaintyAt(line->last) >= truth ? 1 : 0;
        result.shown += line->isShown() ? 1 : 0;
        const NotBefore earliest = notBefore(*line, {limit, {}});
        // False is a statement that the limit is not reached before a day when it is.
        const double reached = situation.slope > 0 ? 20 + (limit - start) / situation.slope
                                                   : std::numeric_limits<double>::infinity();
        const double said = earliest.state == NotBefore::State::date     ? earliest.time
                            : earliest.state == NotBefore::State::beyond ? trendHorizon(*line)
                                                                         : 0;
        result.dates += earliest.state == NotBefore::State::date ? 1 : 0;
        result.datesHold += said <= reached ? 1 : 0;
    }
    return result;
}

inline constexpr Situation situations[]{
    {"own parts alone, 6 tests", 6, 0.5, 0, 6, 0, 1.2},
    {"one device for all, 6 tests", 6, 0.3, 0.8, 6, 0, 1.2},
    {"a device each two tests, 8 tests", 8, 0.3, 0.8, 2, 0, 1.2},
    {"scatter beyond U, 4 tests", 4, 0.1, 0.3, 4, 0.6, 1.2},
    {"scatter beyond U, 8 tests", 8, 0.1, 0.5, 4, 0.6, 1.2},
    {"no slope, 4 tests", 4, 0.1, 0.3, 4, 0.6, 0},
    {"no slope, 12 tests, 3 devices", 12, 0.3, 0.6, 4, 0.2, 0},
};

} // namespace palmer::testdata
