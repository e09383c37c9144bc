// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how often a response is found, how often the intervals of k and τ then cover the truth, and in how
// many of all records a wrong k or τ is stated:
//   palmer-thermal-coverage [RECORDS [HOURS [SHAPE]]]
#include "core/kernel/thermal/simulatedrecords.h"

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace palmer;
using namespace palmer::testdata;

int main(int argc, char **argv) {
    const int records = argc > 1 ? std::atoi(argv[1]) : 1000;
    const double hours = argc > 2 ? std::atof(argv[2]) : 0; // 0: both
    const std::string only = argc > 3 ? argv[3] : "";
    struct Case {
        const char *name;
        double k;
        double start;
        bool settled;
        bool waveOnly;
    };
    constexpr std::array cases{Case{"settled", 5, 0, true, false},
                               Case{"start fitted", 5, 0, false, false},
                               Case{"no response", 0, 0, true, false},
                               Case{"no response, start fitted", 0, 0, false, false},
                               Case{"start off by 0.3 °C, taken as settled", 5, 0.3, true, true},
                               Case{"start off by 0.3 °C, fitted", 5, 0.3, false, true}};
    for (const auto &[length, step] : {std::pair(2 * 3600.0, 10.0), std::pair(24 * 3600.0, 60.0)}) {
        for (const Shape shape : {Shape::step, Shape::ramp, Shape::wave}) {
            for (const Case &one : cases) {
                const char *name = shapeNames.at(static_cast<std::size_t>(shape));
                if ((one.waveOnly && shape != Shape::wave) || (hours > 0 && length != hours * 3600) ||
                    (!only.empty() && only != name))
                    continue;
                Simulated truth{length, step, shape, one.k};
                truth.start = one.start;
                int found = 0;
                int ofK = 0;
                int ofTau = 0;
                for (int i = 0; i < records; ++i) {
                    const SimulatedRecord record = simulated(truth, static_cast<unsigned>(i));
                    const ThermalResponse response = thermalResponse(record.record(one.settled));
                    if (response.state != ResponseState::found)
                        continue;
                    ++found;
                    ofK += covers(response.kRange, truth.k) ? 1 : 0;
                    ofTau += covers(response.tauRange, truth.tau) ? 1 : 0;
                }
                const auto percent = [](int count, int all) { return all > 0 ? 100.0 * count / all : 0; };
                std::printf("%2.0f h, %s, %s: found in %.1f %% of %d; of these k covered in %.1f %%, tau in "
                            "%.1f %%; wrong k in %.1f %%, wrong tau in %.1f %% of all\n",
                            length / 3600, name, one.name, percent(found, records), records,
                            percent(ofK, found), percent(ofTau, found), percent(found - ofK, records),
                            percent(found - ofTau, records));
                std::fflush(stdout);
            }
        }
    }
    return 0;
}
