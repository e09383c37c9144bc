// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/driftreadings.h"

#include "document/documenterror.h"
#include "editing/newtest.h"

#include <QTest>
#include <algorithm>

using namespace palmer;
using namespace Qt::StringLiterals;

namespace {

const DriftMeasurement &drift(const Test &test) {
    return std::get<DriftMeasurement>(test.measurement);
}

/// What a paste puts; nothing where it is refused or doubted.
std::optional<std::vector<DriftReading>> takenFrom(const QString &text, Motion motion = Motion::linear) {
    try {
        const PastedDrift pasted = driftReadingsFrom(text.toStdString(), motion);
        if (std::ranges::all_of(pasted.questions, &Question::canBeAssumed)) {
            Axis axis;
            axis.motion = motion;
            Test test = newDriftTest(axis);
            putDriftReadings(test, 0, pasted.drift);
            std::vector<DriftReading> readings;
            for (std::size_t i = 0; i < drift(test).times.size(); ++i)
                readings.push_back({drift(test).times[i], drift(test).deviations.at(i)});
            return readings;
        }
    } catch (const Error &) {
    }
    return std::nullopt;
}

} // namespace

/// Readings of drift tests, typed and pasted.
class DriftReadings : public QObject {
    Q_OBJECT

private slots:
    void replaceAndAppend() {
        Test test = newDriftTest({});
        setDriftReadings(test, 0, {{0, 0.001}, {10, 0.002}});
        QCOMPARE(drift(test).times, (std::vector<double>{0, 10}));
        setDriftReadings(test, 1, {{11, 0.003}, {20, 0.004}});
        QCOMPARE(drift(test).times, (std::vector<double>{0, 11, 20}));
        QCOMPARE(drift(test).deviations, (std::vector<double>{0.001, 0.003, 0.004}));
        setDriftReadings(test, 99, {{30, 0}}); // behind the last
        QCOMPARE(drift(test).times.size(), std::size_t{4});
        removeDriftReadings(test, 1, 2);
        QCOMPARE(drift(test).times, (std::vector<double>{0, 30}));
        removeDriftReadings(test, 1, 99);
        removeDriftReadings(test, 5, 1);
        QCOMPARE(drift(test).times, std::vector<double>{0});
        QCOMPARE(drift(test).deviations, std::vector<double>{0.001});
    }

    /// A table is taken with its channels and temperatures; the axis stays that of the test.
    void channelsAndTemperaturesAreTakenWhole() {
        Axis axis;
        axis.name = "Z";
        Test test = newDriftTest(axis);
        setDriftReadings(test, 0, {{0, 0.001}, {10, 0.002}});
        const auto put = [&test](const char *table) {
            putDriftReadings(test, 1, driftReadingsFrom(table, Motion::linear).drift);
        };
        put("Time (min)\tX (µm)\tY (µm)\tAir (°C)\n0\t0\t1\t20\n1\t2\t\t20.5");
        QVERIFY(drift(test).deviations.empty());
        QCOMPARE(drift(test).times, (std::vector<double>{0, 60}));
        QCOMPARE(drift(test).axis.name, std::string("Z"));
        QCOMPARE(drift(test).channels.size(), std::size_t{2});
        QCOMPARE(drift(test).channels[1].name, std::string("Y"));
        QCOMPARE(drift(test).channels[1].values, (std::vector<std::optional<double>>{0.001, std::nullopt}));
        QCOMPARE(drift(test).temperatures[0].values, (std::vector<std::optional<double>>{20.0, 20.5}));
        removeDriftReadings(test, 0, 1);
        QCOMPARE(drift(test).times, std::vector<double>{60});
        QCOMPARE(drift(test).channels[0].values, std::vector<std::optional<double>>{0.002});
        QCOMPARE(drift(test).temperatures[0].values, std::vector<std::optional<double>>{20.5});
        removeDriftReadings(test, 0, 1);
        QVERIFY(drift(test).channels.empty() && drift(test).temperatures.empty());
        put("Time (s)\tDeviation (µm)\tAir (°C)\n0\t0\t20\n5\t2\t20.5");
        QCOMPARE(drift(test).channels.at(0).name, std::string("Z"));
        put("0\t1\n5\t2");
        QVERIFY(drift(test).channels.empty() && drift(test).temperatures.empty());
        QCOMPARE(drift(test).deviations, (std::vector<double>{0.001, 0.002}));
    }

    void otherTestsStayAsTheyAre() {
        Test test;
        const Test before = test;
        setDriftReadings(test, 0, {{1, 1}});
        removeDriftReadings(test, 0, 1);
        QCOMPARE(test, before);
    }

    void pasted_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("readings"); // −1: refused
        QTest::newRow("tabs") << u"0\t0\n10\t1.5\n"_s << 2;
        QTest::newRow("semicolons and decimal commas") << u"0;0,1\r\n10;1,5"_s << 2;
        QTest::newRow("blanks") << u"  0 0\n 10   1.5"_s << 2;
        QTest::newRow("with a head") << u"t s\tx µm\n0\t0\n10\t1.5"_s << 2;
        QTest::newRow("empty lines") << u"\n0\t0\n\n10\t1.5\n\n"_s << 2;
        QTest::newRow("minutes and mm")
            << u"Time (min)\tDeviation (mm)\n0\t0\n0.16666666666666666\t0.0015"_s << 2;
        QTest::newRow("units without brackets") << u"t h\tx/nm\n0\t0\n0.002777777777777778\t1500"_s << 2;
        QTest::newRow("units in a line of their own") << u"Zeit;Drift\ns;mm\n0;0\n10;0,0015"_s << 2;
        QTest::newRow("a head of blanks") << u"t (ms) x (mm)\n0 0\n10000 0.0015"_s << 2;
        QTest::newRow("deviations first") << u"x (mm)\tt (s)\n0\t0\n0.0015\t10"_s << 2;
        QTest::newRow("deviations alone with a unit") << u"t\tx (mm)\n0\t0\n10\t0.0015"_s << 2;
        QTest::newRow("times behind, alone with a unit") << u"x\tt [s]\n0\t0\n1.5\t10"_s << 2;
        QTest::newRow("three columns") << u"0\t0\t0\n1\t1\t1"_s << -1;
        QTest::newRow("one column") << u"0\n1"_s << -1;
        QTest::newRow("words further down") << u"0\t0\nend\tof file"_s << 1;
        QTest::newRow("half a reading first") << u"0\tnone\n1\t1"_s << 1;
        QTest::newRow("infinite") << u"0\t0\n1\t1e999"_s << -1;
        QTest::newRow("no times") << u"Time (s)\tE (µm)\tF\n?\t1\t2\n?\t2\t3"_s << -1;
        QTest::newRow("nothing") << QString() << -1;
    }

    void pasted() {
        QFETCH(QString, text);
        QFETCH(int, readings);
        const auto found = takenFrom(text);
        QCOMPARE(found ? static_cast<int>(found->size()) : -1, readings);
        if (readings == 2) {
            QVERIFY(qFuzzyCompare(found->back().time, 10.0));
            QCOMPARE(found->back().deviation, 0.0015); // µm become mm exactly
        }
    }

    void unitsThatAreNotReadAreRefused() {
        for (const QString &head : {u"t\tx (1/10 µm)"_s, u"t\tx (ppm)"_s, u"t\tx (arcsec)"_s, u"t\tT (°C)"_s})
            QVERIFY2(!takenFrom(head + u"\n0\t0\n10\t1.5"_s), qPrintable(head));
    }

    void anglesAreArcSeconds() {
        const auto found = takenFrom(u"0\t3.6"_s, Motion::rotary);
        QVERIFY(found);
        QVERIFY(std::abs(found->front().deviation - 0.001) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(DriftReadings)
#include "driftreadings.moc"
