// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/lanes.h"
#include "kernel/numerics/normalquantile.h"
#include "kernel/numerics/threefry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace palmer {

/// The random numbers of the trials of a simulation: those of a trial depend only on seed, trial and place.
class RandomDraws {
public:
    explicit RandomDraws(long long seed)
        : m_key{word(seed, 0), word(seed, 1), 0, 0} {}

    using Words = std::array<std::uint32_t, 4>;

    /// Returns four words of the trial for the counter `place`.
    [[nodiscard]] Words words(long long trial, std::uint32_t place) const {
        return Threefry<std::uint32_t>::words({word(trial, 0), word(trial, 1), place, 0}, m_key);
    }

    /// The same for the four trials from `first` (a multiple of 4): four words, with one trial per lane.
    using WordLanes = std::uint32_t __attribute__((vector_size(16)));
    [[nodiscard]] std::array<WordLanes, 4> lanes(long long first, std::uint32_t place) const {
        const std::uint32_t low = word(first, 0);
        const std::uint32_t high = word(first, 1);
        return Threefry<WordLanes>::words({WordLanes{low, low + 1, low + 2, low + 3},
                                           WordLanes{high, high, high, high},
                                           WordLanes{place, place, place, place}, WordLanes{}},
                                          m_key);
    }

    /// Returns symmetric(lanes(first, place)[0]), …[3], symmetric(lanes(first, place + 1)[0]) and so on, four
    /// doubles each, to fill `numbers`, whose size is a multiple of `blockSize`. Uses wide registers if the
    /// processor has them; results are identical on all.
    static constexpr std::size_t blockSize = 32;
    void symmetric(long long first, std::uint32_t place, std::span<double> numbers) const;
    /// Uses only the registers every processor has.
    void symmetricNarrow(long long first, std::uint32_t place, std::span<double> numbers) const;

    /// For one trial the `count` counters from `place`: the first words of all, then the second ones and so
    /// on.
    // NOLINTBEGIN(modernize-avoid-c-arrays): the compiler makes vectors of loops over plain arrays
    template <std::size_t count>
    [[gnu::always_inline]] inline void fillPlaces(long long trial, std::uint32_t place,
                                                  std::uint32_t (&into)[4][count]) const {
        const std::uint32_t low = word(trial, 0);
        const std::uint32_t high = word(trial, 1);
        const auto key = m_key;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Words x = Threefry<std::uint32_t>::words({low, high, place + k, 0}, key);
            for (std::size_t w = 0; w < x.size(); ++w)
                into[w][k] = x[w];
        }
    }

    // NOLINTEND(modernize-avoid-c-arrays)

    /// Uniform in (−1, 1), symmetric: the word as a signed number.
    static double symmetric(std::uint32_t word) {
        return (static_cast<double>(static_cast<std::int32_t>(word)) + 0.5) * unit;
    }
    static Lanes symmetric(const WordLanes &words) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the same bits, of vectors
        return (Lanes::of(reinterpret_cast<Lanes::Integers>(words)) + 0.5) * unit;
    }

    /// Standard normal; 32 bits reach to 6.3 standard deviations.
    static double normal(std::uint32_t word) { return normalQuantile((symmetric(word) + 1) / 2); }
    static Lanes normal(const WordLanes &words) { return normalQuantileOfSymmetric(symmetric(words)); }

private:
    static constexpr double unit = 0x1p-31;

    void fill(long long first, std::uint32_t place, std::span<double> numbers) const;
    void fillWide(long long first, std::uint32_t place, std::span<double> numbers) const;

    static std::uint32_t word(long long number, int which) {
        constexpr int bits = 32;
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(number) >> (which * bits));
    }

    std::array<std::uint32_t, 4> m_key;
};

} // namespace palmer
