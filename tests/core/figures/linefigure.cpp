// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "figures/testfigures.h"

#include "figures/figuretexts.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/surroundings.h"

#include <QTest>

using namespace palmer;

namespace {

Sensor sensor(SensorMeasures measures, std::vector<double> times, std::vector<double> temperatures,
              std::string position = {}) {
    Sensor made;
    made.measures = measures;
    made.position = std::move(position);
    made.series = TemperatureSeries{std::move(times), std::move(temperatures)};
    return made;
}

Test smallTest(double offset) {
    PositioningMeasurement m;
    m.axis.name = "X";
    m.targets = {0, 100, 200};
    m.runs = {{Direction::positive, {-0.003 + offset, 0.0002, -0.005}},
              {Direction::negative, {0.0023, {}, -0.0015}},
              {Direction::positive, {-0.003 + offset, 0.0002, -0.005}},
              {Direction::negative, {0.0023, {}, -0.0015}}};
    Test test;
    test.edition = "ISO 230-2:2014";
    test.measurement = std::move(m);
    return test;
}

Language english() {
    return Language(Language::Id::english);
}

} // namespace

/// Lines over a common axis, and their points as CSV.
class LineFigureTest : public QObject {
    Q_OBJECT

private slots:
    void showsEachSensorOverHours() {
        const LineFigure figure = temperatureFigure(
            {sensor(SensorMeasures::machine, {600, 4200}, {20, 21}, "nut"), Sensor{}, // has no series
             sensor(SensorMeasures::air, {600, 2400, 4200}, {19.5, 19.75, 20})},
            english());
        QCOMPARE(figure.lines.size(), std::size_t(2));
        QCOMPARE(figure.lines[0].name, QString("machine, nut"));
        QCOMPARE(figure.lines[1].label, QString("2"));
        QCOMPARE(figure.lines[1].role, LineRole::air);
        QCOMPARE(figure.lines[1].points[1], QPointF(0.5, 19.75)); // from the first of all values
        QCOMPARE(figure.x.unit, QString("h"));
        QVERIFY(figure.y.from < 19.5 && figure.y.to > 21);
    }

    void aSingleSensorNeedsNoNumber() {
        const LineFigure figure =
            temperatureFigure({sensor(SensorMeasures::machine, {0, 3600}, {20, 20})}, english());
        QVERIFY(figure.lines[0].label.isEmpty());
        QVERIFY(figure.y.from < 20 && figure.y.to > 20); // a steady temperature has a range, too
        QVERIFY(temperatureFigure({Sensor{}}, english()).lines.empty());
    }

    void longSeriesKeepTheirExtremes() {
        std::vector<double> times;
        std::vector<double> temperatures;
        for (int i = 0; i < 100'000; ++i) {
            times.push_back(i);
            temperatures.push_back(i == 31'234 ? 25.5 : i == 77'001 ? 14.5 : 20 + 0.1 * (i % 7));
        }
        const LineFigure figure =
            temperatureFigure({sensor(SensorMeasures::machine, times, temperatures)}, english());
        const auto &points = figure.lines[0].points;
        QVERIFY(points.size() <= 2004); // four of each of 500 parts, and of the last value
        QVERIFY(std::ranges::any_of(points, [](QPointF p) { return p.y() == 25.5; }));
        QVERIFY(std::ranges::any_of(points, [](QPointF p) { return p.y() == 14.5; }));
        QVERIFY(std::ranges::is_sorted(points, {}, &QPointF::x));
    }

    void drawsThePredictionOverTheMeasured() {
        const Test test = smallTest(0);
        const LineFigure figure =
            compensationFigure(test, evaluateTest(test, {}), evaluateTest(smallTest(0.003), {}), english());
        QCOMPARE(figure.lines.size(), std::size_t(4));
        QCOMPARE(figure.lines[0].role, LineRole::measuredUp);
        QCOMPARE(figure.lines[0].points[0], QPointF(0, -3));
        QCOMPARE(figure.lines[1].points.size(), std::size_t(2)); // a target without a mean is left out
        QCOMPARE(figure.lines[2].role, LineRole::predictedUp);   // last, above
        QCOMPARE(figure.lines[2].points[0], QPointF(0, 0));
    }

    void writesItsPoints_data() {
        QTest::addColumn<char>("mark");
        QTest::addColumn<QString>("row");
        QTest::newRow("point") << '.' << "\nx̄↑,100,0.2\n";
        QTest::newRow("comma") << ',' << "\nx̄↑;100;0,2\n";
    }
    void writesItsPoints() {
        QFETCH(char, mark);
        QFETCH(QString, row);
        const Test test = smallTest(0);
        const CurveFigure figure = deviationFigure(test, evaluateTest(test, {}), english());
        const QString csv = QString::fromUtf8(figureCsv(figure, english(), mark));
        QVERIFY2(csv.startsWith("# Positioning deviations of the X axis\n"), qPrintable(csv));
        QVERIFY2(csv.contains(row), qPrintable(csv));
        std::size_t points = 0;
        for (const Curve &curve : figure.curves)
            points += curve.points.size();
        for (const Band &band : figure.bands)
            points += 2 * band.points.size();
        QCOMPARE(static_cast<std::size_t>(csv.count('\n')), points + figure.readings.size() + 2);
    }
};

QTEST_GUILESS_MAIN(LineFigureTest)
#include "linefigure.moc"
