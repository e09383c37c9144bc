// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/pathprofile.h"

#include "figures/extremes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace palmer;

namespace {

PathProfile profileOf(std::vector<double> angles, std::vector<double> deviations) {
    PathProfile profile;
    for (std::size_t i = 0; i < angles.size(); ++i)
        profile.source.push_back(i);
    profile.angles = std::move(angles);
    profile.deviations = std::move(deviations);
    profile.ordered =
        std::ranges::is_sorted(profile.angles) || std::ranges::is_sorted(profile.angles, std::greater<>());
    return profile;
}

/// n points over `extent` degrees from `start`, in the sense of its sign; angles scatter by `scatter`.
PathProfile random(std::mt19937 &generator, int n, double start, double extent, double scatter) {
    std::normal_distribution<double> noise(0, 1);
    std::vector<double> angles;
    std::vector<double> deviations;
    for (int i = 0; i < n; ++i) {
        angles.push_back(start + extent * i / n + scatter * noise(generator));
        deviations.push_back(noise(generator));
    }
    return profileOf(angles, deviations);
}

std::vector<TracePoint> joined(const std::vector<CircleTrace> &traces) {
    std::vector<TracePoint> points;
    for (const CircleTrace &trace : traces)
        points.insert(points.end(), trace.points.begin(), trace.points.end());
    return points;
}

/// Where each kept point stands in the profile, in the order kept; the points of the tests are all different.
std::vector<std::size_t> places(const PathProfile &profile, const std::vector<TracePoint> &kept) {
    std::vector<std::size_t> result;
    std::size_t i = 0;
    for (const TracePoint &point : kept) {
        while (i < profile.angles.size() && profile[i] != point)
            ++i;
        result.push_back(i); // the size: not there, or before the one kept last
    }
    return result;
}

/// As decimated() is defined, point by point.
std::vector<TracePoint> plainlyDecimated(const PathProfile &profile, double step) {
    const double towards = profile.angles.back() >= profile.angles.front() ? 1 : -1;
    std::vector<TracePoint> kept;
    for (std::size_t first = 0; first < profile.angles.size();) {
        const double edge = (std::floor(towards * profile.angles[first] / step) + 1) * step;
        std::set<std::size_t> places{first};
        std::size_t least = first;
        std::size_t greatest = first;
        std::size_t next = first + 1;
        for (; next < profile.angles.size() && towards * profile.angles[next] < edge; ++next) {
            if (profile.deviations[next] < profile.deviations[least])
                least = next;
            if (profile.deviations[next] > profile.deviations[greatest])
                greatest = next;
        }
        places.insert({least, greatest, next - 1});
        for (std::size_t i = first; next - first <= 4 && i < next; ++i)
            places.insert(i);
        for (const std::size_t place : places)
            kept.push_back(profile[place]);
        first = next;
    }
    return kept;
}

} // namespace

/// Paths as they can be drawn.
class PathProfileTest : public QObject {
    Q_OBJECT

private slots:
    void fewPointsStayAsTheyAre() {
        std::mt19937 generator(1);
        const PathProfile profile = random(generator, 1800, 0, 360, 0);
        const auto traces = decimated(profile, 0.5);
        QCOMPARE(traces.size(), std::size_t{1});
        QCOMPARE(traces[0].points.size(), std::size_t{1800});
    }

    void decimationKeepsExtremesAndOrder_data() {
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("extent");
        QTest::addColumn<double>("scatter");
        QTest::newRow("counterclockwise") << 20000 << 0.0 << 360.0 << 0.0;
        QTest::newRow("clockwise") << 20000 << 360.0 << -360.0 << 0.0;
        QTest::newRow("more than two turns from a negative angle") << 20000 << -410.0 << 800.0 << 0.0;
        QTest::newRow("angles that turn back now and then") << 20000 << 10.0 << 350.0 << 0.05;
        QTest::newRow("clockwise, angles that turn back") << 20000 << 10.0 << -350.0 << 0.05;
        QTest::newRow("fewer points than steps") << 50 << 0.0 << 120.0 << 0.0;
    }

    void decimationKeepsExtremesAndOrder() {
        QFETCH(const int, n);
        QFETCH(const double, start);
        QFETCH(const double, extent);
        QFETCH(const double, scatter);
        std::mt19937 generator(2);
        const PathProfile profile = random(generator, n, start, extent, scatter);
        constexpr double step = 1;
        const auto traces = decimated(profile, step);
        QCOMPARE(traces.size(), std::size_t{1}); // without a view nothing is left out
        const std::vector<TracePoint> kept = traces[0].points;
        QVERIFY(kept.size() <= 4 * static_cast<std::size_t>(std::ceil(std::abs(extent) / step) + 2));
        const std::vector<std::size_t> at = places(profile, kept);
        QVERIFY(std::ranges::is_sorted(at));
        QVERIFY(at.empty() || at.back() < profile.angles.size());
        QCOMPARE(kept.front(), profile[0]);
        QCOMPARE(kept.back(), profile[profile.angles.size() - 1]);
        // What lies between two kept points lies between the extremes kept around it.
        for (std::size_t k = 0; k < at.size(); ++k) {
            const std::size_t from = at[k > 2 ? k - 3 : 0];
            const std::size_t to = at[std::min(k + 3, at.size() - 1)];
            const auto [least, greatest] =
                std::minmax_element(profile.deviations.begin() + static_cast<std::ptrdiff_t>(at[k]),
                                    profile.deviations.begin() +
                                        static_cast<std::ptrdiff_t>(at[std::min(k + 1, at.size() - 1)] + 1));
            double lowest = *least;
            double highest = *greatest;
            for (std::size_t j = 0; j < at.size(); ++j) {
                if (at[j] >= from && at[j] <= to) {
                    lowest = std::min(lowest, kept[j].deviation);
                    highest = std::max(highest, kept[j].deviation);
                }
            }
            QCOMPARE(lowest, std::min(lowest, *least));
            QVERIFY(std::ranges::any_of(kept, [&](const TracePoint &p) { return p.deviation <= *least; }));
            QVERIFY(std::ranges::any_of(kept, [&](const TracePoint &p) { return p.deviation >= *greatest; }));
        }
        const auto [low, high] = std::ranges::minmax_element(kept, {}, &TracePoint::deviation);
        QCOMPARE(low->deviation, std::ranges::min(profile.deviations));
        QCOMPARE(high->deviation, std::ranges::max(profile.deviations));
    }

    /// Each step by itself, against the plain definition.
    void everyStepKeepsItsOwnExtremes() {
        std::mt19937 generator(3);
        for (const double extent : {360.0, -360.0}) {
            const PathProfile profile = random(generator, 30000, 0.01, extent, 0);
            constexpr double step = 2;
            const auto kept = joined(decimated(profile, step));
            const double towards = extent > 0 ? 1 : -1;
            std::map<long, std::pair<double, double>> extremes;
            const auto add = [&](auto &to, const TracePoint &point) {
                const long bin = static_cast<long>(std::floor(towards * point.angle / step));
                const auto [found, fresh] = to.try_emplace(bin, point.deviation, point.deviation);
                found->second = {std::min(found->second.first, point.deviation),
                                 std::max(found->second.second, point.deviation)};
            };
            for (std::size_t i = 0; i < profile.angles.size(); ++i)
                add(extremes, profile[i]);
            std::map<long, std::pair<double, double>> drawn;
            for (const TracePoint &point : kept)
                add(drawn, point);
            QVERIFY(extremes == drawn);
            QVERIFY(kept.size() <= 4 * extremes.size());
        }
    }

    void extremesAreThoseOfAnyNumberOfValues() {
        std::mt19937 generator(7);
        std::normal_distribution<double> noise(0, 1);
        for (int run = 0; run < 2000; ++run) {
            std::vector<double> values(generator() % 21 + 1);
            for (double &value : values)
                value = noise(generator);
            QCOMPARE(extremesOf(values).from, std::ranges::min(values));
            QCOMPARE(extremesOf(values).to, std::ranges::max(values));
        }
    }

    /// From one to some forty points a step, many of them as far out as others: the first of equals counts.
    void isWhatAPlainLoopKeeps() {
        std::mt19937 generator(6);
        for (int run = 0; run < 400; ++run) {
            const int n = static_cast<int>(generator() % 3000) + 1;
            const double extent = run % 2 == 0 ? 300 : -300;
            PathProfile profile = random(generator, n, -20, extent, run % 3 == 0 ? 0.5 : 0);
            const auto parts = static_cast<double>(generator() % 4 + 1);
            for (double &deviation : profile.deviations)
                deviation = std::round(deviation * parts) / parts;
            const double step = static_cast<double>(generator() % 40 + 1) / 10;
            QVERIFY(joined(decimated(profile, step)) == plainlyDecimated(profile, step));
        }
    }

    void aViewKeepsWhatIsInIt_data() {
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("extent");
        QTest::addColumn<double>("scatter");
        QTest::newRow("counterclockwise") << 0.0 << 360.0 << 0.0;
        QTest::newRow("clockwise") << 360.0 << -360.0 << 0.0;
        QTest::newRow("three turns, counted from far away") << -1000.0 << 1080.0 << 0.0;
        QTest::newRow("angles that turn back") << 0.0 << 360.0 << 0.02;
    }

    void aViewKeepsWhatIsInIt() {
        QFETCH(const double, start);
        QFETCH(const double, extent);
        QFETCH(const double, scatter);
        std::mt19937 generator(4);
        const PathProfile profile = random(generator, 40000, start, extent, scatter);
        for (const Interval view :
             {Interval{10, 20}, Interval{-15, 15}, Interval{350, 371}, Interval{170, 190}}) {
            constexpr double step = 0.25;
            const auto part = joined(decimated(profile, step, view));
            const auto whole = joined(decimated(profile, step));
            QVERIFY(part.size() < whole.size() / 5);
            // Every point of the whole that is in view is there, in the same order.
            std::vector<TracePoint> wanted;
            std::ranges::copy_if(whole, std::back_inserter(wanted), [&](const TracePoint &point) {
                const double middle = (view.from + view.to) / 2;
                return std::abs(std::remainder(point.angle - middle, 360.0)) <= (view.to - view.from) / 2;
            });
            std::size_t next = 0;
            for (const TracePoint &point : part) {
                if (next < wanted.size() && point == wanted[next])
                    ++next;
            }
            QCOMPARE(next, wanted.size());
        }
    }

    void theCutsOfAViewAreGaps() {
        std::mt19937 generator(5);
        const PathProfile profile = random(generator, 3600, 0, 720, 0);
        const auto traces = decimated(profile, 1, Interval{100, 110});
        QCOMPARE(traces.size(), std::size_t{2}); // once a turn
        for (const CircleTrace &trace : traces) {
            for (std::size_t i = 1; i < trace.points.size(); ++i)
                QVERIFY(trace.points[i].angle - trace.points[i - 1].angle < 1);
        }
    }

    void nothingGivesNothing() { QVERIFY(decimated(PathProfile(), 1).empty()); }

    void allAtOneAngleIsOneStep() {
        const PathProfile profile = profileOf(std::vector<double>(100, 45.0), [] {
            std::vector<double> deviations(100, 0.0);
            deviations[30] = 2;
            deviations[60] = -1;
            return deviations;
        }());
        const auto kept = joined(decimated(profile, 1));
        QCOMPARE(kept.size(), std::size_t{4});
        QCOMPARE(kept[1].deviation, 2.0);
        QCOMPARE(kept[2].deviation, -1.0);
    }
};

QTEST_GUILESS_MAIN(PathProfileTest)
#include "pathprofile.moc"
