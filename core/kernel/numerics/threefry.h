// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace palmer {

/// A stateless random number generator: Threefry 4 × 32 bits. Each pair of counter and key gives its own four
/// 32-bit words; any part of the sequence can be computed at any time, on any thread, with the same result.
/// `Word` is std::uint32_t, or a vector of them for several counters at once. 13 rounds: one more than the
/// fewest that pass all of TestU01's BigCrush.
/// Source: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, Parallel random numbers: as easy as 1, 2, 3,
/// SC'11 (2011).
template <class Word>
struct Threefry {
    static constexpr int standardRounds = 13;

    template <int rounds = standardRounds>
    static std::array<Word, 4> words(const std::array<Word, 4> &counter,
                                     const std::array<std::uint32_t, 4> &key) {
        constexpr std::uint32_t parity = 0x1BD11BDA;
        const std::array<std::uint32_t, 5> keys{key[0], key[1], key[2], key[3],
                                                parity ^ key[0] ^ key[1] ^ key[2] ^ key[3]};
        std::array<Word, 4> x{counter[0] + keys[0], counter[1] + keys[1], counter[2] + keys[2],
                              counter[3] + keys[3]};
        mix<0, rounds>(x, keys);
        return x;
    }

private:
    static constexpr std::array<std::array<int, 2>, 8> rotations{
        {{10, 26}, {11, 21}, {13, 27}, {23, 5}, {6, 20}, {17, 11}, {25, 10}, {18, 20}}};

    template <int by>
    static Word rotated(Word x) {
        return (x << by) | (x >> (32 - by));
    }

    template <int round, int rounds>
    static void mix(std::array<Word, 4> &x, const std::array<std::uint32_t, 5> &keys) {
        if constexpr (round < rounds) {
            constexpr int first = rotations[round % 8][0];
            constexpr int second = rotations[round % 8][1];
            // Even rounds mix 0 with 1 and 2 with 3, odd ones 0 with 3 and 2 with 1.
            constexpr int partner = round % 2 == 0 ? 1 : 3;
            x[0] += x[partner];
            x[partner] = rotated<first>(x[partner]) ^ x[0];
            x[2] += x[4 - partner];
            x[4 - partner] = rotated<second>(x[4 - partner]) ^ x[2];
            if constexpr (round % 4 == 3) {
                constexpr int injection = round / 4 + 1;
                x[0] += keys[injection % 5];
                x[1] += keys[(injection + 1) % 5];
                x[2] += keys[(injection + 2) % 5];
                x[3] += keys[(injection + 3) % 5];
                x[3] += std::uint32_t(injection);
            }
            mix<round + 1, rounds>(x, keys);
        }
    }
};

} // namespace palmer
