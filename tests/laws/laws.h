// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/generator.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palmer::laws {

/// A law that does not hold for a file: which, and what was seen.
struct Violation {
    std::string law;
    std::string what;
};

/// What was followed, for the closing line of a run.
struct Counts {
    int files = 0;
    int refused = 0; ///< by the reader: the generator makes what the schema allows, so there are to be none
    int tests = 0;
    int limits = 0;
    int statements = 0; ///< set to null or removed, one at a time
    int results = 0;    ///< as terminal and report print them
    int texts = 0;
    int numbers = 0;
    int pages = 0;                         ///< composed once more without a statement
    int reports = 0;                       ///< as PDF
    int readBack = 0;                      ///< tests as CSV
    int drawn = 0;                         ///< figures
    int programs = 0;                      ///< part programs
    std::map<std::string, int> violations; ///< by law

    Counts &operator+=(const Counts &other);
};

/// Follows the files of the seeds `first`, `first` + 1, … through every exit, one in twenty also as PDF,
/// takes `mostStatements` of each file's statements away, chosen at random (0: all), and reports what does
/// not hold.
[[nodiscard]] Counts followFiles(int files, std::uint64_t first, std::size_t mostStatements,
                                 const std::function<void(std::uint64_t seed, const Violation &)> &report);

/// The generated file of a seed, as JSON.
[[nodiscard]] std::string fileOf(std::uint64_t seed);

/// Defaults of the schema that claim a fact: all but nothing, and the choices of evaluation and report, which
/// are printed as what was chosen. "key: value" each.
[[nodiscard]] std::vector<std::string> claimingDefaults();

} // namespace palmer::laws
