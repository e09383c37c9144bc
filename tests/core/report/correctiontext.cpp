// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/words/correctiontext.h"

#include <QTest>

using namespace palmer;

namespace {

Sensor sensor(SensorMeasures what, double start, double end) {
    Sensor result;
    result.measures = what;
    result.start = start;
    result.end = end;
    return result;
}

void state(Conditions &conditions) {
    conditions.sensors = {sensor(SensorMeasures::machine, 20.7, 20.9),
                          sensor(SensorMeasures::instrument, 20.6, 20.8)};
    conditions.expansion.machine = 11.5;
    conditions.expansion.instrument = 0.0;
}

Test axis() {
    PositioningMeasurement measurement;
    measurement.axis.motion = Motion::linear;
    measurement.targets = {0, 750, 1500};
    state(measurement.conditions.common);
    Test test;
    test.measurement = measurement;
    return test;
}

QString english(const Test &test) {
    return correctionSizeText(test, Language(Language::Id::english));
}

} // namespace

class CorrectionText : public QObject {
    Q_OBJECT

private slots:
    /// 11.5 µm/(m·°C) · 0.8 °C · 1.5 m = 13.8 µm.
    void theFarthestTargetCounts() {
        Test test = axis();
        QCOMPARE(english(test), "13.8\u00a0µm over 1\u202f500\u00a0mm");
        QCOMPARE(correctionSizeText(test, Language(Language::Id::french)),
                 "13,8\u00a0µm à 1\u202f500\u00a0mm");
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        measurement.conditions.referencePosition = 1500; // then 0 is the farthest
        QCOMPARE(english(test), "13.8\u00a0µm over 1\u202f500\u00a0mm");
        measurement.conditions.referencePosition = 750;
        QCOMPARE(english(test), "6.9\u00a0µm over 750\u00a0mm");
        measurement.conditions.common.correctionTo20 = CorrectionTo20::appliedHere; // as large as not applied
        QCOMPARE(english(test), "6.9\u00a0µm over 750\u00a0mm");
    }

    /// "Applied here" is said only where it was.
    void aCorrectionThatWasNotMadeIsNotSaidToBe() {
        const Language language(Language::Id::english);
        const auto said = [&](const Test &test) { return language.text(correctionText(test)); };
        const QString nothing = "to be applied here, but nothing is corrected";
        Test test = axis();
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        QCOMPARE(said(test), "not stated");
        measurement.conditions.common.correctionTo20 = CorrectionTo20::appliedHere;
        QCOMPARE(said(test), "applied here");
        measurement.axis.motion = Motion::rotary;
        QCOMPARE(said(test), nothing);
        measurement.axis.motion = Motion::linear;
        measurement.conditions.common.sensors.clear();
        QCOMPARE(said(test), nothing);
        CircularMeasurement circle;
        state(circle.conditions.common);
        circle.conditions.common.correctionTo20 = CorrectionTo20::appliedHere;
        test.measurement = circle;
        QCOMPARE(said(test), "applied here");
        circle.source = SignalSource::feedback;
        test.measurement = circle;
        QCOMPARE(said(test), nothing);
    }

    void ofCirclesTheRadius() {
        CircularMeasurement measurement;
        measurement.nominalRadius = 150;
        state(measurement.conditions.common);
        Test test;
        test.measurement = measurement;
        QCOMPARE(english(test), "1.4\u00a0µm over 150\u00a0mm"); // 1.38
    }

    void nothingIsSaidOfWhatIsNotKnown() {
        Test test = axis();
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        measurement.conditions.common.expansion.machine.reset();
        QVERIFY(english(test).isEmpty());
        test = axis();
        std::get<PositioningMeasurement>(test.measurement).conditions.common.sensors.clear();
        QVERIFY(english(test).isEmpty());
        test = axis();
        std::get<PositioningMeasurement>(test.measurement).axis.motion = Motion::rotary;
        QVERIFY(english(test).isEmpty());
        test = axis();
        std::get<PositioningMeasurement>(test.measurement).targets.clear();
        QVERIFY(english(test).isEmpty());
    }
};

QTEST_APPLESS_MAIN(CorrectionText)
#include "correctiontext.moc"
