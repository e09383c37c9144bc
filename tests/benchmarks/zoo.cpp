// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/diagnosis/zoo.h"

#include <cstdio>
#include <cstdlib>

/// palmer-diagnosis-zoo [TRIALS [POINTS [FIRST [LAST]]]]: circles of two axes with disturbances outside the
/// model, a row for each: how many the diagnosis calls not valid or turned, how many of the intervals it
/// gives hold the truth, how many sources are held (covered, or without an interval), and how many circles
/// state what is not there.
int main(int argc, char **argv) {
    using namespace palmer::testdata;
    const int trials = argc > 1 ? std::atoi(argv[1]) : 500;
    const int points = argc > 2 ? std::atoi(argv[2]) : 720;
    const std::size_t first = argc > 3 ? std::size_t(std::atoi(argv[3])) : 0;
    const std::size_t last = argc > 4 ? std::size_t(std::atoi(argv[4])) : animals.size() - 1;
    if (trials < 1 || points < 360) {
        std::fprintf(stderr, "palmer-diagnosis-zoo [TRIALS [POINTS [FIRST [LAST]]]]\n");
        return 2;
    }
    std::printf("%d circles of 2 x %d points each, %%\n", trials, points);
    std::printf("%-44s%10s%8s%10s%8s%8s\n", "", "not valid", "turned", "coverage", "held", "false");
    for (std::size_t k = first; k <= last && k < animals.size(); ++k) {
        const ZooCounts counts = zooCounts(animals[k], unsigned(trials), std::size_t(points));
        const auto percent = [](double part, double all) { return all > 0 ? 100 * part / all : 100; };
        std::printf("%2zu %-42s%9.1f %7.1f %9.1f %7.1f %7.1f ", k, animals[k].name,
                    percent(counts.notValid, counts.circles), percent(counts.turned, counts.circles),
                    percent(counts.hits, counts.intervals), 100 * counts.held(),
                    percent(counts.falseClaims, counts.circles));
        for (const auto &[word, times] : counts.claimed)
            std::printf(" %s %d", word.c_str(), times);
        for (const auto &[word, times] : counts.seen)
            std::printf(" | %s %d", word.c_str(), times);
        std::printf("\n");
        std::fflush(stdout);
    }
    return 0;
}
