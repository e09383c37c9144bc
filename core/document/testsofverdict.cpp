// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/testsofverdict.h"

#include <algorithm>

namespace palmer {

namespace {

bool hasSameSubject(const Test &a, const Test &b) {
    if (a.edition != b.edition)
        return false;
    const auto *first = std::get_if<PositioningMeasurement>(&a.measurement);
    const auto *second = std::get_if<PositioningMeasurement>(&b.measurement);
    if (first && second)
        return first->axis.name == second->axis.name && first->axis.motion == second->axis.motion &&
               first->zone.has_value() == second->zone.has_value();
    const auto *circle = std::get_if<CircularMeasurement>(&a.measurement);
    const auto *other = std::get_if<CircularMeasurement>(&b.measurement);
    return circle && other && circle->plane == other->plane && circle->source == other->source &&
           circle->nominalRadius == other->nominalRadius;
}

} // namespace

bool countsForVerdict(const Document &document, std::size_t test) {
    if (document.tests[test]->role != TestRole::asFound)
        return true;
    return std::ranges::none_of(document.tests, [](const TestPointer &other) {
        return !std::holds_alternative<DriftMeasurement>(other->measurement) &&
               other->role != TestRole::asFound;
    });
}

std::optional<std::size_t> testAsFound(const Document &document, std::size_t asLeft) {
    const auto &tests = document.tests;
    if (tests[asLeft]->role != TestRole::asLeft)
        return std::nullopt;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < tests.size() && (i < asLeft || !found); ++i) {
        if (tests[i]->role == TestRole::asFound && hasSameSubject(*tests[i], *tests[asLeft]))
            found = i;
    }
    return found;
}

} // namespace palmer
