// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/curves.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palmer {

namespace {

std::optional<double> valueAt(const std::vector<PlacedValue> &curve, double position) {
    const auto next = std::ranges::lower_bound(curve, position, {}, &PlacedValue::position);
    if (next == curve.end())
        return std::nullopt;
    if (next->position == position)
        return next->value;
    if (next == curve.begin())
        return std::nullopt;
    const PlacedValue &before = *std::prev(next);
    if (!before.value || !next->value)
        return std::nullopt;
    const double part = (position - before.position) / (next->position - before.position);
    return *before.value + part * (*next->value - *before.value);
}

} // namespace

std::vector<PlacedValue> meansOf(const std::vector<CurvePoint> &curve, CurveOf of) {
    std::vector<PlacedValue> result;
    for (const CurvePoint &point : curve) {
        std::optional<double> value = of == CurveOf::down ? point.down : point.up;
        if (of == CurveOf::both)
            value = point.up && point.down ? std::optional((*point.up + *point.down) / 2) : std::nullopt;
        result.push_back({point.target, value});
    }
    return result;
}

std::optional<CurveDifference> differenceOf(const std::vector<PlacedValue> &a,
                                            const std::vector<PlacedValue> &b) {
    if (a.empty() || b.empty())
        return std::nullopt;
    CurveDifference result;
    result.from = std::max(a.front().position, b.front().position);
    result.to = std::min(a.back().position, b.back().position);
    if (!(result.to > result.from))
        return std::nullopt;
    std::set<double> positions;
    for (const auto *curve : {&a, &b}) {
        for (const PlacedValue &point : *curve) {
            if (point.position >= result.from && point.position <= result.to)
                positions.insert(point.position);
        }
    }
    for (const double position : positions) {
        const auto first = valueAt(a, position);
        const auto second = valueAt(b, position);
        PlacedValue value{position, first && second ? std::optional(*first - *second) : std::nullopt};
        if (value.value && (!result.largest || std::abs(*value.value) > std::abs(*result.largest->value)))
            result.largest = value;
        result.values.push_back(value);
    }
    return result;
}

} // namespace palmer
