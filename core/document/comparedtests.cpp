// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/comparedtests.h"

#include "document/diagnosedtest.h"
#include "kernel/diagnosis/sourcewords.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/studentt.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <numbers>
#include <utility>

namespace palmer {

TestComparison compare(const PlacedTest &before, const PlacedTest &after, const ComparisonOptions &options) {
    const auto sideOf = [](const PlacedTest &placed) {
        return PairedTest{&placed.test(), surroundingsOf(*placed.evaluated->document, placed.index)};
    };
    return compareTwoTests(sideOf(before), sideOf(after), options);
}

std::vector<ComparedSource> comparedSources(const PlacedTest &before, const PlacedTest &after) {
    const auto was = diagnosedTest(*before.evaluated, before.index);
    const auto is = diagnosedTest(*after.evaluated, after.index);
    std::vector<ComparedSource> result;
    if (!was || !is)
        return result;
    const auto isValued = [](const SourceEstimate &source) {
        return source.separable && source.value && source.u && !source.indication &&
               source.id != InfluenceId::centre; // the set-up of the instrument
    };
    for (const SourceEstimate &now : is->diagnosis.sources) {
        const auto then = std::ranges::find_if(was->diagnosis.sources, [&](const SourceEstimate &one) {
            return one.id == now.id && one.axis == now.axis && isValued(one);
        });
        if (!isValued(now) || then == was->diagnosis.sources.end())
            continue;
        const double a = *then->u * *then->u;
        const double b = *now.u * *now.u;
        const double sum = a * a / then->degreesOfFreedom + b * b / now.degreesOfFreedom;
        const double freedom = sum > 0 ? (a + b) * (a + b) / sum : 1;
        constexpr double most = 1e6;
        const int degrees = static_cast<int>(std::clamp(freedom, 1.0, most));
        result.push_back({now.id, sourceName(now), *then->value, *now.value,
                          studentQuantile975(degrees) * std::sqrt(a + b)});
    }
    return result;
}

namespace {

constexpr int fullTurn = 360; ///< degrees
constexpr double reach = 5;   ///< degrees: farther apart, nothing is known between two points
constexpr double toDegrees = 180 / std::numbers::pi;

/// The deviations of a path about its least squares centre, from 0° on, mm.
std::vector<std::pair<double, double>> aboutItsCentre(const EvaluatedPath &path) {
    const PointsView points{path.points.x, path.points.y};
    const LeastSquaresCircle circle = leastSquaresCircle(points);
    std::vector<std::pair<double, double>> result;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Point point = points[i];
        const double x = point.x - circle.centre.x;
        const double y = point.y - circle.centre.y;
        const double angle = std::atan2(y, x) * toDegrees;
        result.emplace_back(angle < 0 ? angle + fullTurn : angle, std::hypot(x, y) - circle.radius);
    }
    std::ranges::sort(result);
    return result;
}

std::optional<double> at(const std::vector<std::pair<double, double>> &path, double angle) {
    const auto above =
        std::ranges::lower_bound(path, angle, {}, [](const auto &point) { return point.first; });
    const auto next =
        above == path.end() ? std::pair(path.front().first + fullTurn, path.front().second) : *above;
    const auto last = above == path.begin() ? std::pair(path.back().first - fullTurn, path.back().second)
                                            : *std::prev(above);
    const double gap = next.first - last.first;
    if (gap > reach)
        return std::nullopt;
    return gap > 0 ? std::lerp(last.second, next.second, (angle - last.first) / gap) : next.second;
}

} // namespace

std::vector<ComparedPath> comparedPaths(const PlacedTest &before, const PlacedTest &after) {
    std::vector<ComparedPath> result;
    const auto *was = std::get_if<CircularResults>(&before.evaluation().results);
    const auto *is = std::get_if<CircularResults>(&after.evaluation().results);
    if (!was || !is)
        return result;
    for (const EvaluatedPath &now : is->paths) {
        const auto then = std::ranges::find(was->paths, now.sense, &EvaluatedPath::sense);
        if (then == was->paths.end() || now.points.size() < 3 || then->points.size() < 3)
            continue;
        const auto first = aboutItsCentre(*then);
        const auto second = aboutItsCentre(now);
        ComparedPath path{now.sense, {}};
        for (int angle = 0; angle <= fullTurn; ++angle) {
            const auto a = at(first, angle % fullTurn);
            const auto b = at(second, angle % fullTurn);
            if (a && b)
                path.points.emplace_back(angle, *b - *a);
        }
        if (!path.points.empty())
            result.push_back(std::move(path));
    }
    return result;
}

bool precedes(const Test &test, const Test &other) {
    if (test.role != TestRole::notStated && other.role != TestRole::notStated && test.role != other.role)
        return test.role == TestRole::asFound;
    return test.date && other.date && *test.date < *other.date;
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
    result.before = result.other;
    result.after = test;
    if (precedes(*tests[test], *tests[result.other]))
        std::swap(result.before, result.after);
    result.options.tolerance = stated->tolerance;
    result.options.setUpUntouched = stated->setUpUntouched;
    result.comparison = compare({&evaluated, result.before}, {&evaluated, result.after}, result.options);
    auto shared = std::make_shared<const StatedComparison>(std::move(result));
    const std::scoped_lock lock(mutex);
    latest.push_front({evaluated.document, test, shared});
    if (latest.size() > kept)
        latest.pop_back();
    return shared;
}

std::string comparedId(const ComparedParameter &parameter) {
    return parameter.index.empty() ? std::string(parameter.term.id)
                                   : parameter.term.id + ("_" + parameter.index);
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
