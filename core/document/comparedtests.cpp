// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/comparedtests.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>

namespace palmer {

TestComparison compare(const PlacedTest &before, const PlacedTest &after, const ComparisonOptions &options) {
    const auto sideOf = [](const PlacedTest &placed) {
        return PairedTest{&placed.test(), surroundingsOf(*placed.evaluated->document, placed.index)};
    };
    return compareTwoTests(sideOf(before), sideOf(after), options);
}

std::optional<std::size_t> counterpart(const PlacedTest &test, const EvaluatedDocument &others) {
    const auto directions = [](const Test &t) {
        std::pair<bool, bool> both;
        if (const auto *m = std::get_if<PositioningMeasurement>(&t.measurement)) {
            both.first = std::ranges::find(m->runs, Direction::positive, &Run::approach) != m->runs.end();
            both.second = std::ranges::find(m->runs, Direction::negative, &Run::approach) != m->runs.end();
        }
        return both;
    };
    const auto radius = [](const Test &t) {
        return partOr(0.0, t.measurement,
                      [](auto &m) -> decltype(m.nominalRadius) { return m.nominalRadius; });
    };
    for (std::size_t i = 0; i < others.tests.size(); ++i) {
        const Test &other = *others.document->tests[i];
        const bool isItself = &other == &test.test();
        if (!isItself && areOfSameAxis(test.test(), other) && directions(test.test()) == directions(other) &&
            radius(test.test()) == radius(other))
            return i;
    }
    return std::nullopt;
}

} // namespace palmer
