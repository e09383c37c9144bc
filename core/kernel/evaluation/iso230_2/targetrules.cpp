// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/targetrules.h"

#include "kernel/numerics/angles.h"

#include <algorithm>
#include <cmath>

namespace palmer::iso230_2 {

namespace {

constexpr double alike = 0.01; ///< of a step or period

/// True if `isSo` holds for all steps between neighbours; false if there is none.
template <class Question>
bool allSteps(std::span<const double> targets, Question isSo) {
    for (std::size_t i = 1; i < targets.size(); ++i) {
        if (!isSo(targets[i] - targets[i - 1]))
            return false;
    }
    return targets.size() > 1;
}

bool isKnown(std::optional<double> period) {
    return period && *period > 0;
}

} // namespace

bool isAtQuarter(double position, double quarter) {
    return std::abs(std::remainder(position - quarter, fullTurn)) < quarterTolerance;
}

double furtherTargets(std::span<const double> targets) {
    return static_cast<double>(std::ranges::count_if(targets, [](double position) {
        return std::abs(std::remainder(position, quarterTurn)) >= quarterTolerance;
    }));
}

double meanStep(std::span<const double> targets) {
    return targets.size() < 2 ? 0
                              : (targets.back() - targets.front()) / static_cast<double>(targets.size() - 1);
}

bool spacedAsOf1988(std::span<const double> targets, std::optional<double> period) {
    const double mean = meanStep(targets);
    const double most = (isKnown(period) ? 2 * *period : 0.6 * mean) + 1e-9 * mean;
    return targets.size() < 2 ||
           allSteps(targets, [&](double step) { return mean - step <= most && step - mean <= most; });
}

bool samePhase(std::span<const double> targets, double pitch) {
    return targets.size() > 1 && std::ranges::all_of(targets, [&](double target) {
               return std::abs(std::remainder((target - targets.front()) / pitch, 1.0)) <= alike + 1e-9;
           });
}

bool stepsOfWholePeriods(std::span<const double> targets, double period) {
    return allSteps(targets, [&](double step) {
        return std::abs(std::remainder(step, period)) <= (alike + 1e-9) * period;
    });
}

bool evenlySpaced(std::span<const double> targets) {
    const double mean = meanStep(targets);
    return targets.size() > 2 &&
           allSteps(targets, [&](double step) { return std::abs(step - mean) <= alike * mean; });
}

double spreadAbout(std::span<const double> targets, double interval) {
    if (targets.empty())
        return 0;
    double low = targets.front();
    double high = low;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double rest = targets[i] - static_cast<double>(i) * interval;
        low = std::min(low, rest);
        high = std::max(high, rest);
    }
    return high - low;
}

double boundOf2006(double interval, std::optional<double> period) {
    return isKnown(period) ? *period : randomShare * interval;
}

bool staysWithin(double spread, double bound, double interval) {
    return spread <= 2 * bound + 1e-9 * std::abs(interval);
}

} // namespace palmer::iso230_2
