// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How often what a trend says holds: palmer-trend-coverage [TRIALS]. Prints a table.
#include "core/kernel/trend/simulatedtrends.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char *argv[]) {
    using namespace palmer::testdata;
    const int trials = argc > 1 ? std::atoi(argv[1]) : 10'000;
    std::printf("%-36s %8s %8s %8s %10s\n", "% of trials", "slope", "level", "shown", "not before");
    unsigned seed = 1;
    for (const Situation &situation : situations) {
        const Coverage c = coverageOf(situation, trials, seed++);
        const auto part = [](int of, int all) { return all > 0 ? 100.0 * of / all : 0.0; };
        std::printf("%-36s %8.2f %8.2f %8.2f %10.2f\n", situation.name, part(c.slopeHolds, c.trials),
                    part(c.levelHolds, c.trials), part(c.shown, c.trials), part(c.datesHold, c.trials));
    }
    return 0;
}
