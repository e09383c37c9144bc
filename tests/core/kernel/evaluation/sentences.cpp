// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/evaluation/completetests.h"
#include "core/kernel/words/written.h"

#include <QTest>

#include <functional>

using namespace palmer;
using namespace palmer::testdata;

namespace {

using Evaluate = std::function<TestEvaluation()>;

} // namespace

Q_DECLARE_METATYPE(Evaluate)

/// What the findings say in numbers.
class Sentences : public QObject {
    Q_OBJECT

private slots:
    void numbers_data();
    void numbers();
    void ofCircles_data();
    void ofCircles() { numbers(); }
    void differencesOfPositionsAreDecimals();
};

void Sentences::numbers_data() {
    QTest::addColumn<Evaluate>("evaluate");
    QTest::addColumn<QByteArray>("id");
    QTest::addColumn<QByteArray>("expected");
    using Change = std::function<void(Setup &)>;
    using Make = Setup (*)(const char *);
    constexpr const char *of1988 = "ISO 230-2:1988";
    constexpr const char *of2006 = "ISO 230-2:2006";
    const auto row = [](const char *name, const char *edition, Make make, const char *id, Change change,
                        const char *expected) {
        QTest::addRow("%s", name) << Evaluate([=] {
            Setup setup = make(edition);
            change(setup);
            return setup.evaluated();
        }) << QByteArray(id) << QByteArray(expected);
    };
    const auto targets = [](std::vector<double> positions) -> Change {
        return [=](Setup &s) {
            s.m().targets = positions;
            for (Run &run : s.m().runs)
                run.deviations.resize(positions.size(), 0.001);
        };
    };
    // ---- targets: 3, 104, 207, 298, 402, 511 on 531 mm from −10 to 521 ----
    row(
        "six targets on 1 201 mm are one too few", of2006, shortAxis, "targetsPerMetre",
        [](Setup &s) { s.m().axis.travel = 1201; }, "1201 mm; 7n.0; #6");
    row("four targets", of2006, shortAxis, "numberOfTargets", targets({3, 104, 207, 298}), "4n.0");
    // 17 targets up to 16·249 + 7 = 3 991 mm, travel 20 mm more
    row(
        "mean interval", of2006, longAxis, "meanInterval", [](Setup &s) { s.m().targets.back() = 4001; },
        "4001 mm; #17");
    row(
        "elements of 1988", of1988, longAxis, "meanInterval", [](Setup &s) { s.m().targets.back() = 4001; },
        "4001 mm; #17");
    row(
        "left out", of2006, longAxis, "wholeLength", [](Setup &s) { s.m().axis.travel = 4492; },
        "501 mm; 4492 mm");
    row(
        "other test of the zone", of2006, zoneOfLongAxis, "otherTest", [](Setup &s) { s.otherTest = false; },
        "4000 mm");
    row(
        "other test of the whole", of2006, longAxis, "otherTest", [](Setup &s) { s.otherTest = false; },
        "4011 mm; 2000 mm");
    row(
        "other test of a rotary axis", of2006, rotary, "otherTest",
        [](Setup &s) { s.m().axis.travel = 1080; }, "1080°; 360°");
    row(
        "length of the zone", of2006, zoneOfLongAxis, "zone", [](Setup &s) { s.m().zone->to = 2800; },
        "1800 mm; 2000 mm");
    row("quarters of a turn", of1988, rotary, "quarterTurns", targets({0, 41, 91, 137, 181, 222, 270}),
        "90°, 180°");
    row(
        "targets on a part of a turn", of2006, rotary, "numberOfTargets",
        [=](Setup &s) {
            targets({0, 30, 60, 90.1})(s);
            s.m().axis.travel = 90.1;
        },
        "90.1°; 5n.0; #4");
    row(
        "targets a turn", of2006, rotary, "targetsPerTurn",
        [=](Setup &s) {
            targets({0, 100, 200, 720})(s);
            s.m().axis.travel = 1000;
        },
        "720°; #4");
    row(
        "room at the ends", of2006, shortAxis, "ends",
        [](Setup &s) { s.m().conditions.approachDistance = 15; }, "13 mm; 10 mm; 15 mm");
    row(
        "no room at the first end", of2006, shortAxis, "ends", [](Setup &s) { s.m().axis.range->from = 3; },
        "0 mm; 10 mm; 5 mm");
    row(
        "faces", of1988, rotary, "polygonFaces",
        [](Setup &s) {
            s.m().targetChoice.kind = TargetChoiceKind::polygon;
            s.m().targetChoice.faces = 8;
        },
        "8n.0; #9");
    row("one phase", of1988, shortAxis, "targetChoice", targets({0, 100, 200, 300, 400, 500}), "10 mm");
    row("steps", of1988, shortAxis, "spacing", targets({0, 120.5, 200, 300, 400, 500}), "79.5 mm; 120.5 mm");
    row("whole multiples", of2006, shortAxis, "targetChoice", targets({0, 100, 200, 300, 400, 500}), "10 mm");
    row(
        "random part", of2006, shortAxis, "targetChoice",
        [=](Setup &s) {
            targets({0, 103, 200, 300, 400, 520.5})(s);
            s.m().targetChoice.interval = 100;
        },
        "100 mm; 10.25 mm.2; 10 mm");
    // 0, 10, −10, 10, −10, 10 about 100·i; no interval is nearer
    row(
        "random part about the best interval", of2006, shortAxis, "targetChoice",
        [=](Setup &s) {
            targets({0, 110, 190, 310, 390, 510})(s);
            s.m().targetChoice.period = 4.5;
        },
        "100 mm.2; 10 mm.2; 4.5 mm");
    row(
        "even steps", of2006, shortAxis, "evenSpacing",
        [=](Setup &s) {
            targets({0, 100, 200, 300, 400, 500})(s);
            s.m().targetChoice.period.reset();
        },
        "100 mm.2");
    // ---- runs: ↑ and ↓ in turn, five each ----
    row(
        "approaches", of2006, shortAxis, "approaches", [](Setup &s) { s.m().runs.pop_back(); }, "5n.0; 4n.0");
    row(
        "more approaches", of2006, shortAxis, "approaches",
        [](Setup &s) { s.m().runs.push_back(s.m().runs.front()); }, "6n.0; 5n.0");
    row(
        "one direction", of2006, longAxis, "approaches", [](Setup &s) { s.m().runs.pop_back(); },
        "1n.0; 0n.0");
    row(
        "unequal runs", of2006, shortAxis, "unequalRuns", [](Setup &s) { s.m().runs.pop_back(); },
        "5n.0; 4n.0");
    row(
        "gaps", of2006, shortAxis, "missingReadings",
        [](Setup &s) {
            s.m().runs[2].deviations[1].reset();
            s.m().runs[9].deviations[5].reset();
        },
        "2↑ (j = 2), 6↓ (j = 5); #2");
    row(
        "twelve gaps and one more", of2006, shortAxis, "missingReadings",
        [](Setup &s) {
            for (std::size_t k = 0; k < 14; ++k)
                s.m().runs[k / 6].deviations[k % 6].reset();
        },
        "1↑ (j = 1), 2↑ (j = 1), 3↑ (j = 1), 4↑ (j = 1), 5↑ (j = 1), 6↑ (j = 1), 1↓ (j = 1), 2↓ (j = 1), "
        "3↓ (j = 1), 4↓ (j = 1), 5↓ (j = 1), 6↓ (j = 1), …; #14");
    row(
        "refused", of2006, shortAxis, "refusedReadings",
        [](Setup &s) {
            s.m().runs[3].deviations[0].reset();
            s.m().refused = {{4, 1, "4,,8"}, {11, 1, "of no run"}};
        },
        "1↓ (j = 2) [4,,8]; #1");
    row(
        "set aside", of2006, shortAxis, "excluded",
        [](Setup &s) {
            s.m().runs[3].deviations[0].reset();
            s.m().excluded = {{4, 1, 0.1, "beam"}, {11, 1, 0.1, "of no run"}};
        },
        "1↓ (j = 2); #1");
    row(
        "set aside, 1988", of1988, shortAxis, "excluded",
        [](Setup &s) {
            s.m().runs[3].deviations[0].reset();
            s.m().excluded = {{4, 1, 0.1, "beam"}};
        },
        "1↓ (i = 2); #1");
    row(
        "range method of eleven", of1988, shortAxis, "standardDeviation",
        [](Setup &s) {
            s.m().standardDeviation = DeviationMethod::range;
            for (int k = 0; k < 6; ++k)
                s.m().runs.push_back(s.m().runs[1]); // ↓
            for (Run &run : s.m().runs)
                run.deviations[0] = 0.001;
            s.m().runs[1].deviations[0].reset(); // ten at the first target
        },
        "2↓; 11n.0");
    // ---- drift: 0, 10, 20, 30, 50 µm at every target, see driftOf ----
    const auto driftOf = [](const std::vector<double> &micrometres, bool up) -> Change {
        return [=](Setup &s) {
            for (std::size_t k = 0; k < s.m().runs.size(); ++k) {
                for (auto &x : s.m().runs[k].deviations)
                    x = micrometres[k / 2] / 1000;
            }
            if (!up)
                std::erase_if(s.m().runs, [](const Run &r) { return r.approach == Direction::positive; });
        };
    };
    // mean 22, slope (−2·0 − 10 + 30 + 2·50)/10 = 12 a run: D = 48; residuals 2, 0, −2, −4, 4 with squares
    // 40: t = 12/√(40/3/10) = 10.39; t(0.975; 3) = 3.182; R = 4 s = 4·√(1480/4) = 76.94
    row("drift", of2006, shortAxis, "drift", driftOf({0, 10, 20, 30, 50}, true),
        "0.048 mm→µm.2; 10.3923.1; 3.18245.2; R; 0.0769415 mm→µm.2");
    row("falling drift", of2006, shortAxis, "drift", driftOf({50, 30, 20, 10, 0}, true),
        "-0.048 mm→µm.2; 10.3923.1; 3.18245.2; R; 0.0769415 mm→µm.2");
    // nothing but the progress: the scatter about it is that of floating point
    row("drift on a line", of2006, shortAxis, "drift", driftOf({0, 10, 20, 30, 40}, true),
        "0.04 mm→µm.2; ∞; 3.18245.2; R; 0.0632456 mm→µm.2");
    row("drift of one direction", of2006, shortAxis, "drift", driftOf({0, 10, 20, 30, 50}, false),
        "0.048 mm→µm.2; 10.3923.1; 3.18245.2; R↓; 0.0769415 mm→µm.2");
    row(
        "worked example", of1988,
        [](const char *edition) {
            Setup setup;
            setup.test = example1988(edition);
            return setup;
        },
        "workedExample", [](Setup &) {},
        "-0.00153 mm→µm.2; 0.01184 mm→µm.2; 0.0099 mm→µm.1; 0.01349 mm→µm.2; 0.01803 mm→µm.2");
    // ---- conditions ----
    const auto sensor = [](std::size_t which, double start, double end) -> Change {
        return [=](Setup &s) {
            s.common().sensors[which].start = start;
            s.common().sensors[which].end = end;
            s.common().correctionTo20 = CorrectionTo20::notApplied;
            s.common().expansion.instrument = 11.5;
        };
    };
    row("the air: the farthest of all", of1988, shortAxis, "temperature", sensor(2, 19.2, 20.7), "19.2 °C");
    row(
        "the air: of a series", of1988, shortAxis, "temperature",
        [](Setup &s) {
            s.common().sensors[2].series = TemperatureSeries{{0, 1, 2}, {20, 21.5, 19}};
        },
        "21.5 °C");
    row(
        "gradient", of2006, shortAxis, "gradientPerHour",
        [](Setup &s) { s.m().conditions.gradientPerHour = -0.51; }, "-0.51 °C/h; 0.5 °C/h");
    for (const char *edition : {of1988, of2006})
        row(
            "another feed than agreed", edition, shortAxis, "feed",
            [](Setup &s) { agreed(s.test, "feed").value = 4000; }, "5000 feed; 4000 feed");
    row("machine not at 20 °C", of2006, shortAxis, "correctionTo20", sensor(0, 22, 23), "23 °C.1");
    row("instrument not at 20 °C", of2006, shortAxis, "correctionTo20", sensor(1, 18, 19), "18 °C.1");
    row(
        "expansion known too well", of2006, shortAxis, "expansionRange",
        [](Setup &s) { s.m().uncertainty.expansionRange.machine = 3.3; }, "1.98 α.2; 2 α");
    row(
        "step cycle", of2006, shortAxis, "cycle",
        [](Setup &s) {
            s.m().cycle = Cycle::step;
            agreed(s.test, "stepCycle").text = "contract 12";
        },
        "contract 12");
    // ---- what the instrument's program says ----
    const auto hand = [](const char *edition) {
        Setup setup;
        setup.test = exactHand(edition); // A = 18 µm
        return setup;
    };
    row(
        "the instrument says 20 µm", of2006, hand, "instrumentResult",
        [](Setup &s) {
            s.test.imports = {{"x.rtl", "", {}, {{"A", 20, "µm"}}, {}}};
        },
        "A; 0.02 mm→µm.2; 0.018 mm→µm.2");
    for (const char *unit : {"um", "μm"}) // the word of files, the Greek letter
        row(
            unit, of2006, hand, "instrumentResult",
            [unit](Setup &s) {
                s.test.imports = {{"x.rtl", "", {}, {{"A", 20, unit}}, {}}};
            },
            "A; 0.02 mm→µm.2; 0.018 mm→µm.2");
    row(
        "of an angle", of2006, hand, "instrumentResult",
        [](Setup &s) {
            s.m().axis.motion = Motion::rotary; // 0.018° are 64.8″
            s.test.imports = {{"x.rtl", "", {}, {{"A", 0.018, "mm"}, {"A", 36, "″"}}, {}}};
        },
        "A; 0.01°→″.2; 0.018°→″.2");
    row(
        "calibration", of2006, shortAxis, "calibrationDue",
        [](Setup &s) { s.laser.calibrationDue = "2026-11-19"; }, "laser interferometer");
    row(
        "limit of an edition", of2006, shortAxis, "limits",
        [](Setup &s) {
            s.test.limits = {{"A", {0.05, "ISO 230-2:1988", ""}}};
        },
        "A; ISO 230-2:1988; ISO 230-2:2006");
    row(
        "limit of no parameter", of2006, shortAxis, "limits",
        [](Setup &s) { s.test.limits["r"].value = 0.05; }, "r̄; ISO 230-2:2006");
    row(
        "negative limits", of2006, shortAxis, "limits",
        [](Setup &s) {
            s.test.limits["A"].value = -0.02;
            s.test.limits["E"].value = -0.01;
            s.test.limits["R"].value = 0.02;
        },
        "A, E");
    row(
        "large uncertainty", of2006, shortAxis, "largeUncertainty",
        [](Setup &s) { // U is 1 µm
            s.test.limits["A"].value = 0.001;
            s.test.limits["E"].value = 0.001;
            s.test.limits["R"].value = 1;
        },
        "A, E");
}

void Sentences::numbers() {
    QFETCH(Evaluate, evaluate);
    QFETCH(QByteArray, id);
    QFETCH(QByteArray, expected);
    const TestEvaluation evaluation = evaluate();
    QByteArrayList found;
    for (const Finding &one : evaluation.findings) {
        if (one.id == id.toStdString())
            found << written(one.message);
    }
    QVERIFY2(found.contains(expected), found.join(" | ").constData());
}

/// 810 − 798.763 is 11.236999999999966 in floating point; findings say 11.237.
void Sentences::differencesOfPositionsAreDecimals() {
    const auto value = [](Setup &setup, const char *id, std::size_t argument) {
        const TestEvaluation evaluation = setup.evaluated();
        const Finding *found = finding(evaluation, id);
        return found ? std::get<Number>(found->message.arguments[argument]).value : 0.0;
    };
    Setup ends = shortAxis("ISO 230-2:2006");
    ends.m().targets.back() = 798.763;
    ends.m().axis.range = Interval{3, 810};
    QCOMPARE(value(ends, "ends", 1), 11.237);
    Setup spacing = shortAxis("ISO 230-2:1988");
    spacing.m().targets = {0, 80, 160, 220.1, 320, 400.3};
    spacing.m().targetChoice.period = 1;
    QCOMPARE(value(spacing, "spacing", 0), 60.1);
    QCOMPARE(value(spacing, "spacing", 1), 99.9);
}

void Sentences::ofCircles_data() {
    QTest::addColumn<Evaluate>("evaluate");
    QTest::addColumn<QByteArray>("id");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char *name, const char *id, std::function<void(Circle &)> change,
                        const char *expected) {
        QTest::addRow("%s", name) << Evaluate([=] {
            Circle setup = circle();
            change(setup);
            return setup.evaluated();
        }) << QByteArray(id) << QByteArray(expected);
    };
    row(
        "short arc", "arcs", [](Circle &c) { c.m().arcs = {arc(Sense::clockwise, 0, 90)}; }, "YX; 89°.1");
    row(
        "against the sense", "arcs", [](Circle &c) { c.m().arcs[1].sense = Sense::counterclockwise; },
        "2; XY");
    row(
        "one sense", "bothSenses",
        [](Circle &c) {
            c.m().arcs.erase(c.m().arcs.begin());
            c.m().requiredResults = {"G(b)"};
        },
        "YX");
    row(
        "no circle", "minimumZone",
        [](Circle &c) {
            c.m().arcs[1].angles.resize(3);
            c.m().arcs[1].radialDeviations.resize(3);
        },
        "YX");
    row(
        "left-handed plane", "plane",
        [](Circle &c) {
            c.m().plane = {"Y", "X"};
        },
        "YX");
    row(
        "the air", "temperature", [](Circle &c) { c.common().sensors[2].end = 21.25; }, "21.25 °C");
    row(
        "another feed", "contouringFeed",
        [](Circle &c) {
            c.m().specified = {75, 1000}; // √(300/75) = 2 times as fast
            c.m().feed = 1000;
        },
        "1000 feed; 2000 feed.0");
    row(
        "another slow feed", "contouringFeed",
        [](Circle &c) {
            c.m().specified = {300, 10.2}; // 10 and 10: nobody would see why
            c.m().feed = 10;
        },
        "10 feed; 10.2 feed.1");
    row(
        "calibration", "calibrationDue", [](Circle &c) { c.bar.calibrationDate = "2026-11-21"; }, "ballbar");
}

QTEST_GUILESS_MAIN(Sentences)
#include "sentences.moc"
