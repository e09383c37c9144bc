// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/targetvalue.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

struct Entry {
    std::string_view id;
    double (*value)(const TargetStatistics &, double c) = nullptr;
};

using Target = const TargetStatistics &;

// clang-format off
constexpr std::array entries{
    Entry{"mean+",    [](Target t, double) { return t.positive.mean; }},
    Entry{"mean-",    [](Target t, double) { return t.negative.mean; }},
    Entry{"mean",     [](Target t, double) { return t.mean(); }},
    Entry{"reversal", [](Target t, double) { return t.reversal(); }},
    Entry{"s+",       [](Target t, double) { return t.positive.s; }},
    Entry{"s-",       [](Target t, double) { return t.negative.s; }},
    Entry{"range+",   [](Target t, double) { return t.positive.range; }},
    Entry{"range-",   [](Target t, double) { return t.negative.range; }},
    Entry{"lower+",   [](Target t, double c) { return t.positive.mean - c * t.positive.s; }},
    Entry{"upper+",   [](Target t, double c) { return t.positive.mean + c * t.positive.s; }},
    Entry{"lower-",   [](Target t, double c) { return t.negative.mean - c * t.negative.s; }},
    Entry{"upper-",   [](Target t, double c) { return t.negative.mean + c * t.negative.s; }},
    Entry{"R+",       [](Target t, double c) { return repeatability(t.positive, c); }},
    Entry{"R-",       [](Target t, double c) { return repeatability(t.negative, c); }},
    Entry{"R",        [](Target t, double c) { return repeatability(t, c); }},
    Entry{"U",        [](Target t, double) { return std::abs(t.reversal()); }},
    Entry{"Ps",       [](Target t, double c) { return c * (t.positive.s + t.negative.s); }},
};
// clang-format on

} // namespace

std::optional<double> targetValue(std::string_view id, const TargetStatistics &target, double c) {
    const auto found = std::ranges::find(entries, id, &Entry::id);
    if (found == entries.end())
        return std::nullopt;
    const double value = found->value(target, c);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace palmer
