// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/conditions.h"

#include <QTest>

using namespace palmer;

namespace {

using OptionalNumber = std::optional<double>;

constexpr auto machine = SensorMeasures::machine;

Sensor sensor(OptionalNumber start, OptionalNumber end, SensorMeasures measures = machine) {
    return {measures, "", start, end, {}};
}

OptionalNumber meanOf(std::vector<Sensor> sensors) {
    Conditions conditions;
    conditions.sensors = std::move(sensors);
    return meanTemperature(conditions, machine);
}

} // namespace

/// Temperatures of the conditions.
class ConditionsTest : public QObject {
    Q_OBJECT

private slots:
    void startAndEnd() {
        Sensor one = sensor({}, {});
        QVERIFY(!startTemperature(one) && !endTemperature(one));
        one.series = TemperatureSeries{};
        QVERIFY(!startTemperature(one) && !endTemperature(one));
        one.series = TemperatureSeries{{0, 60, 120}, {20, 23, 21}};
        QCOMPARE(startTemperature(one), OptionalNumber(20));
        QCOMPARE(endTemperature(one), OptionalNumber(21));
        one.series = TemperatureSeries{{60, 0, 120, 60}, {23, 20, 21, 24}}; // as they stand in a file
        QCOMPARE(startTemperature(one), OptionalNumber(20));
        QCOMPARE(endTemperature(one), OptionalNumber(21));
        one.start = 19; // what is stated wins
        one.end = 22;
        QCOMPARE(startTemperature(one), OptionalNumber(19));
        QCOMPARE(endTemperature(one), OptionalNumber(22));
    }

    void meanOfStartAndEndOverTheSensors() {
        QVERIFY(!meanOf({}));
        QVERIFY(!meanOf({sensor(20, 21, SensorMeasures::air)}));
        QCOMPARE(meanOf({sensor(20, 21)}), OptionalNumber(20.5));
        // (20.5 + 24)/2; the air is none of them
        QCOMPARE(meanOf({sensor(20, 21), sensor(30, 31, SensorMeasures::air), sensor(22, 26)}),
                 OptionalNumber(22.25));
        QCOMPARE(meanOf({sensor(20, 21), sensor({}, 26)}), OptionalNumber(23.25)); // one is enough
        QCOMPARE(meanOf({sensor(22, {})}), OptionalNumber(22));
        QVERIFY(!meanOf({sensor(20, 21), sensor({}, {})}));
        QVERIFY(
            !meanOf({sensor(20, 21), sensor(22, 23, SensorMeasures::notStated)})); // may be of the machine
        // A report states what is stated.
        Conditions conditions;
        conditions.sensors = {sensor(20, 21), sensor(22, {}), sensor(30, 31, SensorMeasures::notStated)};
        QCOMPARE(statedTemperature(conditions, machine, startTemperature), OptionalNumber(21));
        QCOMPARE(statedTemperature(conditions, machine, endTemperature), OptionalNumber(21));
        QVERIFY(!statedTemperature(conditions, SensorMeasures::air, startTemperature));
    }

    void everyTemperatureOfTheTest() {
        Conditions conditions;
        QVERIFY(!temperatureSpan(conditions, machine).complete);
        QVERIFY(!temperatureSpan(conditions, machine).farthest());
        conditions.sensors = {sensor(20, 21), sensor(19.5, 20), sensor(30, 31, SensorMeasures::air)};
        const TemperatureSpan span = temperatureSpan(conditions, machine);
        QVERIFY(span.complete);
        QCOMPARE(span.lowest, OptionalNumber(19.5));
        QCOMPARE(span.highest, OptionalNumber(21));
        QCOMPARE(span.farthest(), OptionalNumber(21));
        conditions.sensors[1].series = TemperatureSeries{{0, 60, 120}, {20, 18, 20}};
        QCOMPARE(temperatureSpan(conditions, machine).farthest(), OptionalNumber(18));
        conditions.sensors.push_back(sensor(20, {}));
        QVERIFY(!temperatureSpan(conditions, machine).complete);
        conditions.sensors.back() = sensor(20, 20, SensorMeasures::notStated); // may be of the machine
        QVERIFY(!temperatureSpan(conditions, machine).complete);
    }

    void gradient_data() {
        QTest::addColumn<QList<double>>("times"); // min
        QTest::addColumn<QList<double>>("temperatures");
        QTest::addColumn<double>("expected"); // −1: null
        using Numbers = QList<double>;
        QTest::newRow("nothing") << Numbers{} << Numbers{} << -1.0;
        QTest::newRow("59 min") << Numbers{0, 59} << Numbers{20, 25} << -1.0;
        QTest::newRow("an hour") << Numbers{0, 60} << Numbers{20, 25} << 5.0;
        QTest::newRow("falling") << Numbers{0, 60} << Numbers{25, 20} << 5.0;
        // 20 at 0 and 26 at 61 min are no hour; 23 at 1 min is
        QTest::newRow("no more than an hour") << Numbers{0, 1, 61} << Numbers{20, 23, 26} << 3.0;
        QTest::newRow("61 min, falling") << Numbers{0, 1, 61} << Numbers{26, 23, 20} << 3.0;
        QTest::newRow("up and down within the hour")
            << Numbers{0, 10, 20, 120} << Numbers{20, 22, 19.5, 19.5} << 2.5;
        QTest::newRow("within an hour that does not begin at the first")
            << Numbers{0, 60, 90, 120, 300} << Numbers{20, 20, 21, 24, 24} << 4.0;
        // of each hour: {20}, {20, 20.5}, {20.5, 20.2}, {20.2, 21}, {21, 21.1}
        QTest::newRow("the largest of many hours")
            << Numbers{0, 60, 120, 180, 240} << Numbers{20, 20.5, 20.25, 21, 21.125} << 0.75;
        QTest::newRow("the same in another order")
            << Numbers{180, 0, 240, 60, 120} << Numbers{21, 20, 21.125, 20.5, 20.25} << 0.75;
    }

    void gradient() {
        QFETCH(QList<double>, times);
        QFETCH(QList<double>, temperatures);
        QFETCH(double, expected);
        TemperatureSeries series;
        for (const double minutes : times)
            series.times.push_back(60 * minutes + 5); // s; the first is not 0
        series.temperatures.assign(temperatures.begin(), temperatures.end());
        QCOMPARE(gradientPerHour(series).value_or(-1), expected);
    }
};

QTEST_APPLESS_MAIN(ConditionsTest)
#include "conditions.moc"
