// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/trend/notbefore.h"
#include "kernel/trend/trendline.h"
#include "register/queries.h"

#include <QDate>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// A value of the chosen parameter in a test.
struct TrendEntry {
    std::string date;               ///< YYYY-MM-DD
    double time = 0;                ///< years
    RegisteredResult result;        ///< its value is never null
    std::vector<SharedPart> shared; ///< of its U/k, besides `result.own`
    TestRole role = TestRole::notStated;
    Purpose purpose = Purpose::notStated;
    Rule rule = Rule::simpleAcceptance;
    QString file;
    int test = 1;
    QString digest;
    std::shared_ptr<const SinceLast> sinceLast; ///< where it was asked for
    std::size_t stretch = 0; ///< number of interventions before it: neighbours with the same role and stretch
                             ///< are joined by a line
};

/// How a series differs from the first.
struct SeriesDifference {
    bool edition = false;
    bool feed = false;
    bool travel = false;
    bool correction = false;
    QStringList setUp; ///< properties it has or lacks ("zone 0 … 500", "zone –")

    [[nodiscard]] bool any() const { return edition || feed || travel || correction || !setUp.isEmpty(); }
};

/// Comparable tests: same edition, feed, radius or travel (within `travelTolerance`, as targets are chosen
/// anew for every test), correction and set-up: zone, compensation, offsets, numbers of runs.
struct TrendSeries {
    std::string edition;
    std::optional<double> feed;
    std::optional<double> travel;
    CorrectionTo20 correction = CorrectionTo20::notStated;
    std::string setUp;
    SeriesDifference difference;
    std::vector<TrendEntry> entries; ///< in chronological order
};

/// Returns in what a test differs from a series.
[[nodiscard]] SeriesDifference differenceOf(const TrendSeries &series, const RegisteredTest &test);

inline constexpr double travelTolerance = 0.02;  ///< relative to the travel of the newest test of a series
inline constexpr double radiusTolerance = 0.001; ///< the same for circles, whose radius may be calibrated

enum class InterventionKind { adjustment, compensation, repair, collision };

/// An intervention on the axis before the test of that day.
struct Intervention {
    InterventionKind kind = InterventionKind::adjustment;
    std::string date;
    double time = 0;
    bool fromFoundToLeft = false; ///< the previous test was as found, this one as left
};

/// Trend of a parameter of an axis. The line is fitted to the first series since the last intervention.
struct MachineTrend {
    std::string parameter; ///< id, "A"
    Kind kind = Kind::positioning;
    bool angular = false;
    std::vector<TrendSeries> series; ///< starting with the newest test's
    std::vector<Intervention> interventions;
    std::string since;     ///< first test of the line's stretch
    std::size_t count = 0; ///< number of tests of that stretch
    std::optional<TrendLine> line;
    std::optional<double> limit; ///< of the newest test
    Bound bound = Bound::magnitude;
    double reserve = 0; ///< g of the newest test if conformity has to be proven
    NotBefore notBefore;
    bool withoutParts = false; ///< a U on the line has no separate parts
    int withoutDate = 0;       ///< tests omitted from the series because they have no date
    int sameReadings = 0;      ///< older entries with the same readings as a newer one
};

/// Returns the trend of a parameter over tests of one machine and axis, in their order; ids as in results.
[[nodiscard]] MachineTrend machineTrend(const std::vector<ListedTest> &tests, const std::string &parameter);

/// Returns the ids of the parameters of the tests, main ones first: for axes A, E, R, M, B and then the rest;
/// for circles in their order.
[[nodiscard]] std::vector<std::string> parametersOf(const std::vector<ListedTest> &tests);

/// Returns those shown in a history: axes A, E, R, B, or those of one direction; circles G(b), G, D, F.
[[nodiscard]] std::vector<std::string> mainParametersOf(const std::vector<ListedTest> &tests);

[[nodiscard]] double yearsOf(const QDate &date);
[[nodiscard]] QDate dateOfYears(double years); ///< the day of a time in years
[[nodiscard]] QDate dateOf(const std::string &iso);

} // namespace palmer
