// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/diagnosis/coverage.h"

#include <cstdio>
#include <cstdlib>
#include <string>

/// palmer-diagnosis-coverage [TRIALS [POINTS]]: how many of the 95 % intervals of the diagnosis hold the
/// truth, a row for each source, a column for each noise.
int main(int argc, char **argv) {
    using namespace palmer;
    const int trials = argc > 1 ? std::atoi(argv[1]) : 10'000;
    const int points = argc > 2 ? std::atoi(argv[2]) : 1800;
    if (trials < 1 || points < 100) {
        std::fprintf(stderr, "palmer-diagnosis-coverage [TRIALS [POINTS]]\n");
        return 2;
    }
    const double correlations[]{0, 0.5, 0.9};
    DiagnosisOptions options;
    options.search = false;
    std::vector<std::vector<testdata::Covered>> columns;
    for (const double correlation : correlations) {
        columns.push_back(testdata::coverage(
            testdata::coverageCircle(static_cast<std::size_t>(points), correlation), options, trials));
    }
    std::printf("%d circles of 2 x %d points each; %% of the 95 %% intervals that hold the truth\n", trials,
                points);
    std::printf("%-24s", "correlation");
    for (const double correlation : correlations)
        std::printf("%8.1f", correlation);
    std::printf("\n");
    for (const testdata::Covered &row : columns.front()) {
        const std::string axis = row.axis == PlaneAxis::none    ? ""
                                 : row.axis == PlaneAxis::first ? " X"
                                                                : " Y";
        std::printf("%-24s", (influence(row.id).word + axis).c_str());
        for (const auto &column : columns) {
            for (const testdata::Covered &other : column) {
                if (other.id == row.id && other.axis == row.axis)
                    std::printf("%8.2f", 100.0 * other.hits / other.trials);
            }
        }
        std::printf("\n");
    }
    return 0;
}
