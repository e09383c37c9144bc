// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/evaluation/circulardata.h"
#include "core/kernel/evaluation/positioningdata.h"

#include <QTest>
#include <set>

using namespace palmer;
using namespace palmer::testdata;

/// Findings beside the requirements of the editions (requirements.cpp): limits, uncertainty, correction.
class Findings : public QObject {
    Q_OBJECT

private slots:
    void limits();
    void limitsOfOtherEditions();
    void everyLimitHasAState_data();
    void everyLimitHasAState();
    void proofNeedsUncertainty();
    void uncorrectedResultsProveNothing();
    void whatIsNotProvenHasAReason_data();
    void whatIsNotProvenHasAReason();
    void anUnknownTemperatureProvesNothing();
    void temperaturesOfMachineAndInstrument_data();
    void temperaturesOfMachineAndInstrument();
    void workedExampleIsRecognised();
    void listsNameNothingTwice_data();
    void listsNameNothingTwice();
};

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
    QVERIFY(!finding(e, "limitScale"));
    test.limits = {{"A", {18.001, {}, ""}}}; // a value in µm, taken for mm
    QVERIFY(finding(evaluated(test), "limitScale"));
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
    QVERIFY(e.verdict == Verdict::notProven);                 // A was agreed, and nothing is known of it
    QVERIFY(e.limits.at(0).reason == NotEvaluable::otherEdition);
    const auto &arguments = finding(e, "limits")->message.arguments; // each language adds its article
    QVERIFY(arguments.at(1) == Argument(Designation{"ISO 230-2:1988"}));
    QVERIFY(arguments.at(2) == Argument(Designation{"ISO 230-2:2006"}));
    QVERIFY(e.limits.at(1).state == LimitState::respected);
}

void Findings::everyLimitHasAState_data() {
    QTest::addColumn<bool>("downward");
    QTest::addColumn<int>("runs"); // each way
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("state");
    QTest::addColumn<int>("reason"); // -1: none
    const auto row = [](const char *name, bool down, int runs, const char *key, LimitState state,
                        std::optional<NotEvaluable> reason) {
        QTest::newRow(name) << down << runs << key << static_cast<int>(state)
                            << (reason ? static_cast<int>(*reason) : -1);
    };
    row("A of five runs", true, 5, "A", LimitState::respected, {});
    row("A of one run", true, 1, "A", LimitState::notEvaluable, NotEvaluable::oneRun);
    row("B of one run", true, 1, "B", LimitState::respected, {});
    row("A of one direction", false, 5, "A", LimitState::notEvaluable, NotEvaluable::oneDirection);
    row("R- of one direction", false, 5, "R-", LimitState::notEvaluable, NotEvaluable::oneDirection);
    row("R+ of one direction", false, 5, "R+", LimitState::respected, {});
    row("r is of 1988", true, 5, "r", LimitState::notEvaluable, NotEvaluable::noSuchParameter);
}

/// No limit vanishes: two limits, and one that cannot be evaluated leaves the test not proven.
void Findings::everyLimitHasAState() {
    QFETCH(bool, downward);
    QFETCH(int, runs);
    QFETCH(QString, key);
    QFETCH(int, state);
    QFETCH(int, reason);
    Test test = exactHand("ISO 230-2:2006");
    std::vector<Run> kept;
    int up = 0;
    int down = 0;
    for (const Run &run : measurement(test).runs) {
        const bool isUp = run.approach == Direction::positive;
        if (isUp ? up++ < runs : downward && down++ < runs)
            kept.push_back(run);
    }
    measurement(test).runs = kept;
    test.limits = {{"E+", {1.0, {}, ""}}, {key.toStdString(), {1.0, {}, ""}}};
    const auto e = evaluated(test);
    QCOMPARE(e.limits.size(), std::size_t(2));
    for (const AgreedLimit &limit : e.limits) {
        if (limit.key != key.toStdString()) {
            QVERIFY(limit.state == LimitState::respected);
            continue;
        }
        QCOMPARE(static_cast<int>(limit.state), state);
        QCOMPARE(limit.reason ? static_cast<int>(*limit.reason) : -1, reason);
    }
    QVERIFY(e.verdict == (reason < 0 ? Verdict::conforms : Verdict::notProven));
}

void Findings::proofNeedsUncertainty() {
    Test test = exactHand("ISO 230-2:2006");
    test.limits = {{"A", {0.05, {}, ""}}};
    test.decisionRule = {Rule::iso14253_1, 1.0};
    QVERIFY(parameter(evaluated(test), "A")->verdict == Verdict::notProven);
    QVERIFY(finding(evaluated(test), "decisionRule"));
    measurement(test).uncertainty.method = UncertaintyMethod::direct;
    measurement(test).uncertainty.expanded = {{"A", 5.0}}; // µm
    measurement(test).conditions.common.correctionTo20 = CorrectionTo20::appliedByInstrument;
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
    QVERIFY(std::get<PositioningResults>(e.results).at20 == At20::wrong);
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
                conditions.expansion.instrument = 0;
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

/// An expansion that nobody knows raises a value as well as it lowers it.
void Findings::anUnknownTemperatureProvesNothing() {
    Test test = exactHand("ISO 230-2:2006");
    measurement(test).uncertainty.method = UncertaintyMethod::direct;
    measurement(test).uncertainty.expanded = {{"A", 0.4}, {"R", 0.4}};
    for (const double limit : {0.0001, 0.9}) {
        test.limits = {{"A", {limit, {}, ""}}, {"R", {limit, {}, ""}}};
        for (const Rule rule : {Rule::iso14253_1, Rule::rejectionProven}) {
            test.decisionRule = {rule, 1.0};
            QCOMPARE(parameter(evaluated(test), "A")->verdict, Verdict::notProven);
            QVERIFY(parameter(evaluated(test), "R")->verdict != Verdict::notProven);
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
        row(named("no temperature"), none, 0, 0, 11, 11, false, true);
        row(named("no temperature of the scale"), none, 20, 0, 11, 11, false, true);
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
    QCOMPARE(std::get<PositioningResults>(e.results).at20 == At20::hold, proves);
    QVERIFY(parameter(e, "A")->verdict == (proves ? Verdict::conforms : Verdict::notProven));
    QVERIFY(parameter(e, "R")->verdict == Verdict::conforms);
    const bool found =
        std::ranges::any_of(e.findings, [](const Finding &f) { return f.id == "correctionTo20"; });
    if (correction != static_cast<int>(CorrectionTo20::notStated) || finds)
        QCOMPARE(found, finds);
    measurement(test).axis.motion = Motion::rotary;
    QVERIFY(std::get<PositioningResults>(evaluated(test).results).at20 == At20::hold);
}

void Findings::workedExampleIsRecognised() {
    QVERIFY(finding(evaluated(example1988("ISO 230-2:1988")), "workedExample"));
    QVERIFY(finding(evaluated(example1988("ISO 230-2:2006")), "workedExample"));
    Test changed = example1988("ISO 230-2:1988");
    *measurement(changed).runs[1].deviations[5] += 0.0001;
    QVERIFY(!finding(evaluated(changed), "workedExample"));
}

void Findings::listsNameNothingTwice_data() {
    QTest::addColumn<QByteArray>("edition");
    for (const Edition *edition : editions())
        QTest::newRow(edition->word) << QByteArray(edition->word);
}

/// Tests that state nothing but their correction: their lists are the longest.
void Findings::listsNameNothingTwice() {
    QFETCH(const QByteArray, edition);
    const Edition *of = findEdition(edition.toStdString());
    std::vector<Test> tests;
    for (const auto correction : {CorrectionTo20::notStated, CorrectionTo20::notApplied,
                                  CorrectionTo20::appliedByInstrument, CorrectionTo20::appliedHere}) {
        if (of->kind == Kind::circular) {
            const auto round = [](double angle) { return angle / 360; };
            Test test = circularTest({pathOf(Sense::counterclockwise, 90, round)});
            test.edition = edition.toStdString();
            auto &measurement = std::get<CircularMeasurement>(test.measurement);
            measurement.requiredResults = {"F", "G"};
            measurement.conditions = {};
            measurement.conditions.common.correctionTo20 = correction;
            tests.push_back(test);
            continue;
        }
        for (const double travel : {400.0, 4000.0}) {
            for (const Motion motion : {Motion::linear, Motion::rotary}) {
                Test test =
                    positioningTest(edition, {0, travel / 2, travel}, {{0, 1, 2}, {1, 2, 3}}, {{0, 2, 4}});
                measurement(test).axis.motion = motion;
                measurement(test).conditions.common.correctionTo20 = correction;
                tests.push_back(test);
            }
        }
    }
    for (const Test &test : tests) {
        std::set<std::pair<std::string, QString>> named;
        for (const Finding &finding : evaluated(test).findings) {
            // Names of several parts are lists themselves.
            for (const QString &name :
                 QString::fromUtf8(finding.name.source).split(", ", Qt::SkipEmptyParts)) {
                const bool isNew = named.emplace(finding.message.text.source, name).second;
                QVERIFY2(isNew, qPrintable(name));
            }
        }
    }
}

QTEST_GUILESS_MAIN(Findings)
#include "findings.moc"
