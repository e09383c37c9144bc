// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/edits.h"

#include <QTest>

using namespace palmer;

namespace {

Document twoTests() {
    Document document;
    Test positioning;
    positioning.edition = "ISO 230-2:2014";
    positioning.measurement = PositioningMeasurement();
    Test circular;
    circular.edition = "ISO 230-4:2005";
    circular.measurement = CircularMeasurement();
    document.tests = {std::make_shared<const Test>(positioning), std::make_shared<const Test>(circular)};
    return document;
}

Instrument called(const char *id) {
    Instrument instrument;
    instrument.id = id;
    return instrument;
}

} // namespace

/// Edits that keep together what belongs together.
class EditsTest : public QObject {
    Q_OBJECT

private slots:
    void anEditLeavesTheCopyBeforeAlone() {
        Document document = twoTests();
        const Document before = document;
        editTest(document, 0, [](Test &test) { test.title = "new"; });
        QCOMPARE(before.tests[0]->title, std::string());
        QCOMPARE(document.tests[0]->title, std::string("new"));
        QCOMPARE(document.tests[1], before.tests[1]); // shared
        editTest(document, 7, [](Test &) { QFAIL("there is no such test"); });
    }

    void theFirstInstrumentGoesToTestsWithoutOne() {
        Document document = twoTests();
        addInstrument(document, called("laser"));
        QCOMPARE(document.tests[0]->instruments, std::vector<std::string>{"laser"});
        addInstrument(document, called(""));
        QCOMPARE(document.instruments[1].id, std::string("instrument"));
        QCOMPARE(document.tests[0]->instruments, std::vector<std::string>{"laser"});
        addInstrument(document, called("laser")); // taken
        QCOMPARE(document.instruments[2].id, std::string("instrument2"));
    }

    void renamingReachesTheTests() {
        Document document = twoTests();
        addInstrument(document, called("laser"));
        addInstrument(document, called("ballbar"));
        QVERIFY(!renameInstrument(document, 0, "ballbar"));
        QVERIFY(!renameInstrument(document, 0, ""));
        QVERIFY(!renameInstrument(document, 5, "x"));
        QVERIFY(renameInstrument(document, 0, "xl80"));
        for (const TestPointer &test : document.tests)
            QCOMPARE(test->instruments, std::vector<std::string>{"xl80"});
        removeInstrument(document, 0);
        for (const TestPointer &test : document.tests)
            QVERIFY(test->instruments.empty());
        QCOMPARE(document.instruments.size(), std::size_t(1));
    }

    void sensorsAreCountedByWhatTheyMeasure() {
        Conditions conditions;
        const auto state = [](double start) { return [start](Sensor &sensor) { sensor.start = start; }; };
        editSensor(conditions, SensorMeasures::machine, 0, state(20.1));
        editSensor(conditions, SensorMeasures::air, 0, state(21));
        editSensor(conditions, SensorMeasures::machine, 1, state(20.2));
        editSensor(conditions, SensorMeasures::machine, 5, state(99)); // beyond the next one
        QCOMPARE(conditions.sensors.size(), std::size_t(3));
        QCOMPARE(sensorOf(conditions, SensorMeasures::machine, 1)->start, std::optional(20.2));
        QVERIFY(!sensorOf(conditions, SensorMeasures::instrument, 0));
        // Emptied, the last of its kind goes; one before it stays, for the others keep their numbers.
        const auto nothing = [](Sensor &sensor) { sensor.start.reset(); };
        editSensor(conditions, SensorMeasures::machine, 0, nothing);
        QCOMPARE(countSensors(conditions, SensorMeasures::machine), std::size_t(2));
        editSensor(conditions, SensorMeasures::machine, 1, nothing);
        QCOMPARE(countSensors(conditions, SensorMeasures::machine), std::size_t(1));
        removeSensor(conditions, SensorMeasures::air, 0);
        QCOMPARE(countSensors(conditions, SensorMeasures::air), std::size_t(0));
    }

    void whatSaysNothingIsNotKept() {
        Test test;
        setAgreedPoint(test, "feed", AgreementState::agreed, "2000");
        setAgreedPoint(test, "zone", AgreementState::notApplicable, "");
        QCOMPARE(test.agreedPoints.size(), std::size_t(2));
        setAgreedPoint(test, "feed", AgreementState::notAgreed, ""); // which is a statement
        QCOMPARE(test.agreedPoints.size(), std::size_t(2));
        setAgreedPoint(test, "feed", std::nullopt, "2000");
        QCOMPARE(test.agreedPoints.size(), std::size_t(1));
        editLimit(test, "A", [](Limit &limit) { limit.value = 0.02; });
        QCOMPARE(test.limits.size(), std::size_t(1));
        editLimit(test, "A", [](Limit &limit) { limit.value.reset(); });
        QVERIFY(test.limits.empty());
    }

    void driftTestsHaveNoConditions() {
        Test test;
        test.measurement = DriftMeasurement();
        QVERIFY(!conditionsOf(test));
    }
};

QTEST_APPLESS_MAIN(EditsTest)
#include "edits.moc"
