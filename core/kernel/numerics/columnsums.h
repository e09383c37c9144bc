// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/wideregisters.h"

#include <array>
#include <cstddef>
#include <cstring>

/// Sums over columns of numbers. Eight rows are summed in parallel, in one register or several: the sums are
/// identical on all processors, to the last bit, and take an eighth of the time if registers hold eight.
namespace palmer::columnsums {

inline constexpr std::size_t together = 8;

// NOLINTBEGIN(modernize-avoid-c-arrays): registers are no arguments of templates, GCC drops their width

/// Adds `n` terms to each of `number` sums over the columns of a table.
template <class Register, class Terms>
[[gnu::always_inline]] inline void sumUp(const Terms &terms, std::size_t n,
                                         std::array<double, Terms::number> &sums) {
    using Value = typename Register::Value;
    constexpr std::size_t lanes = sizeof(Value) / sizeof(double);
    Value all[Terms::number][together / lanes]{};
    std::size_t i = 0;
    for (; i + together <= n; i += together) {
        for (std::size_t k = 0; k < together / lanes; ++k) {
            Value columns[Terms::columns];
            for (std::size_t c = 0; c < Terms::columns; ++c)
                std::memcpy(&columns[c], terms.column[c] + i + k * lanes, sizeof(Value));
            Value values[Terms::number];
            terms.of(columns, values);
            for (std::size_t s = 0; s < Terms::number; ++s)
                all[s][k] += values[s];
        }
    }
    for (std::size_t s = 0; s < Terms::number; ++s) {
        std::array<double, together> lane{};
        std::memcpy(lane.data(), &all[s], sizeof(lane));
        sums[s] = ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
    }
    for (; i < n; ++i) {
        double columns[Terms::columns];
        for (std::size_t c = 0; c < Terms::columns; ++c)
            columns[c] = terms.column[c][i];
        double values[Terms::number];
        terms.of(columns, values);
        for (std::size_t s = 0; s < Terms::number; ++s)
            sums[s] += values[s];
    }
}

/// `Terms` has a `number` of sums, `columns` and their starts in `column[columns]`, and a template `of(row,
/// values)` that computes the terms of a row, for doubles or registers of them.
template <class Terms>
std::array<double, Terms::number> sumsOf(const Terms &terms, std::size_t n) {
    std::array<double, Terms::number> sums{};
    inAvailableRegisters([&](auto registers)
                             __attribute__((always_inline)) { sumUp<decltype(registers)>(terms, n, sums); });
    return sums;
}

// NOLINTEND(modernize-avoid-c-arrays)

} // namespace palmer::columnsums
