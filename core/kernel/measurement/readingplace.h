// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace palmer {

/// Position of a reading in a positioning test: zero-based indices of run and target.
struct ReadingPlace {
    std::size_t run = 0;
    std::size_t target = 0;

    bool operator==(const ReadingPlace &) const = default;
    /// Orders by run, then by target.
    friend bool operator<(const ReadingPlace &a, const ReadingPlace &b) {
        return a.run != b.run ? a.run < b.run : a.target < b.target;
    }
};

} // namespace palmer
