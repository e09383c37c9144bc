// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/trend/notbefore.h"
#include "kernel/trend/trendline.h"
#include "register/queries.h"

#include <QDate>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// A value of the chosen parameter in a test.
struct TrendEntry {
    std::string date;        ///< YYYY-MM-DD
    double time = 0;         ///< years
    RegisteredResult result; ///< its value is never null
    TestRole role = TestRole::notStated;
    Purpose purpose = Purpose::notStated;
    Rule rule = Rule::simpleAcceptance;
    QString file;
    int test = 1;
    QString digest;
    std::size_t stretch = 0; ///< counts the interventions before it: neighbours of one role and stretch are
                             ///< joined by a line
};

/// In what a series differs from the first.
struct SeriesDifference {
    bool edition = false;
    bool feed = false;
    bool travel = false;
    bool correction = false;
    bool setUp = false;
};

/// Tests that can be compared: of one edition, feed, travel (within `travelTolerance`: targets are chosen
/// anew for every test), correction and set-up.
struct TrendSeries {
    std::string edition;
    std::optional<double> feed;
    std::optional<double> travel;
    CorrectionTo20 correction = CorrectionTo20::notStated;
    std::string setUp;
    SeriesDifference difference;
    std::vector<TrendEntry> entries; ///< by time
};

inline constexpr double travelTolerance = 0.02; ///< part of the travel of the newest test of a series

enum class InterventionKind { adjustment, compensation, repair, collision };

/// Something was done to the axis before the test of that day.
struct Intervention {
    InterventionKind kind = InterventionKind::adjustment;
    std::string date;
    double time = 0;
    bool fromFoundToLeft = false; ///< the test before it was as found, this one as left
};

/// How a parameter of an axis moved. The line is that of the first series since the last intervention.
struct MachineTrend {
    std::string parameter; ///< id, "A"
    Kind kind = Kind::positioning;
    bool angular = false;
    std::vector<TrendSeries> series; ///< that of the newest test first
    std::vector<Intervention> interventions;
    std::string since;     ///< the first test of the line's stretch
    std::size_t count = 0; ///< tests of that stretch
    std::optional<TrendLine> line;
    std::optional<double> limit; ///< of the newest test
    Bound bound = Bound::magnitude;
    double reserve = 0; ///< g of the newest test where conformity has to be proven
    NotBefore notBefore;
    bool withoutParts = false; ///< a U of the line came without its parts
    int withoutDate = 0;       ///< tests that are in no series for want of a date
    int sameReadings = 0;      ///< older entries of readings that stand in a newer one
};

/// The trend of a parameter over tests of one machine and axis in the order of tests(); ids as in results.
[[nodiscard]] MachineTrend machineTrend(const std::vector<ListedTest> &tests, const std::string &parameter);

/// The ids of the parameters that tests have, the main ones first: of axes A, E, R, M, B and then the rest;
/// of circles as they come.
[[nodiscard]] std::vector<std::string> parametersOf(const std::vector<ListedTest> &tests);

/// Those a history shows: of axes A, E, R, B, or what they have of one direction; of circles G(b), G, D, F.
[[nodiscard]] std::vector<std::string> mainParametersOf(const std::vector<ListedTest> &tests);

[[nodiscard]] double yearsOf(const QDate &date);
[[nodiscard]] QDate dateOfYears(double years); ///< the day on which it lies
[[nodiscard]] QDate dateOf(const std::string &iso);

} // namespace palmer
