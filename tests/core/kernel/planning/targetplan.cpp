// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/planning/targetplan.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

using namespace palmer;

namespace {

TargetRequest linear(double travel) {
    TargetRequest request;
    request.travel = travel;
    return request;
}

TargetRequest rotary(double travel) {
    TargetRequest request = linear(travel);
    request.motion = Motion::rotary;
    return request;
}

bool isMultiple(double value, double unit) {
    return std::abs(std::remainder(value, unit)) < 1e-9;
}

} // namespace

class TargetPlanTest : public QObject {
    Q_OBJECT

private slots:
    void asManyTargetsAsTheStandardAsks_data() {
        QTest::addColumn<bool>("turns");
        QTest::addColumn<double>("travel");
        QTest::addColumn<std::size_t>("count");
        QTest::addColumn<int>("runs");
        // clang-format off
        QTest::newRow("never fewer than 5")              << false <<   200.0 << std::size_t(5)  << 5;
        QTest::newRow("5 a metre")                       << false <<  1000.0 << std::size_t(5)  << 5;
        QTest::newRow("a part of a metre counts")        << false <<  1001.0 << std::size_t(6)  << 5;
        QTest::newRow("the longest short axis")          << false <<  2000.0 << std::size_t(10) << 5;
        QTest::newRow("just longer: its targets may not be")
                                                         << false <<  2000.1 << std::size_t(11) << 5;
        QTest::newRow("a long axis, once each way")      << false <<  3000.0 << std::size_t(15) << 1;
        QTest::newRow("a quarter turn")                  << true  <<    90.0 << std::size_t(3)  << 5;
        QTest::newRow("just more than a quarter")        << true  <<    90.1 << std::size_t(5)  << 5;
        QTest::newRow("half a turn")                     << true  <<   180.0 << std::size_t(5)  << 5;
        QTest::newRow("just more than half a turn")      << true  <<   180.1 << std::size_t(8)  << 5;
        QTest::newRow("more than half a turn")           << true  <<   270.0 << std::size_t(8)  << 5;
        QTest::newRow("a turn, whose end is its beginning")
                                                         << true  <<   360.0 << std::size_t(8)  << 5;
        QTest::newRow("just less than a turn")           << true  <<   359.9 << std::size_t(8)  << 5;
        QTest::newRow("just more than a turn: its targets may not be")
                                                         << true  <<   360.1 << std::size_t(10) << 5;
        QTest::newRow("two turns: 8 each, once each way")<< true  <<   720.0 << std::size_t(17) << 1;
        // clang-format on
    }
    void asManyTargetsAsTheStandardAsks() {
        QFETCH(bool, turns);
        QFETCH(double, travel);
        QFETCH(std::size_t, count);
        QFETCH(int, runs);
        const TargetPlan plan = planTargets(turns ? rotary(travel) : linear(travel));
        QCOMPARE(plan.targets.size(), count);
        QCOMPARE(plan.runs, runs);
    }

    /// Whatever is asked for: ascending, inside, on the resolution, near the nominal positions.
    void everyPlanIsSound() {
        std::mt19937 generator(20260101);
        std::uniform_real_distribution<double> share(0, 1);
        for (int round = 0; round < 2000; ++round) {
            TargetRequest request = linear(20 + 5000 * share(generator));
            if (round % 3 == 0)
                request = rotary(20 + 1500 * share(generator));
            request.from = 2000 * share(generator) - 1000;
            request.decimals = 2 + round % 3;
            request.seed = static_cast<std::uint64_t>(round);
            request.rule = round % 2 == 0 ? TargetRule::nominalInterval : TargetRule::pitches1988;
            if (round % 5 != 0)
                request.period = 0.5 + 40 * share(generator);
            const TargetPlan plan = planTargets(request);
            QVERIFY2(!plan.targets.empty(), qPrintable(QString::number(round)));
            const double last = request.from + request.travel;
            for (std::size_t i = 0; i < plan.targets.size(); ++i) {
                const double target = plan.targets[i];
                QVERIFY(target >= request.from - 1e-9 && target <= last + 1e-9); // 1e-9: rounding of decimals
                QVERIFY(i == 0 || plan.targets[i - 1] < target);
                const double scale = std::pow(10, request.decimals);
                QVERIFY(std::abs(target * scale - std::round(target * scale)) < 1e-5);
            }
            if (request.rule == TargetRule::nominalInterval) {
                for (std::size_t i = 0; i < plan.targets.size(); ++i) {
                    const double nominal =
                        request.from + plan.randomPart + static_cast<double>(i) * *plan.interval;
                    const double rest = plan.targets[i] - nominal;
                    QVERIFY(std::abs(rest) <= plan.randomPart + 0.01); // 0.01: the coarsest resolution
                }
                QVERIFY(plan.randomPart <= 0.3 * *plan.interval + 1e-12);
                QVERIFY(!request.period || plan.randomPart <= *request.period);
            }
        }
    }

    void theSeedDecides() {
        TargetRequest request = linear(1500);
        request.period = 10;
        const auto first = planTargets(request).targets;
        QCOMPARE(planTargets(request).targets, first);
        request.seed = 2;
        QVERIFY(planTargets(request).targets != first);
        // Written down once: the same on every machine and with every library.
        TargetRequest known = linear(1000);
        known.period = 10;
        known.seed = 7;
        QCOMPARE(planTargets(known).targets, (std::vector{15.088, 263.986, 492.348, 752.838, 982.825}));
    }

    /// Every target has another phase of the period: its error does not stay hidden.
    void phasesAreSpread() {
        for (const TargetRule rule : {TargetRule::nominalInterval, TargetRule::pitches1988}) {
            TargetRequest request = linear(2000);
            request.perMetre = 50;
            request.period = 5;
            request.rule = rule;
            const TargetPlan plan = planTargets(request);
            std::array<int, 5> phases{};
            for (const double target : plan.targets) {
                const double phase = std::fmod(target, 5) / 5;
                ++phases[std::min<std::size_t>(4, static_cast<std::size_t>(phase * 5))];
            }
            for (const int count : phases)
                QVERIFY(count > 5); // of 100 in 5 classes, about 20 each
        }
    }

    /// "± %1, new for every target": neighbours share neither their random part nor its sign.
    void theRandomPartIsNewForEveryTarget() {
        TargetRequest request = linear(1900);
        request.perMetre = 50;
        request.decimals = 6;
        double products = 0;
        double squares = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            request.seed = seed;
            const TargetPlan plan = planTargets(request);
            std::vector<double> parts;
            for (std::size_t i = 0; i < plan.targets.size(); ++i)
                parts.push_back(plan.targets[i] - request.from - plan.randomPart -
                                static_cast<double>(i) * *plan.interval);
            for (std::size_t i = 1; i < parts.size(); ++i) {
                products += parts[i] * parts[i - 1];
                squares += parts[i] * parts[i];
            }
            std::ranges::sort(parts);
            QVERIFY(std::ranges::adjacent_find(parts) == parts.end());
        }
        // 40 plans of 95 targets: the correlation of independent parts is 0 ± 0.016.
        QVERIFY2(std::abs(products / squares) < 0.08, qPrintable(QString::number(products / squares)));
    }

    /// 300 plans of each rule: every phase of the period is as likely, at the first and the last target, too,
    /// whose random part no end of the travel cuts off. χ² over 10 classes; its bound is exceeded once in
    /// 10⁵.
    void everyPhaseIsAsLikely() {
        constexpr double bound = 39.3; // 9 degrees of freedom, 1 − 10⁻⁵
        for (const TargetRule rule : {TargetRule::nominalInterval, TargetRule::pitches1988}) {
            std::array<std::array<int, 10>, 3> phases{}; // first, last, all others
            for (int i = 0; i < 300; ++i) {
                TargetRequest request = linear(300 + 6 * i);
                request.period = 7 + 0.1 * i; // up to half of it fits into 30 % of the interval
                request.rule = rule;
                request.decimals = 4;
                request.seed = static_cast<std::uint64_t>(i) + 1;
                const std::vector<double> targets = planTargets(request).targets;
                for (std::size_t k = 0; k < targets.size(); ++k) {
                    const double turns = targets[k] / *request.period;
                    const auto phase = static_cast<std::size_t>(10 * (turns - std::floor(turns)));
                    ++phases[k == 0 ? 0 : k + 1 == targets.size() ? 1 : 2][std::min<std::size_t>(phase, 9)];
                }
            }
            for (const auto &counts : phases) {
                const double expected = std::accumulate(counts.begin(), counts.end(), 0.0) / 10;
                double square = 0;
                for (const int count : counts)
                    square += (count - expected) * (count - expected) / expected;
                QVERIFY2(square < bound, qPrintable(QString::number(square)));
            }
        }
    }

    /// No target stands at an end because its random part led beyond.
    void noRandomPartIsCutOff() {
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            TargetRequest request = linear(1000);
            request.seed = seed;
            request.decimals = 6;
            const std::vector<double> targets = planTargets(request).targets;
            QVERIFY(targets.front() > 0 && targets.back() < 1000);
        }
    }

    /// The way from the last target of a turn to the first is as long as the others.
    void aTurnIsClosed() {
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            TargetRequest request = rotary(360);
            request.seed = seed;
            const TargetPlan plan = planTargets(request);
            QCOMPARE(plan.interval, std::optional(45.0));
            const double closing = plan.targets.front() + 360 - plan.targets.back();
            QVERIFY(closing >= 45 - 2 * plan.randomPart - 0.001 &&
                    closing <= 45 + 2 * plan.randomPart + 0.001);
        }
    }

    void targetsKeepTheApproachDistanceFromTheEnds() {
        TargetRequest request = withinAxis(linear(0), {-100, 900}, 5);
        QCOMPARE(request.axisTravel, std::optional(1000.0));
        for (request.seed = 1; request.seed <= 100; ++request.seed) {
            const TargetPlan plan = planTargets(request);
            QVERIFY(plan.targets.front() >= -95 && plan.targets.back() <= 895);
        }
        QVERIFY(!withinAxis(rotary(0), {0, 360}, 1).axisRange);
        TargetRequest quarters = rotary(0);
        quarters.rule = TargetRule::pitches1988;
        quarters = withinAxis(quarters, {0, 180}, 1);
        QCOMPARE(quarters.travel, 180.0);
        QVERIFY(quarters.axisRange == (Interval{-1, 181}));
    }

    /// The zone of a long axis is planned as well, with five approaches.
    void theZoneOfALongAxisIsPlanned() {
        TargetRequest request = withinAxis(linear(0), {0, 3000}, 1);
        const auto plans = planMeasurements(request);
        QCOMPARE(plans.size(), std::size_t(2));
        QCOMPARE(plans[0].plan.runs, 1);
        QCOMPARE(plans[1].plan.runs, 5);
        QVERIFY(plans[1].request.zone == (Interval{500, 2500}));
        QVERIFY(plans[1].plan.targets.front() >= 500 && plans[1].plan.targets.back() <= 2500);
        QCOMPARE(plans[1].plan.targets.size(), std::size_t(10));
        const auto elsewhere = planMeasurements(request, Interval{0, 2000});
        QVERIFY(elsewhere[1].plan.targets.front() >= 1 && elsewhere[1].plan.targets.back() <= 2000);
        QCOMPARE(planMeasurements(withinAxis(linear(0), {0, 2000}, 1)).size(), std::size_t(1));
        QCOMPARE(planMeasurements(withinAxis(rotary(0), {0, 720}, 1)).size(), std::size_t(2));
        // A zone that was agreed: of the whole travel it is the second test, inside it all there is.
        request.zone = Interval{0, 2000};
        const auto agreed = planMeasurements(request);
        QCOMPARE(agreed.size(), std::size_t(2));
        QVERIFY(agreed[0].plan.runs == 1 && !agreed[0].request.zone &&
                agreed[1].request.zone == request.zone);
        TargetRequest inside = request;
        inside.travel = 1900;
        QCOMPARE(planMeasurements(inside).size(), std::size_t(1));
        QCOMPARE(planMeasurements(inside)[0].plan.runs, 5);
        request.travel = -1;
        QVERIFY(planMeasurements(request).empty());
    }

    void theRuleOf1988TakesWholePitches() {
        TargetRequest request = linear(1000);
        request.rule = TargetRule::pitches1988;
        request.period = 10;
        const TargetPlan plan = planTargets(request);
        for (std::size_t i = 0; i < plan.targets.size(); ++i) {
            const double nominal = static_cast<double>(i) * 250;
            const double pitch = std::min(std::floor(nominal / 10), 99.0) * 10;
            QVERIFY(plan.targets[i] >= pitch && plan.targets[i] <= pitch + 10);
        }
    }

    /// 1988 has no bound for an unknown pitch: that of 2006 is taken, and said.
    void thePlanSaysWhoseBoundItTakes() {
        TargetRequest request = linear(1000);
        QVERIFY(!planTargets(request).boundOf2006);
        request.rule = TargetRule::pitches1988;
        QVERIFY(planTargets(request).boundOf2006);
        request.period = 10;
        QVERIFY(!planTargets(request).boundOf2006);
        request.period = 80; // above 30 % of the interval of 250 mm
        QVERIFY(planTargets(request).boundOf2006);
        request.period = 75;
        QVERIFY(!planTargets(request).boundOf2006);
    }

    void quarterTurnsOf1988_data() {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("travel");
        QTest::addColumn<int>("quarters");
        QTest::addColumn<double>("third");
        QTest::newRow("a turn, whose end is its beginning") << 0.0 << 360.0 << 4 << 120.0;
        QTest::newRow("less than a turn") << 0.0 << 270.0 << 4 << 90.0;
        QTest::newRow("no quarter within") << 10.0 << 60.0 << 0 << 20.0;
        QTest::newRow("a turn from elsewhere") << -45.0 << 360.0 << 4 << 120.0;
        QTest::newRow("two turns") << 0.0 << 720.0 << 9 << 120.0;
        QTest::newRow("more than a turn") << 0.0 << 400.0 << 5 << 100.0;
    }
    /// Of any travel: the text sets no upper one, and asks for five approaches.
    void quarterTurnsOf1988() {
        QFETCH(double, from);
        QFETCH(double, travel);
        TargetRequest request = rotary(travel);
        request.from = from;
        request.rule = TargetRule::pitches1988;
        for (request.seed = 0; request.seed < 50; ++request.seed) {
            const TargetPlan plan = planTargets(request);
            const auto quarters =
                std::ranges::count_if(plan.targets, [](double p) { return isMultiple(p, 90); });
            QTEST(static_cast<int>(quarters), "quarters");
            QTEST(plan.randomPart, "third");
            QCOMPARE(static_cast<double>(plan.targets.size()),
                     static_cast<double>(quarters) + travel / plan.randomPart);
            QVERIFY(!plan.interval && !plan.boundOf2006);
            QCOMPARE(plan.runs, 5);
        }
    }

    /// Whole degrees: what falls upon a quarter turn is drawn anew.
    void freeTargetsAreNoQuarterTurns() {
        TargetRequest request = rotary(90);
        request.rule = TargetRule::pitches1988;
        request.decimals = 0;
        for (request.seed = 0; request.seed < 200; ++request.seed)
            QCOMPARE(planTargets(request).targets.size(), std::size_t(5));
    }

    void theAxisTravelIsCountedOfShortAxes() {
        TargetRequest request = linear(999);
        request.axisTravel = 1001;
        QCOMPARE(planTargets(request).targets.size(), std::size_t(6));
        request.axisTravel = 2001;
        QCOMPARE(planTargets(request).targets.size(), std::size_t(5));
    }

    void whatHasNoAnswerHasNoTargets() {
        QVERIFY(planTargets(linear(0)).targets.empty());
        QVERIFY(planTargets(linear(-5)).targets.empty());
        QVERIFY(planTargets(linear(std::nan(""))).targets.empty());
        QVERIFY(planTargets(linear(1e12)).targets.empty());
        TargetRequest coarse = linear(2);
        coarse.decimals = 0;
        QVERIFY(planTargets(coarse).targets.empty());
        TargetRequest odd = linear(100);
        odd.period = 0;
        QVERIFY(planTargets(odd).targets.empty());
        odd = linear(100);
        odd.perMetre = -1;
        QVERIFY(planTargets(odd).targets.empty());
    }

    void cyclesVisitEveryReadingOnce_data() {
        QTest::addColumn<Cycle>("cycle");
        QTest::newRow("standard") << Cycle::standard;
        QTest::newRow("step") << Cycle::step;
    }
    void cyclesVisitEveryReadingOnce() {
        QFETCH(Cycle, cycle);
        auto stops = measuringCycle(4, 3, cycle);
        QCOMPARE(stops.size(), std::size_t(24));
        const auto key = [](const Stop &stop) {
            return std::tuple(stop.target, stop.run, stop.approach == Direction::negative);
        };
        std::ranges::sort(stops, {}, key);
        QVERIFY(std::ranges::adjacent_find(stops) == stops.end());
        QVERIFY(measuringCycle(0, 3, cycle).empty());
        QVERIFY(measuringCycle(4, 0, cycle).empty());
    }

    void theStandardCycleTurnsAtTheEnds() {
        const auto stops = measuringCycle(3, 2, Cycle::standard);
        std::vector<std::size_t> targets;
        for (const Stop &stop : stops)
            targets.push_back(stop.target);
        QCOMPARE(targets, (std::vector<std::size_t>{0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0}));
        QCOMPARE(stops[2].approach, Direction::positive);
        QCOMPARE(stops[3].approach, Direction::negative);
    }
};

QTEST_APPLESS_MAIN(TargetPlanTest)
#include "targetplan.moc"
