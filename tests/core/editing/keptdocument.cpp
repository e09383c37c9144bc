// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/keptdocument.h"

#include "editing/newtest.h"

#include <QTest>
#include <algorithm>
#include <random>

Q_DECLARE_METATYPE(palmer::Document)

using namespace palmer;

namespace {

constexpr std::size_t targets = 50;
constexpr std::size_t runs = 60;

PositioningMeasurement &measurementOf(Test &test) {
    return std::get<PositioningMeasurement>(test.measurement);
}

Document madeDocument() {
    Test test;
    PositioningMeasurement measurement;
    measurement.axis.name = "X";
    for (std::size_t i = 0; i < targets; ++i)
        measurement.targets.push_back(static_cast<double>(i));
    for (std::size_t run = 0; run < runs; ++run) {
        measurement.runs.push_back({run % 2 == 0 ? Direction::positive : Direction::negative, {}});
        for (std::size_t i = 0; i < targets; ++i)
            measurement.runs.back().deviations.emplace_back(0.001 * static_cast<double>(run * targets + i));
    }
    test.measurement = std::move(measurement);
    Document document;
    document.tests = {std::make_shared<const Test>(newDriftTest(Axis{})), std::make_shared<const Test>(test),
                      std::make_shared<const Test>(newDriftTest(Axis{}))};
    return document;
}

/// The same tests each time it is asked for.
const Document &document() {
    static const Document made = madeDocument();
    return made;
}

CircularMeasurement madeCircle() {
    CircularMeasurement measurement;
    for (int arc = 0; arc < 2; ++arc) {
        Arc made;
        for (int i = 0; i < 1500; ++i) {
            made.angles.push_back(0.1 * i);
            made.radialDeviations.push_back(1e-6 * (i % 7) + arc);
        }
        measurement.arcs.push_back(made);
    }
    return measurement;
}

Document edited(Document document, auto &&change, std::size_t test = 1) {
    auto copy = std::make_shared<Test>(*document.tests[test]);
    change(*copy);
    document.tests[test] = std::move(copy);
    return document;
}

} // namespace

class KeptDocumentTest : public QObject {
    Q_OBJECT

private slots:
    /// Random edits of one to three readings, written, erased and overwritten.
    void ofReadingsTheChangedOnes() {
        std::mt19937 random(7);
        Document before = madeDocument();
        for (int trial = 0; trial < 300; ++trial) {
            const std::size_t count = 1 + random() % 3;
            const Document after = edited(before, [&](Test &test) {
                for (std::size_t k = 0; k < count; ++k) {
                    auto &reading = measurementOf(test).runs[random() % runs].deviations[random() % targets];
                    reading =
                        random() % 4 == 0 ? std::optional<double>() : std::optional(1e-6 * double(random()));
                }
            });
            const KeptDocument kept(before, after, 1000);
            QVERIFY(kept.with(after) == before);
            QVERIFY(kept.with(after).tests[0] == after.tests[0]); // shared
            QVERIFY(kept.readings() <= count + 5 * (runs + 1));
            before = after;
        }
    }

    void whateverElseDiffers_data() {
        QTest::addColumn<Document>("after");
        QTest::addColumn<bool>("light"); // of its readings next to nothing is kept
        const Document before = document();
        const auto row = [&](const char *name, bool light, auto &&change) {
            QTest::newRow(name) << edited(before, change) << light;
        };
        row("title", true, [](Test &test) { test.title = "other"; });
        row("limit", true, [](Test &test) { test.limits["A"].value = 0.01; });
        row("axis and a reading", true, [](Test &test) {
            measurementOf(test).axis.name = "Y";
            measurementOf(test).runs[2].deviations[3] = -1;
        });
        row("direction", true,
            [](Test &test) { measurementOf(test).runs[0].approach = Direction::negative; });
        row("a run less", true, [](Test &test) {
            auto &all = measurementOf(test).runs;
            all.erase(all.begin() + 7);
        });
        row("a run more", true, [](Test &test) {
            auto &all = measurementOf(test).runs;
            all.insert(all.begin() + 7, {Direction::positive, {1.0, {}, 2.0}});
        });
        row("a target less", false, [](Test &test) {
            measurementOf(test).targets.pop_back();
            for (Run &run : measurementOf(test).runs)
                run.deviations.pop_back();
        });
        row("all readings", false, [](Test &test) {
            for (Run &run : measurementOf(test).runs)
                for (auto &reading : run.deviations)
                    reading = 1 - *reading;
        });
        row("another kind", false, [](Test &test) { test.measurement = DriftMeasurement{}; });
        Document head = before;
        head.report.number = "7";
        head.machine.name = "other";
        QTest::newRow("head and machine") << head << true;
        Document fewer = before;
        fewer.tests.erase(fewer.tests.begin());
        QTest::newRow("a test less") << fewer << true;
        Document gone = before;
        gone.tests.erase(gone.tests.begin() + 1);
        QTest::newRow("the large test less") << gone << false;
        Document other = before;
        std::ranges::reverse(other.tests);
        QTest::newRow("another order") << other << true;
        QTest::newRow("two tests")
            << edited(
                   edited(before, [](Test &test) { measurementOf(test).runs[0].deviations[0] = 7; }),
                   [](Test &test) { test.title = "other"; }, 2)
            << true;
    }

    void whateverElseDiffers() {
        QFETCH(Document, after);
        QFETCH(bool, light);
        const Document before = document();
        const KeptDocument back(before, after, 1000);
        QVERIFY(back.with(after) == before);
        QVERIFY(KeptDocument(after, before, 1000).with(before) == after);
        const KeptDocument small(before, after, 1'000'000);
        QVERIFY(small.with(after) == before);
        QCOMPARE(small.readings(), std::size_t{0});
        if (!light)
            QVERIFY(back.readings() >= targets * runs);
        else
            QVERIFY(back.readings() < targets * runs / 2);
    }

    void ofCirclesTheChangedPoints() {
        Document before = madeDocument();
        before.tests[1] = std::make_shared<const Test>([] {
            Test test;
            test.measurement = madeCircle();
            return test;
        }());
        const auto arcs = [](Test & test) -> auto & {
            return std::get<CircularMeasurement>(test.measurement).arcs;
        };
        const Document after = edited(before, [&](Test &test) {
            arcs(test)[0].evaluated = Interval{1, 80};
            arcs(test)[1].radialDeviations[8] = 0.5;
            arcs(test)[1].sense = Sense::clockwise;
        });
        const KeptDocument kept(before, after, 1000);
        QVERIFY(kept.with(after) == before);
        QVERIFY(kept.readings() < 50);
        const Document fewer = edited(before, [&](Test &test) { arcs(test).erase(arcs(test).begin()); });
        QVERIFY(KeptDocument(before, fewer, 1000).with(fewer) == before);
        QVERIFY(KeptDocument(fewer, before, 1000).with(before) == fewer);
    }
};

QTEST_APPLESS_MAIN(KeptDocumentTest)
#include "keptdocument.moc"
