// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/comparison/comparetests.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

using namespace palmer;

namespace {

constexpr double micrometre = 0.001; ///< mm
constexpr int targets = 11;
constexpr double travel = 1000;

struct Truth {
    int cycles = 5;
    double noise = 0.8 * micrometre; ///< s
    double drift = 1 * micrometre;   ///< E_VE: full range, one draw a reading
    double device = 2;               ///< U, k = 2, µm/m: one draw a test
    bool shared = false;             ///< the same device: one draw a pair
    double wave = 4 * micrometre;
};

/// Readings of an axis that never changes: its curve, the error of the device, noise and drift.
Test testOf(const Truth &truth, double deviceError, std::mt19937_64 &random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    PositioningMeasurement m;
    m.axis.name = "X";
    for (int i = 0; i < targets; ++i)
        m.targets.push_back(travel * i / (targets - 1));
    for (int j = 0; j < truth.cycles; ++j) {
        for (const Direction approach : {Direction::positive, Direction::negative}) {
            Run run{approach, {}};
            for (int i = 0; i < targets; ++i) {
                const double way = static_cast<double>(i) / (targets - 1);
                const double curve = truth.wave * std::sin(7 * way) + 3 * micrometre * way +
                                     (approach == Direction::positive ? 1 : -1) * micrometre * (1 + way / 2);
                run.deviations.emplace_back(curve + deviceError * way + truth.noise * normal(random) +
                                            truth.drift * uniform(random));
            }
            m.runs.push_back(std::move(run));
        }
    }
    m.uncertainty.method = UncertaintyMethod::budget;
    m.uncertainty.device = {DeviceKind::certificate, 0.0, truth.device, 2};
    m.uncertainty.misalignmentRange = 0;
    m.uncertainty.temperatureRange = {0, 0};
    m.uncertainty.expansionRange = {0, 0};
    m.uncertainty.environmentalVariation = truth.drift / micrometre;
    Test test;
    test.edition = "ISO 230-2:2006";
    test.measurement = std::move(m);
    return test;
}

struct Counts {
    std::map<std::string, int> covered;
    std::map<std::string, int> coveredByErrors;
    int pairs = 0;
    int bands = 0;
    int anyChanged = 0; ///< of A, E, M, R, B
    int beyondEn = 0;
    int comparedEn = 0;
};

void addPair(Counts &counts, const TestComparison &comparison) {
    ++counts.pairs;
    bool any = false;
    for (const ComparedParameter &p : comparison.parameters) {
        counts.covered[p.term.id] += std::abs(p.difference) <= p.uncertainty.value_or(0) ? 1 : 0;
        counts.coveredByErrors[p.term.id] += std::abs(p.difference) <= p.errorsAlone.value_or(0) ? 1 : 0;
        const bool isMain = std::string("AEMRB").find(p.term.id) != std::string::npos;
        any = any || (isMain && std::abs(p.difference) > p.uncertainty.value_or(0));
    }
    counts.anyChanged += any ? 1 : 0;
    bool inside = true;
    for (const ComparedCurve &curve : comparison.curves) {
        for (std::size_t i = 0; curve.direction && i < curve.values.size(); ++i)
            inside = inside && std::abs(curve.values[i].value_or(0)) <= curve.band[i].value_or(0);
    }
    counts.bands += inside ? 1 : 0;
}

} // namespace

/// How often the statements of a comparison hold: pairs of tests of an axis that did not change.
///   palmer-comparison-coverage [PAIRS [CYCLES [TRIALS]]]
int main(int argc, char **argv) {
    const int pairs = argc > 1 ? std::atoi(argv[1]) : 1000;
    const int only = argc > 2 ? std::atoi(argv[2]) : 0; // 0: all
    ComparisonOptions options;
    options.trials = argc > 3 ? std::atoll(argv[3]) : options.trials;
    Machine machine;
    for (const int cycles : {2, 3, 5, 10}) {
        if (only > 0 && cycles != only)
            continue;
        for (const bool shared : {false, true}) {
            Truth truth;
            truth.cycles = cycles;
            truth.shared = shared;
            Instrument laser;
            laser.serialNumber = "1";
            laser.certificate = "C";
            std::mt19937_64 random(static_cast<std::uint64_t>(100 * cycles + (shared ? 1 : 0)));
            std::normal_distribution<double> normal;
            Counts counts;
            for (int k = 0; k < pairs; ++k) {
                const double first = truth.device / 2 * micrometre * travel / 1000 * normal(random);
                const double second = truth.device / 2 * micrometre * travel / 1000 * normal(random);
                const Test before = testOf(truth, first, random);
                const Test after = testOf(truth, shared ? first : second, random);
                PairedTest a{&before, {}};
                PairedTest b{&after, {}};
                for (PairedTest *one : {&a, &b}) {
                    one->surroundings.machine = &machine;
                    if (shared)
                        one->surroundings.instruments = {&laser};
                }
                addPair(counts, compareTwoTests(a, b, options));
            }
            const auto percent = [&](int count) { return 100.0 * count / counts.pairs; };
            std::printf("n = %d, device %s, %d pairs: band %.1f %%, one of A E M R B changed %.1f %%\n",
                        cycles, shared ? "shared" : "own", pairs, percent(counts.bands),
                        percent(counts.anyChanged));
            for (const auto &[id, count] : counts.covered)
                std::printf("  %-6s covered %5.1f %%, without residuals %5.1f %%\n", id.c_str(),
                            percent(count), percent(counts.coveredByErrors[id]));
        }
    }
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    constexpr int normalPairs = 100'000;
    int beyond = 0;
    for (int k = 0; k < normalPairs; ++k) {
        const double ua = 1;
        const double ub = 0.4;
        beyond += std::abs(ua * normal(random) - ub * normal(random)) / (2 * std::hypot(ua, ub)) > 1 ? 1 : 0;
    }
    std::printf("|E_n| > 1 in %.2f %% of %d normal pairs\n", 100.0 * beyond / normalPairs, normalPairs);
    return 0;
}
