#include "core/kernel/evaluation/positioningdata.h"

#include <QTest>

#include <functional>

using namespace palmer;
using namespace palmer::testdata;

/// Each requirement is shown by a test that meets all of them and one change that does not.
class Findings : public QObject {
    Q_OBJECT

private slots:
    void completeTestsAreInAccordance_data();
    void completeTestsAreInAccordance();
    void oneChangeOneFinding_data();
    void oneChangeOneFinding();
    void everyStatementIsAskedFor();
    void everyPointIsAskedFor();
    void limits();
    void limitsOfOtherEditions();
    void proofNeedsUncertainty();
    void uncorrectedResultsProveNothing();
    void whatIsNotProvenHasAReason_data();
    void whatIsNotProvenHasAReason();
    void temperaturesOfMachineAndInstrument_data();
    void temperaturesOfMachineAndInstrument();
    void workedExampleIsRecognised();
};

namespace {

struct Setup {
    Machine machine{"M", "maker", "type", "1", "", {}, "", ""};
    Instrument laser{"laser", "laser interferometer", "", "", "2", "C-1", "", "2026-01-01", {}, {}};
    Test test;
    bool otherTest = false;

    PositioningMeasurement &m() { return measurement(test); }
    Conditions &common() { return m().conditions.common; }

    [[nodiscard]] TestEvaluation evaluated(const char *edition = nullptr) const {
        Surroundings surroundings;
        surroundings.machine = &machine;
        surroundings.instruments = {&laser};
        surroundings.otherTestOfLongAxis = otherTest;
        return evaluateTest(test, surroundings, edition ? findEdition(edition) : nullptr);
    }
};

std::vector<std::vector<double>> readingsFor(std::size_t targets, int runs, unsigned seed) {
    std::vector<std::vector<double>> result;
    for (int j = 0; j < runs; ++j) {
        result.emplace_back();
        for (std::size_t i = 0; i < targets; ++i) {
            seed = seed * 1664525u + 1013904223u;
            result.back().push_back(static_cast<double>(seed >> 24) / 64);
        }
    }
    return result;
}

/// A test that states everything and meets every requirement of its edition.
Setup complete(const char *edition, std::vector<double> targets, int runs = 5) {
    Setup setup;
    const std::size_t m = targets.size();
    const double last = targets.back();
    setup.test =
        positioningTest(edition, std::move(targets), readingsFor(m, runs, 1), readingsFor(m, runs, 2));
    setup.test.date = "2026-11-20";
    setup.test.instruments = {"laser"};
    for (const AgreementPoint &point : findEdition(edition)->points)
        setup.test.agreedPoints.push_back({point.point, AgreementState::agreed, "as agreed"});
    PositioningMeasurement &p = setup.m();
    p.axis = {"X", Motion::linear, last + 20, Interval{-10, last + 10}, "linear scale"};
    p.targetChoice.kind = TargetChoiceKind::free;
    PositioningConditions &c = p.conditions;
    c.feed = 5000;
    c.dwell = 3;
    c.airPressure = 1013;
    c.airHumidity = 50;
    c.gradientPerHour = 0.2;
    Conditions &common = c.common;
    common.warmUp = {WarmUpKind::procedure, "60 min"};
    common.compensation = "pitch table";
    common.otherAxes = "Y 0";
    common.levelled = common.complete = common.unloaded = true;
    common.toolOffset = {0, 0, -120};
    common.workpieceOffset = {0, 0, 180};
    for (const auto what : {SensorMeasures::machine, SensorMeasures::instrument, SensorMeasures::air})
        common.sensors.push_back({what, "table", 20.0, 20.0, {}});
    common.expansion = {11.5, 0.0};
    common.correctionTo20 = CorrectionTo20::appliedByInstrument;
    p.uncertainty.method = UncertaintyMethod::direct;
    for (const Row &row : findEdition(edition)->rows)
        p.uncertainty.expanded[row.term.id] = 1.0;
    return setup;
}

Setup shortAxis(const char *edition) {
    return complete(edition, {3, 104, 207, 298, 402, 511});
}

Setup longAxis(const char *edition) {
    std::vector<double> targets;
    for (int i = 0; i <= 16; ++i)
        targets.push_back(i * 249.0 + 7 * (i % 3));
    Setup setup = complete(edition, std::move(targets), 1);
    setup.otherTest = true;
    return setup;
}

Setup zoneOfLongAxis(const char *edition) {
    Setup setup = complete(edition, {1005, 1198, 1401, 1622, 1809, 2011, 2230, 2390, 2604, 2797});
    setup.m().axis.travel = 4000;
    setup.m().axis.range = Interval{0, 4000};
    setup.m().zone = Interval{1000, 3000};
    setup.otherTest = true;
    return setup;
}

Setup rotary(const char *edition) {
    Setup setup = complete(edition, {0, 41, 90, 137, 180, 222, 270, 311, 350});
    setup.m().axis = {"C", Motion::rotary, 360.0, Interval{-5, 365}, "rotary encoder"};
    return setup;
}

using Change = std::function<void(Setup &)>;
using Make = std::function<Setup()>;

} // namespace

Q_DECLARE_METATYPE(Change)
Q_DECLARE_METATYPE(Make)

void Findings::completeTestsAreInAccordance_data() {
    QTest::addColumn<Make>("make");
    for (const char *edition :
         {"ISO 230-2:1988", "ISO 230-2:1997", "ISO 230-2:2006", "ISO 230-2:2014", "VDI/DGQ 3441:1977"}) {
        QTest::addRow("%s short", edition) << Make([edition] { return shortAxis(edition); });
        QTest::addRow("%s long", edition) << Make([edition] { return longAxis(edition); });
        QTest::addRow("%s zone", edition) << Make([edition] { return zoneOfLongAxis(edition); });
        QTest::addRow("%s rotary", edition) << Make([edition] { return rotary(edition); });
    }
}

void Findings::completeTestsAreInAccordance() {
    QFETCH(Make, make);
    const TestEvaluation evaluation = make().evaluated();
    QByteArrayList found;
    for (const Finding &f : evaluation.findings)
        found << QByteArray::fromStdString(f.id) + ": " + f.message.text.source;
    QVERIFY2(found.isEmpty(), found.join("; ").constData());
    QVERIFY(evaluation.inAccordance());
    QVERIFY(!evaluation.parameters.empty());
}

void Findings::oneChangeOneFinding_data() {
    QTest::addColumn<Make>("make");
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("grade");
    QTest::addColumn<QString>("clause");
    const auto row = [](const char *name, Make make, Change change, const char *id, Grade grade,
                        const char *clause) {
        QTest::newRow(name) << make << change << QString::fromUtf8(id) << static_cast<int>(grade)
                            << QString::fromUtf8(clause);
    };
    const auto requirement = Grade::requirement;
    const auto recommendation = Grade::recommendation;
    const auto note = Grade::note;
    const Make of1988 = [] { return shortAxis("ISO 230-2:1988"); };
    const Make of2006 = [] { return shortAxis("ISO 230-2:2006"); };
    const Make of2014 = [] { return shortAxis("ISO 230-2:2014"); };
    const Make long1988 = [] { return longAxis("ISO 230-2:1988"); };
    const Make long2006 = [] { return longAxis("ISO 230-2:2006"); };
    const Make zone1988 = [] { return zoneOfLongAxis("ISO 230-2:1988"); };
    const Make zone2006 = [] { return zoneOfLongAxis("ISO 230-2:2006"); };
    const Make rotary1988 = [] { return rotary("ISO 230-2:1988"); };
    const Make rotary2006 = [] { return rotary("ISO 230-2:2006"); };

    const Change dropTargets = [](Setup &s) {
        s.m().targets.resize(4);
        for (Run &run : s.m().runs)
            run.deviations.resize(4);
    };
    const Change dropRun = [](Setup &s) { s.m().runs.pop_back(); };
    const Change dropDown = [](Setup &s) {
        std::erase_if(s.m().runs, [](const Run &r) { return r.approach == Direction::negative; });
    };

    // targets
    row("four targets", of2006, dropTargets, "numberOfTargets", requirement, "4.3.2");
    row(
        "six targets on 1.9 m", of1988, [](Setup &s) { s.m().axis.travel = 1900; }, "targetsPerMetre",
        requirement, "4.3.2");
    row(
        "no clause in 2014", of2014, [](Setup &s) { s.m().axis.travel = 1900; }, "targetsPerMetre",
        requirement, "");
    row(
        "axis travel not stated", of2006, [](Setup &s) { s.m().axis.travel.reset(); }, "travel", requirement,
        "");
    row(
        "first target at the end", of2006, [](Setup &s) { s.m().axis.range->from = 3; }, "ends", requirement,
        "2.2");
    row(
        "approach distance beyond the end", of2006, [](Setup &s) { s.m().conditions.approachDistance = 15; },
        "ends", requirement, "2.2");
    row(
        "ends not stated", of2006, [](Setup &s) { s.m().axis.range.reset(); }, "ends", note, "2.2");
    row(
        "even spacing", of2006, [](Setup &s) { s.m().targets = {0, 100, 200.5, 300, 400, 500}; },
        "evenSpacing", recommendation, "4.2");
    row(
        "whole multiples of the period", of1988,
        [](Setup &s) {
            s.m().targets = {0, 100, 210, 290, 420, 500};
            s.m().targetChoice.period = 10;
        },
        "evenSpacing", recommendation, "4.2");
    row(
        "random part too large", of2006,
        [](Setup &s) {
            s.m().targetChoice.interval = 100;
            s.m().targets[5] = 570;
        },
        "targetChoice", recommendation, "4.2");
    row(
        "long axis, wide intervals, 1988", long1988, [](Setup &s) { s.m().targets[16] += 250; },
        "meanInterval", requirement, "4.3.3");
    row(
        "long axis, wide intervals, 2006: practice", long2006, [](Setup &s) { s.m().targets[16] += 250; },
        "meanInterval", note, "");
    row(
        "long axis, half of it", long1988, [](Setup &s) { s.m().axis.travel = 8000; }, "wholeLength",
        requirement, "4.3.3");
    row(
        "long axis alone", long2006, [](Setup &s) { s.otherTest = false; }, "otherTest", requirement, "");
    row(
        "zone alone", zone1988, [](Setup &s) { s.otherTest = false; }, "otherTest", requirement, "4.3.3");
    row(
        "zone of 1.8 m, 1988", zone1988, [](Setup &s) { s.m().zone->to = 2800; }, "zone", requirement,
        "4.3.3");
    row(
        "zone of 1.8 m, 2006: practice", zone2006, [](Setup &s) { s.m().zone->to = 2800; }, "zone", note, "");
    row("zone judged by its own length", zone2006, dropTargets, "targetsPerMetre", requirement, "4.3.2");
    row(
        "rotary without 90°", rotary1988, [](Setup &s) { s.m().targets[2] = 91; }, "quarterTurns",
        requirement, "4.3.4");
    row("rotary, few targets, 2006: practice", rotary2006, dropTargets, "numberOfTargets", note, "");
    // runs and readings
    row("four runs down", of1988, dropRun, "approaches", requirement, "4.3.2");
    row("four runs down, 2006", of2006, dropRun, "approaches", requirement, "4.3.2");
    row("one direction", of2006, dropDown, "approaches", requirement, "4.3.2");
    row("rotary, one direction, 2006: practice", rotary2006, dropDown, "approaches", note, "");
    row("long axis, one direction", long1988, dropDown, "approaches", requirement, "4.3.3");
    row("unequal runs", of2006, dropRun, "unequalRuns", note, "");
    row(
        "missing reading", of2006, [](Setup &s) { s.m().runs[2].deviations[1].reset(); }, "missingReadings",
        requirement, "4.3.2");
    row(
        "missing reading, five left", of2006,
        [](Setup &s) {
            s.m().runs.push_back(s.m().runs[0]);
            s.m().runs.push_back(s.m().runs[1]);
            s.m().runs[2].deviations[1].reset();
        },
        "missingReadings", note, "");
    row(
        "reading set aside", of2006,
        [](Setup &s) {
            s.m().runs.push_back(s.m().runs[0]);
            s.m().runs[2].deviations[1].reset();
            s.m().excluded = {{3, 2, 0.1, "beam interrupted"}};
        },
        "excluded", requirement, "");
    row(
        "reading set aside without reason", of1988,
        [](Setup &s) {
            s.m().runs[2].deviations[1].reset();
            s.m().excluded = {{3, 2, 0.1, ""}};
        },
        "excluded", requirement, "");
    row(
        "range method in 2006", of2006, [](Setup &s) { s.m().standardDeviation = DeviationMethod::range; },
        "standardDeviation", requirement, "2.15");
    row(
        "step cycle without agreement", of2006,
        [](Setup &s) {
            s.m().cycle = Cycle::step;
            std::erase_if(s.test.agreedPoints, [](const auto &p) { return p.point == "stepCycle"; });
        },
        "cycle", requirement, "");
    row(
        "drift", of2006,
        [](Setup &s) {
            for (std::size_t k = 0; k < s.m().runs.size(); ++k)
                for (auto &x : s.m().runs[k].deviations)
                    x = 0.01 * static_cast<double>(k / 2);
        },
        "drift", note, "3.3");
    // conditions
    row(
        "cold shop, 1988", of1988, [](Setup &s) { s.common().sensors[2].end = 18.9; }, "temperature",
        recommendation, "3.1");
    row(
        "not corrected, 1988", of1988,
        [](Setup &s) {
            s.common().sensors[0].end = 23;
            s.common().correctionTo20 = CorrectionTo20::notApplied;
        },
        "correctionTo20", requirement, "3.1");
    row(
        "not corrected, 2006", of2006,
        [](Setup &s) {
            s.common().sensors[0].end = 20.2;
            s.common().correctionTo20 = CorrectionTo20::notApplied;
        },
        "correctionTo20", requirement, "3.1");
    row(
        "applied here without expansion", of2006,
        [](Setup &s) {
            s.common().correctionTo20 = CorrectionTo20::appliedHere;
            s.common().expansion.instrument.reset();
        },
        "correctionTo20", requirement, "3.1");
    row(
        "applied here to a rotary axis", rotary2006,
        [](Setup &s) { s.common().correctionTo20 = CorrectionTo20::appliedHere; }, "correctionTo20", note,
        "");
    row(
        "expansion known too well", of2006, [](Setup &s) { s.m().uncertainty.expansionRange.machine = 1.0; },
        "expansionRange", note, "3.1");
    row(
        "incomplete machine", of2006, [](Setup &s) { s.common().complete = false; }, "complete", requirement,
        "3.2");
    row(
        "machine not levelled", of1988, [](Setup &s) { s.common().levelled = false; }, "levelled",
        requirement, "3.2");
    row(
        "loaded machine", of2006, [](Setup &s) { s.common().unloaded = false; }, "unloaded", requirement,
        "3.2");
    row(
        "compensation not stated, 1988", of1988, [](Setup &s) { s.common().compensation.clear(); },
        "compensation", requirement, "7");
    row(
        "compensation not stated, 2006", of2006, [](Setup &s) { s.common().compensation.clear(); },
        "compensation", recommendation, "3.2");
    row(
        "dry run without agreement, 1988", of1988,
        [](Setup &s) {
            s.common().warmUp = {WarmUpKind::dryRun, "10 times"};
            s.test.agreedPoints[2].state = AgreementState::notApplicable;
        },
        "warmUp", requirement, "3.3");
    row(
        "procedure without a word", of2006,
        [](Setup &s) {
            s.common().warmUp.text.clear();
            s.test.agreedPoints[2].state = AgreementState::notApplicable;
        },
        "warmUp", requirement, "3.3");
    row(
        "no uncertainty", of2006, [](Setup &s) { s.m().uncertainty.method = UncertaintyMethod::none; },
        "uncertainty", requirement, "");
}

void Findings::oneChangeOneFinding() {
    QFETCH(Make, make);
    QFETCH(Change, change);
    QFETCH(QString, id);
    QFETCH(int, grade);
    QFETCH(QString, clause);
    Setup setup = make();
    change(setup);
    const TestEvaluation evaluation = setup.evaluated();
    const Finding *found = finding(evaluation, id.toStdString());
    QVERIFY2(found, qPrintable(id));
    QCOMPARE(static_cast<int>(found->grade), grade);
    QCOMPARE(QString::fromStdString(found->clause), clause);
    QVERIFY(!found->message.text.empty());
    // every placeholder has its argument
    const QByteArray source(found->message.text.source);
    for (int k = 1; k <= 9; ++k)
        QCOMPARE(source.contains('%' + QByteArray::number(k)),
                 k <= static_cast<int>(found->message.arguments.size()));
    QCOMPARE(source.contains("%n"), found->message.count.has_value());
    if (grade == static_cast<int>(Grade::requirement))
        QVERIFY(!evaluation.inAccordance());
}

void Findings::everyStatementIsAskedFor() {
    // an empty test misses them all; the ids are the keys of the file
    Setup setup;
    setup.machine = {};
    setup.laser = {};
    setup.test = positioningTest("ISO 230-2:1988", {0, 1}, {{1, 2}}, {{1, 2}});
    const TestEvaluation evaluation = setup.evaluated();
    for (const char *id :
         {"date",         "manufacturer",    "model",           "serialNumber",   "positionFeedback",
          "targetChoice", "certificate",     "calibrationDate", "toolOffset",     "workpieceOffset",
          "otherAxes",    "sensors",         "expansion",       "correctionTo20", "airPressure",
          "airHumidity",  "gradientPerHour", "compensation",    "warmUp",         "feed",
          "dwell",        "unloaded",        "complete",        "levelled",       "travel"}) {
        const Finding *found = finding(evaluation, id);
        QVERIFY2(found && found->grade == Grade::requirement, id);
    }
    Surroundings none;
    none.machine = &setup.machine;
    QVERIFY(finding(evaluateTest(setup.test, none), "instruments"));
}

void Findings::everyPointIsAskedFor() {
    for (const char *edition : {"ISO 230-2:1988", "ISO 230-2:2006"}) {
        const auto none = evaluated(positioningTest(edition, {0, 1}, {{1, 2}}, {{1, 2}}));
        for (const AgreementPoint &point : findEdition(edition)->points) {
            const Finding *found = finding(none, std::string("agreedPoints.") + point.point);
            QVERIFY(found && found->grade == Grade::recommendation);
            QCOMPARE(found->clause, std::string(findEdition(edition)->pointsClause));
        }
    }
}

void Findings::limits() {
    Test test = exactHand("ISO 230-2:2006");
    test.limits = {
        {"A", {0.018, {}, ""}}, {"Bmean", {0.0019, {}, ""}}, {"E", {{}, {}, ""}}, {"r", {0.1, {}, ""}}};
    const auto e = evaluated(test);
    QVERIFY(parameter(e, "A")->verdict == Verdict::conforms); // 18 ≤ 18, exact in decimals
    QVERIFY(parameter(e, "Bmean")->verdict == Verdict::doesNotConform);
    QVERIFY(!parameter(e, "E")->verdict && !parameter(e, "E")->limit);
    QVERIFY(e.verdict == Verdict::doesNotConform);
    QVERIFY(finding(e, "limits")); // r is of 1988
    // a view has no verdicts
    const auto view = evaluated(test, "ISO 230-2:2014");
    QVERIFY(view.view && !view.verdict && !parameter(view, "A")->limit);
    QVERIFY(!finding(view, "limits"));
    QVERIFY(!evaluated(test, "ISO 230-2:2006").view);
}

void Findings::limitsOfOtherEditions() {
    Test test = exactHand("ISO 230-2:2006");
    test.limits = {{"A", {0.05, "ISO 230-2:1988", ""}}, {"E", {0.05, "GB/T 17421.2-2016", ""}}};
    const auto e = evaluated(test);
    QVERIFY(!parameter(e, "A")->verdict);
    QVERIFY(finding(e, "limits"));
    QVERIFY(parameter(e, "E")->verdict == Verdict::conforms); // an alias counts as the edition
    QVERIFY(e.verdict == Verdict::conforms);
}

void Findings::proofNeedsUncertainty() {
    Test test = exactHand("ISO 230-2:2006");
    test.limits = {{"A", {0.05, {}, ""}}};
    test.decisionRule = {Rule::iso14253_1, 1.0};
    QVERIFY(parameter(evaluated(test), "A")->verdict == Verdict::notProven);
    QVERIFY(finding(evaluated(test), "decisionRule"));
    measurement(test).uncertainty.method = UncertaintyMethod::direct;
    measurement(test).uncertainty.expanded = {{"A", 5.0}}; // µm
    const auto e = evaluated(test);
    QVERIFY(parameter(e, "A")->verdict == Verdict::conforms);
    QCOMPARE(*parameter(e, "A")->guardBand, 0.005);
    QVERIFY(!finding(e, "decisionRule"));
}

void Findings::uncorrectedResultsProveNothing() {
    Test test = exactHand("ISO 230-2:2006");
    test.limits = {{"A", {0.05, {}, ""}}, {"R", {0.05, {}, ""}}};
    measurement(test).uncertainty.method = UncertaintyMethod::direct;
    measurement(test).uncertainty.expanded = {{"A", 1.0}, {"R", 1.0}};
    measurement(test).conditions.common.sensors = {{SensorMeasures::machine, "", 24.0, 24.0, {}}};
    QVERIFY(parameter(evaluated(test), "A")->verdict == Verdict::conforms); // simple acceptance
    test.decisionRule = {Rule::iso14253_1, 1.0};
    const auto e = evaluated(test);
    QVERIFY(std::get<PositioningResults>(e.results).notCorrected);
    QVERIFY(parameter(e, "A")->verdict == Verdict::notProven);
    QVERIFY(parameter(e, "R")->verdict == Verdict::conforms); // repeatability does not depend on it
}

void Findings::whatIsNotProvenHasAReason_data() {
    QTest::addColumn<QByteArray>("edition");
    for (const Edition *edition : editions()) {
        if (edition->kind == Kind::positioning)
            QTest::newRow(edition->word) << QByteArray(edition->word);
    }
}

/// At every temperature, across the tolerances of every edition: where A is not proven because it is not
/// corrected a finding says so, and only there.
void Findings::whatIsNotProvenHasAReason() {
    QFETCH(QByteArray, edition);
    for (int step = -20; step <= 20; ++step) {
        for (const CorrectionTo20 correction :
             {CorrectionTo20::notApplied, CorrectionTo20::appliedByInstrument, CorrectionTo20::appliedHere}) {
            for (const Rule rule : {Rule::simpleAcceptance, Rule::iso14253_1, Rule::rejectionProven}) {
                Test test = exactHand(edition);
                const bool vdi = parameter(evaluated(test), "A") == nullptr;
                const std::string id = vdi ? "P" : "A";
                test.limits = {{id, {0.05, {}, ""}}};
                measurement(test).uncertainty.method = UncertaintyMethod::direct;
                measurement(test).uncertainty.expanded = {{id, 1.0}};
                Conditions &conditions = measurement(test).conditions.common;
                const double temperature = 20 + step * 0.051; // 0.05 °C rounds to 20
                conditions.sensors = {{SensorMeasures::machine, "", temperature, temperature, {}}};
                conditions.correctionTo20 = correction;
                test.decisionRule = {rule, 1.0};
                const auto e = evaluated(test);
                const bool open = parameter(e, id)->verdict == Verdict::notProven;
                const bool said = std::ranges::any_of(e.findings, [](const Finding &finding) {
                    return std::string_view(finding.message.text.source).starts_with("Nothing is proven for");
                });
                const QByteArray where = QByteArray::number(temperature) + ' ' +
                                         QByteArray::number(static_cast<int>(correction)) + ' ' +
                                         QByteArray::number(static_cast<int>(rule));
                QVERIFY2(said == open, where);
                const bool fits = rule == Rule::simpleAcceptance ||
                                  correction == CorrectionTo20::appliedByInstrument || step == 0;
                if (correction != CorrectionTo20::appliedHere) // which lacks α here
                    QVERIFY2(open != fits, where);
            }
        }
    }
}

void Findings::temperaturesOfMachineAndInstrument_data() {
    QTest::addColumn<int>("correction");
    QTest::addColumn<double>("machine"); // 0: not stated, as below
    QTest::addColumn<double>("instrument");
    QTest::addColumn<double>("alphaMachine"); // −1: not stated
    QTest::addColumn<double>("alphaInstrument");
    QTest::addColumn<bool>("proves");
    QTest::addColumn<bool>("finds");
    const auto row = [](const char *name, CorrectionTo20 correction, double machine, double instrument,
                        double alphaMachine, double alphaInstrument, bool proves, bool finds) {
        QTest::newRow(name) << static_cast<int>(correction) << machine << instrument << alphaMachine
                            << alphaInstrument << proves << finds;
    };
    for (const auto none : {CorrectionTo20::notApplied, CorrectionTo20::notStated}) {
        const bool stated = none == CorrectionTo20::notApplied;
        const auto named = [&](const char *name) {
            return QByteArray(name) + (stated ? ", not applied" : ", not stated");
        };
        row(named("both at 20"), none, 20, 20, 11, 11, true, false);
        row(named("machine 24"), none, 24, 0, -1, -1, false, true);
        row(named("scale 30, machine 20"), none, 20, 30, 11, 11, false, true);
        row(named("scale 30, machine not stated"), none, 0, 30, 11, 11, false, true);
        row(named("scale 30, coefficient not stated"), none, 20, 30, 11, -1, false, true);
        row(named("laser 30: its coefficient is 0"), none, 20, 30, 11, 0, true, false);
        row(named("both 30, equal coefficients"), none, 30, 30, 11, 11, true, false);
        row(named("both 30, coefficients not stated"), none, 30, 30, -1, -1, false, true);
        row(named("20.05 prints as 20.0"), none, 20.05, 20, 11, 11, true, false);
        row(named("19.95 prints as 20.0"), none, 19.95, 20, 11, 11, true, false);
        row(named("20.06"), none, 20.06, 20, 11, 11, false, true);
        row(named("19.94"), none, 19.94, 20, 11, 11, false, true);
        // over the 100 mm of the test 0.05 µm is 0.5 µm/m
        row(named("difference of 0.049 µm"), none, 30, 30, 11, 11.049, true, false);
        row(named("difference of 0.051 µm"), none, 30, 30, 11, 11.051, false, true);
        row(named("difference of −0.051 µm"), none, 30, 30, 11.051, 11, false, true);
        row(named("no temperature"), none, 0, 0, 11, 11, true, false);
    }
    constexpr auto here = CorrectionTo20::appliedHere;
    row("here, all known", here, 24, 24, 11, 8, true, false);
    row("here, laser", here, 24, 0, 11, 0, true, false);
    row("here, no temperature", here, 0, 0, 11, 0, false, true);
    row("here, no coefficient", here, 24, 24, -1, 0, false, true);
    row("here, scale's temperature missing", here, 24, 0, 11, 11, false, true);
    row("by the instrument", CorrectionTo20::appliedByInstrument, 24, 30, -1, -1, true, false);
}

void Findings::temperaturesOfMachineAndInstrument() {
    QFETCH(int, correction);
    QFETCH(double, machine);
    QFETCH(double, instrument);
    QFETCH(double, alphaMachine);
    QFETCH(double, alphaInstrument);
    QFETCH(bool, proves);
    QFETCH(bool, finds);
    Test test =
        positioningTest("ISO 230-2:2006", {0, 50, 100}, {{0, 1, 2}, {1, 1, 3}}, {{1, 2, 3}, {1, 3, 3}});
    test.limits = {{"A", {0.05, {}, ""}}, {"R", {0.05, {}, ""}}};
    test.decisionRule = {Rule::iso14253_1, 1.0};
    measurement(test).uncertainty.method = UncertaintyMethod::direct;
    measurement(test).uncertainty.expanded = {{"A", 1.0}, {"R", 1.0}};
    Conditions &conditions = measurement(test).conditions.common;
    conditions.correctionTo20 = static_cast<CorrectionTo20>(correction);
    if (machine > 0)
        conditions.sensors.push_back({SensorMeasures::machine, "", machine, machine, {}});
    if (instrument > 0)
        conditions.sensors.push_back({SensorMeasures::instrument, "", instrument, instrument, {}});
    if (alphaMachine >= 0)
        conditions.expansion.machine = alphaMachine;
    if (alphaInstrument >= 0)
        conditions.expansion.instrument = alphaInstrument;
    const auto e = evaluated(test);
    QCOMPARE(std::get<PositioningResults>(e.results).notCorrected, !proves);
    QVERIFY(parameter(e, "A")->verdict == (proves ? Verdict::conforms : Verdict::notProven));
    QVERIFY(parameter(e, "R")->verdict == Verdict::conforms);
    const bool found = std::ranges::any_of(e.findings, [](const Finding &f) {
        return f.id == "correctionTo20" && QString::fromUtf8(f.message.text.source).contains(u"20 °C");
    });
    if (correction != static_cast<int>(CorrectionTo20::notStated) || finds)
        QCOMPARE(found, finds);
    measurement(test).axis.motion = Motion::rotary;
    QVERIFY(!std::get<PositioningResults>(evaluated(test).results).notCorrected);
}

void Findings::workedExampleIsRecognised() {
    QVERIFY(finding(evaluated(example1988("ISO 230-2:1988")), "workedExample"));
    QVERIFY(finding(evaluated(example1988("ISO 230-2:2006")), "workedExample"));
    Test changed = example1988("ISO 230-2:1988");
    *measurement(changed).runs[1].deviations[5] += 0.0001;
    QVERIFY(!finding(evaluated(changed), "workedExample"));
}

QTEST_GUILESS_MAIN(Findings)
#include "findings.moc"
