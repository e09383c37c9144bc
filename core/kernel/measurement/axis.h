// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace palmer {

enum class Motion { linear, rotary };

/// The direction in which a target is approached: positive (↑) or negative (↓).
enum class Direction { positive, negative };

/// A closed interval, in the unit of the bounded quantity; from < to.
struct Interval {
    double from = 0;
    double to = 0;

    bool operator==(const Interval &) const = default;
};

/// The numerically controlled axis under test. Lengths in mm, for rotary axes in degrees.
struct Axis {
    std::string name;
    Motion motion = Motion::linear;
    std::optional<double> travel;  ///< axis travel (not the measurement travel); null: not stated
    std::optional<Interval> range; ///< ends of the travel in axis coordinates; null: not stated
    std::string positionFeedback;  ///< measuring system of the axis
    std::optional<double> scaleElement =
        {}; ///< length of an element of the measuring system, mm; 0: continuous; null: not stated

    bool operator==(const Axis &) const = default;
};

} // namespace palmer
