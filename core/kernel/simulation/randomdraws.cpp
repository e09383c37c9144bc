// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/randomdraws.h"

#include "kernel/numerics/wideregisters.h"

namespace palmer {

/// Plain loops over eight counters, which the compiler vectorises for the calling function.
__attribute__((always_inline)) inline void RandomDraws::fill(long long first, std::uint32_t place,
                                                             std::span<double> numbers) const {
    constexpr std::size_t counters = 8; // two counters of four trials
    constexpr std::size_t trials = Lanes::count;
    constexpr std::size_t words = 4;
    const std::uint32_t low = word(first, 0);
    const std::uint32_t high = word(first, 1);
    const auto key = m_key;
    double *out = numbers.data();
    for (std::size_t end = blockSize; end <= numbers.size(); end += blockSize, place += 2) {
        std::array<std::array<std::uint32_t, counters>, words> drawn{};
        for (std::uint32_t k = 0; k < counters; ++k) {
            const Words x = Threefry<std::uint32_t>::words(
                {low + k % std::uint32_t(trials), high, place + k / std::uint32_t(trials), 0}, key);
            for (std::size_t w = 0; w < words; ++w)
                drawn[w][k] = x[w];
        }
        for (std::size_t k = 0; k < counters; k += trials) {
            for (std::size_t w = 0; w < words; ++w, out += trials) {
                for (std::size_t trial = 0; trial < trials; ++trial)
                    out[trial] = symmetric(drawn[w][k + trial]);
            }
        }
    }
}

PALMER_WIDE void RandomDraws::fillWide(long long first, std::uint32_t place,
                                       std::span<double> numbers) const {
    fill(first, place, numbers);
}

void RandomDraws::symmetricNarrow(long long first, std::uint32_t place, std::span<double> numbers) const {
    fill(first, place, numbers);
}

void RandomDraws::symmetric(long long first, std::uint32_t place, std::span<double> numbers) const {
    if (hasWideRegisters())
        fillWide(first, place, numbers);
    else
        symmetricNarrow(first, place, numbers);
}

} // namespace palmer
