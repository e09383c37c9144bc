// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/comparedtests.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <deque>
#include <mutex>

namespace palmer {

TestComparison compare(const PlacedTest &before, const PlacedTest &after, const ComparisonOptions &options) {
    const auto sideOf = [](const PlacedTest &placed) {
        return PairedTest{&placed.test(), surroundingsOf(*placed.evaluated->document, placed.index)};
    };
    return compareTwoTests(sideOf(before), sideOf(after), options);
}

std::shared_ptr<const StatedComparison> statedComparison(const EvaluatedDocument &evaluated,
                                                         std::size_t test) {
    const auto &tests = evaluated.document->tests;
    const std::optional<ComparedWith> &stated = tests[test]->comparedWith;
    const auto found =
        stated ? std::ranges::find(tests, stated->test, [](const TestPointer &t) { return t->id; })
               : tests.end();
    if (found == tests.end())
        return nullptr;
    // Pages, languages and the check of a report ask again for the same document.
    struct Known {
        std::weak_ptr<const Document> document;
        std::size_t test = 0;
        std::shared_ptr<const StatedComparison> comparison;
    };
    static std::mutex mutex;
    static std::deque<Known> latest;
    constexpr std::size_t kept = 16;
    {
        const std::scoped_lock lock(mutex);
        for (const Known &known : latest) {
            if (known.test == test && known.document.lock() == evaluated.document)
                return known.comparison;
        }
    }
    StatedComparison result;
    result.other = static_cast<std::size_t>(found - tests.begin());
    result.options.tolerance = stated->tolerance;
    result.options.setUpUntouched = stated->setUpUntouched;
    result.comparison = compare({&evaluated, result.other}, {&evaluated, test}, result.options);
    const auto shared = std::make_shared<const StatedComparison>(std::move(result));
    const std::scoped_lock lock(mutex);
    latest.push_front({evaluated.document, test, shared});
    if (latest.size() > kept)
        latest.pop_back();
    return shared;
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
