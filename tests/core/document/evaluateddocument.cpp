// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/evaluateddocument.h"

#include "core/kernel/evaluation/circulardata.h"
#include "core/kernel/evaluation/positioningdata.h"
#include "document/comparedtests.h"
#include "document/edits.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <set>

using namespace palmer;
using namespace palmer::testdata;

namespace {

using Edit = std::function<void(Document &)>;

/// Targets over `travel` mm, two runs up and two down.
Test axisTest(double travel = 400) {
    Test test = positioningTest("ISO 230-2:2014", {0, travel / 4, travel / 2, travel},
                                {{0, 1, 2, 3}, {1, 2, 3, 4}}, {{0, 2, 2, 4}, {1, 1, 3, 3}});
    measurement(test).axis.travel = travel;
    return test;
}

Test circleTest() {
    const auto round = [](double angle) { return std::cos(2 * angle); };
    return circularTest({pathOf(Sense::counterclockwise, 90, round), pathOf(Sense::clockwise, 90, round)});
}

Test driftTest(const char *id, double range, Motion motion = Motion::linear) {
    DriftMeasurement drift;
    drift.axis.motion = motion;
    drift.times = {0, 1, 2};
    drift.deviations = {0, range, range / 2};
    Test test;
    test.id = id;
    test.measurement = drift;
    return test;
}

/// All that a budget of ISO/TR 230-9 asks for.
PositioningUncertaintyInputs inputs() {
    PositioningUncertaintyInputs known;
    known.method = UncertaintyMethod::budget;
    known.device.kind = DeviceKind::certificate;
    known.device.fixed = 0.5;
    known.device.perMetre = 0;
    known.misalignmentRange = 0.1;
    known.temperatureRange = {0, 0}; // measured at 20 °C throughout
    known.expansionRange = {0, 0};
    known.environmentalVariation = 1;
    known.trials = 2000;
    return known;
}

Limit limitOf(double value) {
    Limit limit;
    limit.value = value;
    return limit;
}

bool sameNumbers(const TestEvaluation &a, const TestEvaluation &b) {
    return std::ranges::equal(a.parameters, b.parameters, [](const Parameter &x, const Parameter &y) {
        return parameterId(x) == parameterId(y) && x.value == y.value &&
               x.expandedUncertainty == y.expandedUncertainty && x.verdict == y.verdict;
    });
}

std::shared_ptr<const Document> documentOf(std::initializer_list<Test> tests) {
    auto document = std::make_shared<Document>();
    for (const Test &test : tests)
        document->tests.push_back(std::make_shared<const Test>(test));
    return document;
}

std::shared_ptr<const Document> edited(const EvaluatedDocument &evaluated, const Edit &edit) {
    auto document = std::make_shared<Document>(*evaluated.document);
    edit(*document);
    return document;
}

EvaluatedDocument withEdit(const EvaluatedDocument &evaluated, const Edit &edit) {
    return evaluate(edited(evaluated, edit), &evaluated);
}

} // namespace

class EvaluatedDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void aViewIsOfTheTestsOfItsKind() {
        const auto document = documentOf({axisTest(), circleTest(), driftTest("d", 0.001)});
        const EvaluatedDocument own = evaluate(document);
        QCOMPARE(own.tests[0]->edition, findEdition("ISO 230-2:2014"));
        QCOMPARE(own.tests[1]->edition, findEdition("ISO 230-4:2005"));
        QVERIFY(!own.tests[2]->edition);
        const EvaluatedDocument view = evaluate(document, &own, "ISO 230-2:2006");
        QCOMPARE(view.tests[0]->edition, findEdition("ISO 230-2:2006"));
        QVERIFY(view.tests[0]->view);
        QCOMPARE(view.tests[1], own.tests[1]); // the very same
        QCOMPARE(evaluate(document, &view).tests[0]->edition, findEdition("ISO 230-2:2014"));
    }

    void eachTestHasAnEditionOfItsOwnOrNone() {
        const auto document = documentOf({axisTest(), circleTest(), axisTest()});
        const std::vector<std::string> editions{"", "ISO 230-4:1996"}; // none for the last
        const EvaluatedDocument evaluated = evaluateUnder(document, editions);
        QCOMPARE(evaluated.tests[0]->edition, findEdition("ISO 230-2:2014"));
        QCOMPARE(evaluated.tests[1]->edition, findEdition("ISO 230-4:1996"));
        QCOMPARE(evaluated.tests[2]->edition, findEdition("ISO 230-2:2014"));
        const EvaluatedDocument awaiting = awaitingResults(document, editions, {});
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(awaiting.tests[i]->edition, evaluated.tests[i]->edition);
    }

    void aPreviousWithoutDocumentCountsAsNone() {
        const EvaluatedDocument none;
        const auto document = documentOf({axisTest()});
        QCOMPARE(evaluate(document, &none).tests[0]->parameters.size(),
                 evaluate(document).tests[0]->parameters.size());
    }

    /// Notes of the laboratory, and only where it states an accreditation.
    void anAccreditedLaboratoryIsToldWhatItsCertificateLacks() {
        Document document = *documentOf({axisTest()});
        document.instruments.emplace_back().id = "laser";
        editTest(document, 0, [](Test &test) { test.instruments = {"laser"}; });
        const auto lacking = [&] {
            std::set<std::string> keys;
            const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
            for (const Finding &finding : evaluated.tests[0]->findings) {
                if (finding.id == std::string_view("accredited") && finding.source == Source::laboratory &&
                    !finding.state)
                    keys.insert(finding.keys.front());
            }
            return keys;
        };
        QVERIFY(lacking().empty());
        document.report.laboratory.accreditation = "2-0001";
        editMeasurement<PositioningMeasurement>(
            document, 0, [](auto &measured) { measured.uncertainty.method = UncertaintyMethod::none; });
        const std::pair<const char *, Edit> statements[]{
            {"report.laboratory.address", [](Document &d) { d.report.laboratory.address = "Street 1"; }},
            {"report.number", [](Document &d) { d.report.number = "R-1"; }},
            {"report.date", [](Document &d) { d.report.date = "2026-11-20"; }},
            {"report.place", [](Document &d) { d.report.place = "Hall 2"; }},
            {"report.customer",
             [](Document &d) {
                 d.report.customer = {"Customer", "Street 2"};
             }},
            {"report.authorisedBy", [](Document &d) { d.report.authorisedBy.name = "B. Durand"; }},
            {"machine.condition", [](Document &d) { d.machine.condition = "new"; }},
            {"instruments.calibratedBy", [](Document &d) { d.instruments[0].calibratedBy = "Institute"; }},
            {"uncertainty.method",
             [](Document &d) {
                 editMeasurement<PositioningMeasurement>(
                     d, 0, [](auto &measured) { measured.uncertainty.method = UncertaintyMethod::budget; });
             }},
        };
        QCOMPARE(lacking().size(), std::size(statements));
        for (const auto &[key, state] : statements) {
            QVERIFY2(lacking().contains(key), key);
            state(document);
            QVERIFY2(!lacking().contains(key), key);
        }
    }

    void onlyWhatAnEvaluationSeesMakesItAnew_data() {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<bool>("kept");
        const auto row = [](const char *name, bool kept, Edit edit) {
            QTest::newRow(name) << std::move(edit) << kept;
        };
        row("another test", true, [](Document &d) { editTest(d, 1, [](Test &t) { t.title = "b"; }); });
        row("the test", false, [](Document &d) { editTest(d, 0, [](Test &t) { t.title = "b"; }); });
        row("the number of the report", true, [](Document &d) { d.report.number = "7"; });
        row("an instrument it does not name", true, [](Document &d) { d.instruments[1].model = "b"; });
        row("its instrument", false, [](Document &d) { d.instruments[0].model = "b"; });
        row("its instrument is gone", false, [](Document &d) { d.instruments.erase(d.instruments.begin()); });
        row("the machine", false, [](Document &d) { d.machine.name = "b"; });
        row("the date of the report", false, [](Document &d) { d.report.date = "2026-01-02"; });
        row("performed from", false, [](Document &d) { d.report.performedFrom = "2026-01-01"; });
        row("performed to", false, [](Document &d) { d.report.performedTo = "2026-01-01"; });
        row("an accreditation", false, [](Document &d) { d.report.laboratory.accreditation = "2"; });
        row("adjustments", false, [](Document &d) { d.report.adjustments = "screw"; });
        row("a logo that is none", false, [](Document &d) { d.report.laboratory.logo = "AAAA"; });
        row("a mark that is none", false, [](Document &d) { d.report.laboratory.mark = "AAAA"; });
        row("no logo", true, [](Document &d) { d.report.laboratory.logo = ""; });
        row("its drift test", false,
            [](Document &d) { d.tests[2] = std::make_shared<const Test>(driftTest("drift", 0.003)); });
        row("the title of its drift test", true,
            [](Document &d) { editTest(d, 2, [](Test &t) { t.title = "b"; }); });
        row("a drift test of an angle", false, [](Document &d) {
            d.tests[2] = std::make_shared<const Test>(driftTest("drift", 0.002, Motion::rotary));
        });
        row("the test again", false,
            [](Document &d) { d.tests.push_back(std::make_shared<const Test>(axisTest())); });
        row("a test of another axis", true, [](Document &d) {
            Test other = axisTest();
            measurement(other).axis.name = "Y";
            d.tests.push_back(std::make_shared<const Test>(other));
        });
    }

    void onlyWhatAnEvaluationSeesMakesItAnew() {
        QFETCH(Edit, edit);
        QFETCH(bool, kept);
        Test test = axisTest();
        test.instruments = {"laser"};
        measurement(test).uncertainty.driftTest = "drift";
        auto document =
            std::make_shared<Document>(*documentOf({test, circleTest(), driftTest("drift", 0.002)}));
        document->instruments.resize(2);
        document->instruments[0].id = "laser";
        document->instruments[1].id = "ballbar";
        const EvaluatedDocument before = evaluate(document);
        const EvaluatedDocument after = withEdit(before, edit);
        QCOMPARE(after.tests[0] == before.tests[0], kept);
        // Kept or made anew, it says what a first evaluation says.
        const EvaluatedDocument fresh = evaluate(after.document);
        QVERIFY(after.tests[0]->findings == fresh.tests[0]->findings);
        QVERIFY(sameNumbers(*after.tests[0], *fresh.tests[0]));
    }

    /// 4.3.3: of a long axis the whole travel and a zone of 2 000 mm are tested.
    void aLongAxisHasTwoTests() {
        const auto lacksOther = [](const std::shared_ptr<const Document> &document) {
            return finding(*evaluate(document).tests[0], "otherTest") != nullptr;
        };
        const Test whole = axisTest(4000);
        Test zone = axisTest(2000);
        measurement(zone).axis.travel = 4000;
        measurement(zone).zone = Interval{0, 2000};
        Test other = zone;
        measurement(other).axis.name = "Y";
        Test rotary = zone;
        measurement(rotary).axis.motion = Motion::rotary;
        QVERIFY(lacksOther(documentOf({whole})));
        QVERIFY(lacksOther(documentOf({whole, whole})));
        QVERIFY(lacksOther(documentOf({whole, other})));
        QVERIFY(lacksOther(documentOf({whole, rotary})));
        QVERIFY(lacksOther(documentOf({whole, circleTest()})));
        QVERIFY(!lacksOther(documentOf({whole, zone})));
        QVERIFY(!lacksOther(documentOf({zone, whole})));
        QVERIFY(lacksOther(documentOf({zone, zone})));
    }

    /// Of two tests of one axis, plane and edition one is the one before.
    void whatIsRepeatedIsAskedForItsRole() {
        const auto asks = [](const Test &first, const Test &second) {
            const EvaluatedDocument evaluated = evaluate(documentOf({first, second}));
            const bool one = finding(*evaluated.tests[0], "role") != nullptr;
            const bool other = finding(*evaluated.tests[1], "role") != nullptr;
            return one && (other || !evaluated.tests[1]->edition);
        };
        const Test axis = axisTest();
        QVERIFY(asks(axis, axis));
        Test changed = axis;
        measurement(changed).axis.name = "Y";
        QVERIFY(!asks(axis, changed));
        changed = axis;
        changed.edition = "ISO 230-2:2006";
        QVERIFY(!asks(axis, changed));
        changed = axis;
        measurement(changed).zone = Interval{0, 400};
        QVERIFY(!asks(axis, changed));
        QVERIFY(!asks(axis, circleTest()));
        const Test circle = circleTest();
        QVERIFY(asks(circle, circle));
        changed = circle;
        circular(changed).plane = {"Y", "Z"};
        QVERIFY(!asks(circle, changed));
        changed = circle;
        circular(changed).source = SignalSource::feedback;
        QVERIFY(!asks(circle, changed));
        const EvaluatedDocument drifts = evaluate(documentOf({driftTest("a", 0.1), driftTest("a", 0.1)}));
        QVERIFY(drifts.tests[0]->findings.empty());
    }

    /// A linear axis learns nothing from angles.
    void environmentalVariationIsOfADriftTestOfTheSameMotion() {
        Test test = axisTest();
        measurement(test).uncertainty = inputs();
        measurement(test).uncertainty.environmentalVariation.reset();
        measurement(test).uncertainty.driftTest = "drift";
        const auto variation = [](const EvaluatedDocument &evaluated) {
            const auto &contributions = evaluated.tests[0]->uncertainty.contributions;
            const auto found =
                std::ranges::find(contributions, std::string_view("environmentalVariation"),
                                  [](const Contribution &c) { return std::string_view(c.id); });
            return found == contributions.end() ? std::nullopt : found->expanded;
        };
        QVERIFY(variation(evaluate(documentOf({test, driftTest("drift", 0.002)}))).has_value());
        QVERIFY(!variation(evaluate(documentOf({test, driftTest("another", 0.002)}))));
        QVERIFY(!variation(evaluate(documentOf({test, driftTest("drift", 0.002, Motion::rotary)}))));
        const EvaluatedDocument both = evaluate(
            documentOf({test, driftTest("drift", 0.002, Motion::rotary), driftTest("drift", 0.004)}));
        QCOMPARE(*variation(both), 2 * *variation(evaluate(documentOf({test, driftTest("drift", 0.002)}))));
    }

    void awaitsOnlyWhatIsNotKnown() {
        Test limited = axisTest();
        limited.limits = {{"A", limitOf(0.001)}};
        const EvaluatedDocument before = evaluate(documentOf({limited, circleTest()}));
        const auto document = edited(before, [](Document &d) {
            editTest(d, 0, [](Test &t) {
                measurement(t).targets.push_back(500);
                for (Run &run : measurement(t).runs)
                    run.deviations.emplace_back(0.1);
            });
        });
        const EvaluatedDocument awaiting = awaitingResults(document, {}, before);
        QCOMPARE(awaiting.pending, std::vector<std::size_t>{0});
        QVERIFY(awaiting.isPending(0) && !awaiting.isPending(1));
        QCOMPARE(awaiting.tests[1], before.tests[1]);
        QVERIFY(awaiting.tests[0]->findings == before.tests[0]->findings);
        QVERIFY(sameNumbers(*awaiting.tests[0], *before.tests[0]));
        QCOMPARE(awaiting.tests[0]->verdict, before.tests[0]->verdict);
        QVERIFY(before.tests[0]->verdict);
        const auto &results = std::get<PositioningResults>(awaiting.tests[0]->results);
        QCOMPARE(results.targets.size(), std::size_t(5));
        QVERIFY(std::isnan(results.targets[4].positive.mean));
        QCOMPARE(results.positiveRuns, 2);
        QCOMPARE(results.negativeRuns, 2);
        QVERIFY(results.upward && results.downward);

        const EvaluatedDocument all = evaluate(document, &awaiting);
        QVERIFY(all.pending.empty());
        QVERIFY(!sameNumbers(*all.tests[0], *before.tests[0]));
        QVERIFY(awaitingResults(document, {}, all).pending.empty());

        // Numbers of another edition are not shown under this one.
        const std::vector<std::string> other{"ISO 230-2:2006"};
        const EvaluatedDocument view = awaitingResults(document, other, before);
        QVERIFY(view.tests[0]->view && view.tests[0]->parameters.empty());
        QVERIFY(view.tests[0]->findings == before.tests[0]->findings);
        QVERIFY(!awaiting.tests[0]->view);
    }

    void oneDirectionAloneAwaitsAsOne() {
        for (const Direction direction : {Direction::positive, Direction::negative}) {
            Test test = axisTest();
            std::erase_if(measurement(test).runs, [&](const Run &run) { return run.approach != direction; });
            const EvaluatedDocument awaiting = awaitingResults(documentOf({test}), {}, {});
            const auto &results = std::get<PositioningResults>(awaiting.tests[0]->results);
            QCOMPARE(results.upward, direction == Direction::positive);
            QCOMPARE(results.downward, direction == Direction::negative);
            QCOMPARE(results.positiveRuns + results.negativeRuns, 2);
        }
    }

    /// Known again by its id, wherever it stands now; without ids by its place, if none has come or gone.
    void anEditedTestIsKnownAgain() {
        Test named = axisTest();
        named.id = "x";
        Test limited = named;
        limited.id = "y";
        limited.limits = {{"A", limitOf(0.001)}};
        const EvaluatedDocument before = evaluate(documentOf({named, limited}));
        const auto swapped = edited(before, [](Document &d) {
            std::swap(d.tests[0], d.tests[1]);
            editTest(d, 0, [](Test &t) { t.title = "b"; });
        });
        QCOMPARE(awaitingResults(swapped, {}, before).tests[0]->verdict, before.tests[1]->verdict);

        named.id.clear();
        limited.id.clear();
        const EvaluatedDocument nameless = evaluate(documentOf({named, limited}));
        const auto title = [](Document &d) { editTest(d, 1, [](Test &t) { t.title = "b"; }); };
        QCOMPARE(awaitingResults(edited(nameless, title), {}, nameless).tests[1]->verdict,
                 nameless.tests[1]->verdict);
        const auto shorter = edited(nameless, [&](Document &d) {
            title(d);
            d.tests.erase(d.tests.begin());
        });
        QVERIFY(!awaitingResults(shorter, {}, nameless).tests[0]->verdict);
    }

    void aSimulationIsOutdatedByWhatItWasMadeOf() {
        Test test = axisTest();
        measurement(test).uncertainty = inputs();
        measurement(test).uncertainty.environmentalVariation.reset();
        measurement(test).uncertainty.driftTest = "drift";
        const EvaluatedDocument without = evaluate(documentOf({test, driftTest("drift", 0.002)}));
        QVERIFY(isSimulationDue(without, 0, SimulateWhich::forReport));
        QVERIFY(!isSimulationDue(without, 0, SimulateWhich::monteCarloOnly));
        QVERIFY(!isSimulationDue(without, 1, SimulateWhich::forReport));
        const auto with = withSimulations(without, SimulateWhich::forReport);
        QVERIFY(with && with->tests[0]->uncertainty.simulation);
        QVERIFY(!with->simulations[1].simulation);
        QVERIFY(!isSimulationDue(*with, 0, SimulateWhich::forReport));
        const auto outdatedBy = [&](const Edit &edit) {
            const EvaluatedDocument after = withEdit(*with, edit);
            const auto &uncertainty = after.tests[0]->uncertainty;
            const bool due = isSimulationDue(after, 0, SimulateWhich::forReport);
            if (uncertainty.simulation != with->tests[0]->uncertainty.simulation ||
                due != uncertainty.outdated)
                qFatal("the simulation is lost, or due without need");
            return uncertainty.outdated;
        };
        const auto inTest = [](const std::function<void(PositioningMeasurement &)> &change) {
            return [change](Document &d) { editTest(d, 0, [&](Test &t) { change(measurement(t)); }); };
        };
        QVERIFY(!outdatedBy([](Document &d) { d.report.number = "7"; }));
        QVERIFY(!outdatedBy([](Document &d) { editTest(d, 0, [](Test &t) { t.title = "b"; }); }));
        QVERIFY(!outdatedBy(inTest([](auto &m) { m.uncertainty.method = UncertaintyMethod::monteCarlo; })));
        QVERIFY(!outdatedBy(inTest([](auto &m) { m.uncertainty.expanded = {{"A", 3.0}}; })));
        QVERIFY(outdatedBy(inTest([](auto &m) { m.uncertainty.seed = 2; })));
        QVERIFY(outdatedBy(inTest([](auto &m) { m.runs[0].deviations[0] = 0.5; })));
        QVERIFY(outdatedBy(
            [](Document &d) { d.tests[1] = std::make_shared<const Test>(driftTest("drift", 0.003)); }));
    }

    /// Simulations nobody asked for are bounded by readings times trials, and run where they are printed.
    void aLargeTestIsSimulatedWhenItIsAskedFor() {
        const auto test = [](std::size_t readings) {
            Test large = axisTest();
            auto &m = measurement(large);
            m.uncertainty = inputs();
            m.runs.clear();
            for (std::size_t i = 0; i < readings / 4; ++i)
                m.runs.push_back(
                    {i % 2 == 0 ? Direction::positive : Direction::negative, {0.0, 0.001, 0.0, 0.0}});
            return large;
        };
        constexpr auto all = SimulateWhich::forReport;
        constexpr std::size_t most = 452; // · 2.2·10⁵ is less than 10⁸, 456 is more
        QVERIFY(isSimulationDue(evaluate(documentOf({test(most)})), 0, all));
        for (const ReportPart part : {ReportPart::uncertainty, ReportPart::annex}) {
            Document unprinted;
            unprinted.report.leaveOut = {part};
            unprinted.tests = {std::make_shared<const Test>(test(most))};
            QVERIFY(!isSimulationDue(evaluate(std::make_shared<const Document>(unprinted)), 0, all));
        }
        Test large = test(most + 4);
        QVERIFY(!isSimulationDue(evaluate(documentOf({large})), 0, all));
        measurement(large).uncertainty.method = UncertaintyMethod::monteCarlo;
        QVERIFY(isSimulationDue(evaluate(documentOf({large})), 0, all));
        QVERIFY(isSimulationDue(evaluate(documentOf({large})), 0, SimulateWhich::monteCarloOnly));
    }

    /// The verdict of the report is the worst; what was found before an adjustment does not count beside
    /// what was left.
    void theWorstVerdictOfThoseThatCount() {
        const auto limited = [](double limit, TestRole role) {
            Test test = axisTest();
            test.role = role;
            measurement(test).uncertainty.expanded = {{"A", 0.1}};
            measurement(test).uncertainty.method = UncertaintyMethod::direct;
            test.limits = {{"A", limitOf(limit)}};
            return test;
        };
        using enum TestRole;
        QVERIFY(!evaluate(documentOf({axisTest()})).verdict());
        QCOMPARE(evaluate(documentOf({limited(1, notStated), limited(0.001, notStated)})).verdict(),
                 std::optional(Verdict::doesNotConform));
        QCOMPARE(evaluate(documentOf({limited(1, asLeft), limited(0.001, asFound)})).verdict(),
                 std::optional(Verdict::conforms));
        QCOMPARE(evaluate(documentOf({limited(0.001, asFound), driftTest("d", 0.1)})).verdict(),
                 std::optional(Verdict::doesNotConform));
    }

    /// Whichever of two tests states the comparison: after − before is never the other way round.
    void comparedInTheOrderOfTime() {
        using enum TestRole;
        const auto firstIsBefore = [](TestRole first, TestRole second, const char *firstDate,
                                      const char *secondDate, bool bySecond) {
            Test one = axisTest();
            Test two = axisTest();
            one.id = "one";
            two.id = "two";
            one.role = first;
            two.role = second;
            if (firstDate)
                one.date = firstDate;
            if (secondDate)
                two.date = secondDate;
            (bySecond ? two : one).comparedWith = ComparedWith{bySecond ? "one" : "two", {}, {}};
            const EvaluatedDocument evaluated = evaluate(documentOf({one, two}));
            const auto stated = statedComparison(evaluated, bySecond ? 1 : 0);
            return stated->before == 0;
        };
        for (const bool bySecond : {true, false}) {
            QVERIFY(firstIsBefore(asFound, asLeft, nullptr, nullptr, bySecond));
            QVERIFY(!firstIsBefore(asLeft, asFound, "2026-01-01", "2026-02-01", bySecond));
            QVERIFY(firstIsBefore(notStated, notStated, "2026-01-01", "2026-02-01", bySecond));
            QVERIFY(!firstIsBefore(notStated, asLeft, "2026-02-01", "2026-01-01", bySecond));
            // Without roles and both dates the named test came first.
            QCOMPARE(firstIsBefore(notStated, notStated, nullptr, "2026-01-01", bySecond), bySecond);
        }
    }
};

QTEST_GUILESS_MAIN(EvaluatedDocumentTest)
#include "evaluateddocument.moc"
