// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/evaluatetest.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

/// Positioning tests made from rows of readings, for tests.
namespace palmer::testdata {

/// Readings in µm, one row a run; ↑ and ↓ in turn, as machines run.
inline Test positioningTest(const char *edition, std::vector<double> targets,
                            const std::vector<std::vector<double>> &up,
                            const std::vector<std::vector<double>> &down) {
    PositioningMeasurement m;
    m.axis.name = "X";
    m.targets = std::move(targets);
    const auto add = [&](Direction approach, const std::vector<double> &readings) {
        Run run{approach, {}};
        for (const double reading : readings)
            run.deviations.emplace_back(reading / 1000);
        m.runs.push_back(std::move(run));
    };
    for (std::size_t j = 0; j < std::max(up.size(), down.size()); ++j) {
        if (j < up.size())
            add(Direction::positive, up[j]);
        if (j < down.size())
            add(Direction::negative, down[j]);
    }
    Test test;
    test.edition = edition;
    test.measurement = std::move(m);
    return test;
}

inline PositioningMeasurement &measurement(Test &test) {
    return std::get<PositioningMeasurement>(test.measurement);
}

inline TestEvaluation evaluated(const Test &test, const char *edition = nullptr) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    return evaluateTest(test, surroundings, edition ? findEdition(edition) : nullptr);
}

inline const Parameter *parameter(const TestEvaluation &evaluation, std::string_view id) {
    const auto found =
        std::ranges::find(evaluation.parameters, id, [](const Parameter &p) { return parameterId(p); });
    return found == evaluation.parameters.end() ? nullptr : &*found;
}

inline const Finding *finding(const TestEvaluation &evaluation, std::string_view id) {
    const auto found = std::ranges::find(evaluation.findings, id, &Finding::id);
    return found == evaluation.findings.end() ? nullptr : &*found;
}

/// exact_hand: x = mean + s·{−1, −1, 0, 1, 1}, so that s is exact and every result an integer or a half.
inline Test exactHand(const char *edition) {
    const std::vector<double> means[2]{{0, 4, -3, 7, 2}, {-2, 3, 1, 4, -6}};
    const std::vector<double> s[2]{{1, 2, 1, 0.5, 1}, {1, 1, 3, 0.5, 2}};
    std::vector<std::vector<double>> runs[2];
    for (int d = 0; d < 2; ++d) {
        for (const double step : {-1.0, -1.0, 0.0, 1.0, 1.0}) {
            runs[d].emplace_back();
            for (std::size_t i = 0; i < 5; ++i)
                runs[d].back().push_back(means[d][i] + s[d][i] * step);
        }
    }
    return positioningTest(edition, {0, 100, 200, 300, 400}, runs[0], runs[1]);
}

/// The worked example of ISO 230-2:1988, table 2, as resources/reference keeps it (ten readings are
/// stand-ins).
inline Test example1988(const char *edition) {
    return positioningTest(
        edition, {0.0, 150.71, 300.85, 450.33, 601.11, 750.31, 901.55, 1050.02, 1201.9, 1351.56, 1500.41},
        {{-3.0, 0.2, -5.0, 0.6, -8.4, -4.9, -6.5, -5.5, -8.2, -7.4, -7.8},
         {-2.0, 0.7, -5.6, 1.6, -7.4, -3.7, -5.6, -3.6, -5.9, -5.5, -5.8},
         {-1.9, 0.4, -4.8, 0.5, -7.8, -4.7, -4.8, -5.0, -6.3, -5.4, -5.6},
         {-1.8, 1.8, -2.7, 2.3, -6.1, -3.4, -3.9, -2.3, -4.5, -3.7, -4.7},
         {-0.9, 1.5, -2.8, 2.3, -6.9, -2.3, -3.5, -2.3, -3.4, -2.2, -2.7}},
        {{2.3, 5.4, -1.5, 2.4, -9.0, -6.1, -5.8, -5.6, -6.1, -5.6, -3.0},
         {1.1, 4.6, -1.0, 2.1, -9.4, -5.7, -5.6, -4.8, -5.0, -4.6, -1.8},
         {3.2, 5.7, -0.8, 3.6, -8.1, -4.5, -4.7, -4.4, -4.8, -2.9, -0.2},
         {2.5, 5.4, -2.6, 2.2, -8.3, -3.6, -4.2, -4.4, -3.1, -2.8, 0.0},
         {1.5, 5.9, -0.8, 2.9, -7.8, -3.1, -3.3, -2.0, -2.0, -1.4, -2.7}});
}

} // namespace palmer::testdata
