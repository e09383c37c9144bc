// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/changedreadings.h"

#include "editing/newtest.h"

#include <QTest>
#include <random>

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

Document edited(Document document, auto &&change, std::size_t test = 1) {
    auto copy = std::make_shared<Test>(*document.tests[test]);
    change(*copy);
    document.tests[test] = std::move(copy);
    return document;
}

} // namespace

class ChangedReadingsTest : public QObject {
    Q_OBJECT

private slots:
    /// Random edits of one to three readings, written, erased and overwritten.
    void takesOneToTheOtherAndBack() {
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
            const auto found = changedReadings(before, after, targets * runs);
            QVERIFY(found);
            QCOMPARE(found->test, std::size_t{1});
            QVERIFY(found->changes.size() <= count);
            QVERIFY(withReadingsAfter(before, *found) == after);
            QVERIFY(withReadingsBefore(after, *found) == before);
            QVERIFY(withReadingsBefore(after, *found).tests[0] == after.tests[0]); // shared
            before = after;
        }
    }

    void aThousandthIsFew() {
        const auto changing = [](std::size_t count) {
            return edited(madeDocument(), [count](Test &test) {
                for (std::size_t i = 0; i < count; ++i)
                    measurementOf(test).runs[0].deviations[i] = -1;
            });
        };
        const Document base = madeDocument();
        Document three = base;
        three.tests[1] = changing(3).tests[1];
        Document four = base;
        four.tests[1] = changing(4).tests[1];
        QVERIFY(changedReadings(base, three, 3000));
        QVERIFY(!changedReadings(base, three, 3001));
        QVERIFY(!changedReadings(base, four, 3000));
    }

    /// Whatever else differs is kept whole.
    void nothingButReadings() {
        const Document before = madeDocument();
        const auto reading = [](Test &test) { measurementOf(test).runs[2].deviations[3] = -1; };
        const auto with = [&](auto &&change) {
            return edited(before, [&](Test &test) {
                reading(test);
                change(test);
            });
        };
        const auto isKept = [&](const Document &after) { return !changedReadings(before, after, 1); };
        QVERIFY(!isKept(with([](Test &) {})));
        QVERIFY(isKept(with([](Test &test) { test.title = "other"; })));
        QVERIFY(isKept(with([](Test &test) { test.limits["A"].value = 0.01; })));
        QVERIFY(isKept(with([](Test &test) { measurementOf(test).targets[0] = -5; })));
        QVERIFY(isKept(with([](Test &test) { measurementOf(test).axis.name = "Y"; })));
        QVERIFY(isKept(with([](Test &test) { measurementOf(test).runs.pop_back(); })));
        QVERIFY(isKept(with([](Test &test) { measurementOf(test).runs[5].deviations.pop_back(); })));
        QVERIFY(isKept(with([](Test &test) { measurementOf(test).runs[0].approach = Direction::negative; })));
        QVERIFY(isKept(with([](Test &test) { test.measurement = DriftMeasurement{}; })));
        Document head = with([](Test &) {});
        head.report.number = "7";
        QVERIFY(isKept(head));
        Document machine = with([](Test &) {});
        machine.machine.name = "other";
        QVERIFY(isKept(machine));
        Document fewer = with([](Test &) {});
        fewer.tests.pop_back();
        QVERIFY(isKept(fewer));
        QVERIFY(isKept(edited(
            with([](Test &) {}), [](Test &test) { test.title = "other"; }, 2)));
    }
};

QTEST_APPLESS_MAIN(ChangedReadingsTest)
#include "changedreadings.moc"
