// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/editreadings.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <QTest>
#include <random>

using namespace palmer;
using namespace palmer::testdata;

namespace {

PositioningMeasurement example() {
    Test test = example1988("ISO 230-2:1988");
    return measurement(test);
}

/// A document with that measurement, as its file gives it back.
PositioningMeasurement reread(const PositioningMeasurement &written) {
    Document document;
    Test test;
    test.edition = "ISO 230-2:1988";
    test.measurement = written;
    document.tests.push_back(std::make_shared<const Test>(std::move(test)));
    const Document read = readDocument(writeDocument(document));
    return std::get<PositioningMeasurement>(read.tests.at(0)->measurement);
}

} // namespace

class EditReadingsTest : public QObject {
    Q_OBJECT

private slots:
    void putsAndClears() {
        PositioningMeasurement m = example();
        setReading(m, {3, 4}, 0.0123);
        QCOMPARE(readingAt(m, {3, 4}), std::optional(0.0123));
        setReading(m, {3, 4}, std::nullopt);
        QCOMPARE(readingAt(m, {3, 4}), std::nullopt);
        const PositioningMeasurement before = m;
        setReading(m, {10, 4}, 1.0);
        setReading(m, {3, 11}, 1.0);
        QVERIFY(m == before);
    }

    void setsAsideAndBringsBack() {
        const PositioningMeasurement before = example();
        PositioningMeasurement m = before;
        const std::vector<ReadingPlace> places{{1, 1}, {1, 2}};
        setAside(m, places, "beam interrupted");
        QCOMPARE(readingAt(m, {1, 1}), std::nullopt);
        const ExcludedReading *excluded = excludedAt(m, {1, 1});
        QVERIFY(excluded);
        QCOMPARE(excluded->value, 0.0054);
        QCOMPARE(excluded->reason, std::string("beam interrupted"));
        QVERIFY(reread(m) == m);
        setAside(m, places, "again"); // nothing is there to set aside
        QCOMPARE(m.excluded.size(), std::size_t{2});
        bringBack(m, places);
        QVERIFY(m == before);
    }

    void keepsTextThatIsNoNumber() {
        PositioningMeasurement m = example();
        setRefused(m, {5, 8}, "−4,,8");
        QCOMPARE(readingAt(m, {5, 8}), std::nullopt);
        QCOMPARE(refusedAt(m, {5, 8})->text, std::string("−4,,8"));
        QVERIFY(reread(m) == m);
        setReading(m, {5, 8}, -0.0048);
        QVERIFY(!refusedAt(m, {5, 8}));
        QVERIFY(m.refused.empty());
    }

    void leavesForeignExtensionsAlone() {
        Document document;
        Test test = example1988("ISO 230-2:1988");
        setRefused(measurement(test), {5, 8}, "4,,8");
        test.extensions = R"({"colour":"red"})";
        document.tests.push_back(std::make_shared<const Test>(test));
        QByteArray bytes = writeDocument(document);
        QCOMPARE(writeDocument(readDocument(bytes)), bytes);
        // Of a place that does not exist: others' data, kept as they are.
        test = example1988("ISO 230-2:1988");
        test.extensions = R"({"refusedReadings":[{"run":99,"target":1,"text":"4,,8"}]})";
        document.tests[0] = std::make_shared<const Test>(test);
        bytes = writeDocument(document);
        QVERIFY(bytes.contains("4,,8"));
        QCOMPARE(writeDocument(readDocument(bytes)), bytes);
    }

    void refusesTargetsThatDoNotAscend_data() {
        QTest::addColumn<std::size_t>("target");
        QTest::addColumn<double>("position");
        QTest::addColumn<TargetProblem>("problem");
        QTest::newRow("between its neighbours") << std::size_t{1} << 200.0 << TargetProblem::none;
        QTest::newRow("before the first") << std::size_t{0} << -50.0 << TargetProblem::none;
        QTest::newRow("beyond the last") << std::size_t{10} << 2000.0 << TargetProblem::none;
        QTest::newRow("as the one before") << std::size_t{1} << 0.0 << TargetProblem::notAbovePrevious;
        QTest::newRow("as the next") << std::size_t{1} << 300.85 << TargetProblem::notBelowNext;
        QTest::newRow("no number") << std::size_t{1} << std::numeric_limits<double>::quiet_NaN()
                                   << TargetProblem::notFinite;
    }

    void refusesTargetsThatDoNotAscend() {
        QFETCH(std::size_t, target);
        QFETCH(double, position);
        QFETCH(TargetProblem, problem);
        PositioningMeasurement m = example();
        const PositioningMeasurement before = m;
        QCOMPARE(problemOfTarget(m, target, position), problem);
        QCOMPARE(setTarget(m, target, position), problem == TargetProblem::none);
        if (problem == TargetProblem::none)
            QCOMPARE(m.targets[target], position);
        else
            QVERIFY(m == before);
    }

    void whatStandsBesideTheRunsMovesWithThem() {
        PositioningMeasurement m = example();
        const ReadingPlace aside{3, 4};
        setAside(m, {&aside, 1}, "coolant");
        setRefused(m, {3, 6}, "x");
        QCOMPARE(insertTarget(m, 2), std::size_t{2});
        QCOMPARE(m.targets[2], (150.71 + 300.85) / 2);
        QVERIFY(excludedAt(m, {3, 5}) && refusedAt(m, {3, 7}));
        insertRun(m, 0, Direction::negative);
        QVERIFY(excludedAt(m, {4, 5}) && refusedAt(m, {4, 7}));
        const std::vector<std::size_t> targets{2, 5};
        removeTargets(m, targets);
        QVERIFY(m.excluded.empty() && refusedAt(m, {4, 5}));
        const std::vector<std::size_t> runs{0, 4};
        removeRuns(m, runs);
        QVERIFY(m.refused.empty());
        QCOMPARE(m.runs.size(), std::size_t{9});
        QCOMPARE(m.targets.size(), std::size_t{10});
    }

    void namesTargetsThatWereNotMeasured() {
        PositioningMeasurement m = example();
        QVERIFY(unmeasuredTargets(m).empty());
        for (Run &run : m.runs)
            run.deviations[4] = run.deviations[8] = run.deviations[9] = std::nullopt;
        QCOMPARE(unmeasuredTargets(m), (std::vector<std::size_t>{4, 8, 9}));
        m.excluded.push_back({1, 9, 0.01, "beam interrupted"});
        setRefused(m, {0, 9}, "4,,8");
        QCOMPARE(unmeasuredTargets(m), std::vector<std::size_t>{4}); // the others were read
        QCOMPARE(targetsWithoutReading(m), (std::vector<std::size_t>{4, 8, 9}));
        insertRun(m, 0, Direction::positive); // still to be measured
        QVERIFY(unmeasuredTargets(m).empty());
    }

    void addsRunsAsTheTestHasThem() {
        PositioningMeasurement both = example();
        addRuns(both);
        QCOMPARE(both.runs.size(), std::size_t{12});
        QCOMPARE(both.runs[10].approach, Direction::positive);
        QCOMPARE(both.runs[11].approach, Direction::negative);
        Test test = positioningTest("ISO 230-2:2014", {0, 100}, {}, {{1, 2}});
        addRuns(measurement(test));
        QCOMPARE(measurement(test).runs.size(), std::size_t{2});
        QCOMPARE(measurement(test).runs[1].approach, Direction::negative);
        PositioningMeasurement empty;
        addRuns(empty);
        QCOMPARE(empty.runs.size(), std::size_t{2});
    }

    void replacesAllTargets() {
        PositioningMeasurement m = example();
        const std::vector<double> fewer{1, 2, 3};
        QVERIFY(setTargets(m, fewer));
        QCOMPARE(m.runs[0].deviations.size(), std::size_t{3});
        QCOMPARE(readingAt(m, {0, 1}), std::optional(0.0002));
        const PositioningMeasurement before = m;
        QVERIFY(!setTargets(m, std::vector<double>{1, 3, 2}));
        QVERIFY(!setTargets(m, std::vector<double>{1, 1}));
        QVERIFY(m == before);
    }

    /// Whatever is done, the file can be read again and says the same.
    void anythingDoneCanBeSaved() {
        std::mt19937 random(20261121); // NOLINT: the same every time
        const auto below = [&](std::size_t n) {
            return std::uniform_int_distribution<std::size_t>(0, n == 0 ? 0 : n - 1)(random);
        };
        for (int round = 0; round < 20; ++round) {
            PositioningMeasurement m = example();
            for (int step = 0; step < 60; ++step) {
                const ReadingPlace place{below(m.runs.size() + 1), below(m.targets.size() + 1)};
                const std::size_t target = place.target;
                const std::size_t run = place.run;
                switch (below(10)) {
                case 0:
                    setReading(m, place, static_cast<double>(below(200)) / 1e4 - 0.01);
                    break;
                case 1:
                    setReading(m, place, std::nullopt);
                    break;
                case 2:
                    setAside(m, {&place, 1}, "why");
                    break;
                case 3:
                    bringBack(m, {&place, 1});
                    break;
                case 4:
                    setRefused(m, place, "4,,8");
                    break;
                case 5:
                    insertTarget(m, target);
                    break;
                case 6:
                    removeTargets(m, {&target, 1});
                    break;
                case 7:
                    insertRun(m, run, below(2) == 0 ? Direction::positive : Direction::negative);
                    break;
                case 8:
                    removeRuns(m, {&run, 1});
                    break;
                default:
                    setTarget(m, target, static_cast<double>(below(2000)));
                }
            }
            QVERIFY(reread(m) == m);
        }
    }

    void editsASharedTestInACopy() {
        Document document;
        document.tests.push_back(std::make_shared<const Test>(example1988("ISO 230-2:1988")));
        const Document before = document;
        editReadings(document, 0, [](PositioningMeasurement &m) { setReading(m, {0, 0}, 1.0); });
        QVERIFY(document.tests[0] != before.tests[0]);
        QVERIFY(!readingAt(std::get<PositioningMeasurement>(before.tests[0]->measurement), {0, 0}) ||
                readingAt(std::get<PositioningMeasurement>(before.tests[0]->measurement), {0, 0}) != 1.0);
        editReadings(document, 7, [](PositioningMeasurement &) { QFAIL("there is no such test"); });
    }
};

QTEST_GUILESS_MAIN(EditReadingsTest)
#include "editreadings.moc"
