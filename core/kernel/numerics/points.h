// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace palmer {

/// A point of the plane, mm.
struct Point {
    double x = 0;
    double y = 0;

    bool operator==(const Point &) const = default;
};

/// Points of the plane, abscissae and ordinates in separate arrays so that loops over them vectorise; mm. A
/// view: it owns nothing. Both spans have the same size.
struct PointsView {
    std::span<const double> x;
    std::span<const double> y;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Point operator[](std::size_t i) const { return {x[i], y[i]}; }
};

/// Owner of the points behind a PointsView.
struct Points {
    std::vector<double> x;
    std::vector<double> y;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] PointsView view() const { return {x, y}; }

    /// Appends `more` in order.
    void append(PointsView more);

    bool operator==(const Points &) const = default;
};

/// Returns the unit vector of an angle in degrees; exact at the multiples of 90°, any number of turns.
[[nodiscard]] Point direction(double degrees);

/// Returns x = r·cos θ, y = r·sin θ with θ in degrees; as many radii (mm) as angles.
[[nodiscard]] Points polarPoints(std::span<const double> degrees, std::span<const double> radii);

} // namespace palmer
