// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how often the intervals of k and τ cover the truth, and how often a response is claimed where there
// is none.
#include "core/kernel/thermal/simulatedrecords.h"

#include <cstdio>
#include <cstdlib>

using namespace palmer;
using namespace palmer::testdata;

int main(int argc, char **argv) {
    const int records = argc > 1 ? std::atoi(argv[1]) : 1000;
    struct Case {
        const char *name;
        double k;
        double start;
        bool settled;
        bool waveOnly;
    };
    constexpr std::array cases{Case{"settled", 5, 0, true, false}, Case{"start fitted", 5, 0, false, false},
                               Case{"no response", 0, 0, true, false},
                               Case{"start off by 0.3 °C, taken as settled", 5, 0.3, true, true},
                               Case{"start off by 0.3 °C, fitted", 5, 0.3, false, true}};
    for (const auto &[length, step] : {std::pair(2 * 3600.0, 10.0), std::pair(24 * 3600.0, 60.0)}) {
        for (const Shape shape : {Shape::step, Shape::ramp, Shape::wave}) {
            for (const Case &one : cases) {
                if (one.waveOnly && shape != Shape::wave)
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
                std::printf("%2.0f h, %s, %s: found in %d of %d; of these k covered in %d, tau in %d\n",
                            length / 3600, shapeNames.at(static_cast<std::size_t>(shape)), one.name, found,
                            records, ofK, ofTau);
                std::fflush(stdout);
            }
        }
    }
    return 0;
}
