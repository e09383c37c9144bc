// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/thermal/response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace palmer::testdata {

/// A record with known truth: k 5 µm/°C, τ 40 min, noise AR(1) 0.9 of 0.3 µm. Computed with the exact
/// solution between the values of the temperature.
struct SimulatedRecord {
    std::vector<double> times;
    std::vector<double> deviations;
    std::vector<double> temperatures;

    [[nodiscard]] ThermalRecord record(bool settled) const {
        return {times, deviations, temperatures, 0, settled};
    }
};

enum class Shape { step, ramp, wave };
inline constexpr std::array shapeNames{"step", "ramp", "wave"};

struct Simulated {
    double length = 2 * 3600.0; ///< s
    double step = 10;           ///< s
    Shape shape = Shape::step;
    double k = 5;
    double tau = 40 * 60.0;
    double start = 0; ///< y(0) − θ(0), °C
    double noise = 0.3;
};

/// Returns θ at a share of the record, 0 … 1.
inline double temperatureAt(Shape shape, double at) {
    switch (shape) {
    case Shape::step:
        return at > 0.1 ? 1 : 0;
    case Shape::ramp:
        return std::clamp((at - 0.2) / 0.4, 0.0, 1.0);
    case Shape::wave:
        return std::sin(4 * std::numbers::pi * at);
    }
    return 0;
}

inline SimulatedRecord simulated(const Simulated &truth, unsigned seed) {
    constexpr double correlation = 0.9;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    SimulatedRecord result;
    const double q = truth.step / truth.tau;
    const double kept = std::exp(-q);
    const double w = (1 - kept) / q;
    double y = temperatureAt(truth.shape, 0) + truth.start;
    double error = truth.noise * normal(random);
    const int last = static_cast<int>(std::lround(truth.length / truth.step));
    for (int i = 0; i <= last; ++i) {
        const double theta = temperatureAt(truth.shape, static_cast<double>(i) / last);
        if (i > 0) {
            y = kept * y + (w - kept) * result.temperatures.back() + (1 - w) * theta;
            error =
                correlation * error + truth.noise * std::sqrt(1 - correlation * correlation) * normal(random);
        }
        result.times.push_back(i * truth.step);
        result.temperatures.push_back(theta);
        result.deviations.push_back(truth.k * y + error);
    }
    return result;
}

inline bool covers(const Range &range, double value) {
    return (!range.low || *range.low <= value) && (!range.high || value <= *range.high);
}

} // namespace palmer::testdata
