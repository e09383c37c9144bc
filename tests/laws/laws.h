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
    int texts = 0;
    int numbers = 0;
    int pages = 0;                         ///< composed once more without a statement
    int reports = 0;                       ///< as PDF
    std::map<std::string, int> violations; ///< by law
};

/// Where results leave the program, for a file as bytes.
class Laws {
public:
    /// `mostStatements`: how many statements of a file are taken away, chosen at random; 0: all.
    Laws(const Generator &generator, std::size_t mostStatements, std::uint64_t seed);

    /// Follows a file through every exit and returns what does not hold.
    [[nodiscard]] std::vector<Violation> follow(const Json &file, bool asPdf);

    [[nodiscard]] const Counts &counts() const { return m_counts; }

private:
    const Generator &m_generator;
    std::size_t m_mostStatements;
    std::mt19937_64 m_random;
    Counts m_counts;
};

} // namespace palmer::laws
