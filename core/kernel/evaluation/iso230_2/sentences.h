// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/positioningcase.h"

#include <cmath>
#include <string>

/// Building blocks of the findings of positioning tests.
namespace palmer::iso230_2 {

/// A position or length along the axis: mm or degrees. Rounded to 1e-9, which removes the floating-point
/// error of differences of positions.
[[nodiscard]] inline Number along(const PositioningCase &test, double value, int decimals = -1) {
    constexpr double billion = 1e9;
    return {std::round(value * billion) / billion, test.linear() ? Quantity::position : Quantity::angle,
            decimals};
}

/// A deviation, shown in µm or arc seconds.
[[nodiscard]] inline Number deviation(const PositioningCase &test, double value, int decimals) {
    return {value, test.linear() ? Quantity::deviation : Quantity::angularDeviation, decimals};
}

[[nodiscard]] inline Number count(std::size_t value) {
    return {static_cast<double>(value), Quantity::count, 0};
}

[[nodiscard]] inline const char *arrow(Direction direction) {
    return direction == Direction::positive ? "↑" : "↓";
}

/// "3↑ (j = 2)": target 3, second run in the positive direction, with the letter that the edition gives to
/// runs. `run` counts from 0 over all runs.
[[nodiscard]] std::string readingName(const Edition &edition, const PositioningMeasurement &measurement,
                                      std::size_t run, std::size_t target);

/// A list kept readable: the first dozen names, then "…".
class NameList {
public:
    void add(const std::string &name);
    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] int count() const { return m_count; }
    [[nodiscard]] const std::string &text() const { return m_text; }

private:
    std::string m_text;
    int m_count = 0;
};

} // namespace palmer::iso230_2
