// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/diagnosedtest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palmer {

namespace {

constexpr double sameRadius = 1e-6; ///< mm

/// True if two circles differ only in feed.
bool areAlike(const DiagnosedCircle &a, const DiagnosedCircle &b) {
    return a.first == b.first && a.second == b.second && a.feedback == b.feedback && b.feed &&
           std::abs(a.nominalRadius - b.nominalRadius) <= sameRadius;
}

} // namespace

const CircularMeasurement &DiagnosedTest::measurement() const {
    return std::get<CircularMeasurement>(test->measurement);
}

const CircularResults &DiagnosedTest::results() const {
    return std::get<CircularResults>(evaluation->results);
}

std::optional<DiagnosedCircle> circleOf(const Test &test, const TestEvaluation &evaluation) {
    const auto *measurement = std::get_if<CircularMeasurement>(&test.measurement);
    const auto *results = std::get_if<CircularResults>(&evaluation.results);
    if (!measurement || !results || results->paths.empty())
        return std::nullopt;
    return diagnosedCircle(*measurement, *results);
}

std::optional<DiagnosedTest> diagnosedTest(const EvaluatedDocument &evaluated, std::size_t test) {
    DiagnosedTest result{evaluated.document->tests[test], evaluated.tests[test], {}, {}};
    auto circle = circleOf(*result.test, *result.evaluation);
    if (!circle)
        return std::nullopt;
    result.circle = std::move(*circle);
    result.diagnosis = diagnose(result.circle);
    if (!result.diagnosis.valid())
        return std::nullopt;
    return result;
}

std::vector<std::vector<std::size_t>> testsAtSeveralFeeds(const EvaluatedDocument &evaluated) {
    std::vector<std::pair<std::size_t, DiagnosedCircle>> circles;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (auto circle = circleOf(*evaluated.document->tests[i], *evaluated.tests[i]))
            circles.emplace_back(i, std::move(*circle));
    }
    std::vector<std::vector<std::size_t>> groups;
    std::vector<bool> taken(circles.size());
    for (std::size_t first = 0; first < circles.size(); ++first) {
        std::vector<std::size_t> tests;
        std::vector<DiagnosedCircle> group;
        for (std::size_t k = first; k < circles.size() && !taken[first]; ++k) {
            if (!taken[k] && areAlike(circles[first].second, circles[k].second)) {
                tests.push_back(k);
                group.push_back(circles[k].second);
            }
        }
        for (std::size_t &k : tests) {
            taken[k] = true;
            k = circles[k].first;
        }
        if (areSeveralFeeds(group))
            groups.push_back(std::move(tests));
    }
    return groups;
}

std::vector<std::size_t> testsAtFeedsWith(const EvaluatedDocument &evaluated, std::size_t test) {
    for (std::vector<std::size_t> &group : testsAtSeveralFeeds(evaluated)) {
        if (std::ranges::find(group, test) != group.end())
            return std::move(group);
    }
    return {};
}

} // namespace palmer
