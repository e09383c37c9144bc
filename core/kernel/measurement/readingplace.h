#pragma once

#include <compare>
#include <cstddef>

namespace palmer {

/// A place among the readings of a positioning test: indices of run and target as in the measurement, from 0.
struct ReadingPlace {
    std::size_t run = 0;
    std::size_t target = 0;

    auto operator<=>(const ReadingPlace &) const = default;
};

} // namespace palmer
