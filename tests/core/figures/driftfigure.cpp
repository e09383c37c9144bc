// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "kernel/evaluation/evaluatetest.h"

#include <QTest>

using namespace palmer;
using namespace Qt::StringLiterals;

namespace {

Test driftTest(std::vector<double> times, std::vector<double> deviations, Motion motion = Motion::linear) {
    DriftMeasurement measurement;
    measurement.axis.name = "X";
    measurement.axis.motion = motion;
    measurement.times = std::move(times);
    measurement.deviations = std::move(deviations);
    Test test;
    test.measurement = measurement;
    return test;
}

CurveFigure figureOf(const Test &test) {
    return driftFigure(test, evaluateTest(test, {}), Language(Language::Id::english));
}

} // namespace

/// The curve of a drift test.
class DriftFigureTest : public QObject {
    Q_OBJECT

private slots:
    void curveAndRange() {
        const CurveFigure figure = figureOf(driftTest({0, 10, 20, 30}, {0, 0.0024, -0.0008, 0.001}));
        QCOMPARE(figure.curves.size(), std::size_t{1});
        QCOMPARE(figure.curves[0].role, CurveRole::drift);
        QCOMPARE(figure.curves[0].points.size(), std::size_t{4});
        QVERIFY(std::abs(figure.curves[0].points[1].y - 2.4) < 1e-9);
        QCOMPARE(figure.x.unit, u"s"_s);
        QCOMPARE(figure.y.unit, u"µm"_s);
        // E_VE between the readings that make it
        QCOMPARE(figure.dimensions.size(), std::size_t{1});
        const Dimension &range = figure.dimensions[0];
        QCOMPARE(range.label + range.subscript, u"EVE"_s);
        QVERIFY(std::abs(range.upper - range.lower - 3.2) < 1e-9);
        QCOMPARE(range.upperPosition, 10.0);
        QCOMPARE(range.lowerPosition, 20.0);
        QVERIFY(figure.legend[0].text.contains(u"3.2 µm"_s) ||
                figure.legend[0].text.contains(u"3.2\u00A0µm"_s) ||
                figure.legend[0].text.contains(u"3.2\u202Fµm"_s));
    }

    /// A test takes the channel of its axis, and of that the window of its duration.
    void whatATestTakesIsDrawn() {
        Test test = driftTest({0, 10, 20, 30}, {});
        auto &drift = std::get<DriftMeasurement>(test.measurement);
        drift.channels = {{"X", ChannelQuantity::deviation, {0.0, 0.001, 0.002, 0.003}},
                          {"Y", ChannelQuantity::deviation, {0.0, 0.001, 0.005, 0.006}}};
        const TakenVariation taken{drift.channels[1], {0.004, 10, 20, 0.001, 0.005, 30, 10, false}};
        const CurveFigure figure =
            driftFigure(test, evaluateTest(test, {}), Language(Language::Id::english), taken);
        QCOMPARE(figure.title, u"Drift of “Y”"_s);
        QCOMPARE(figure.curves[0].points[3].y, 6.0);
        QCOMPARE(figure.dimensions[0].lower, 1.0);
        QCOMPARE(figure.dimensions[0].upper, 5.0);
        QVERIFY(figure.legend[0].text.contains(u"within the duration of the test"_s));
        QVERIFY(figure.legend[0].text.contains(u"4.0"_s));
    }

    void theTitleNamesAxisOrChannel() {
        Test test = driftTest({0, 10}, {0, 0.001});
        QCOMPARE(figureOf(test).title, u"Drift of the X axis"_s);
        auto &drift = std::get<DriftMeasurement>(test.measurement);
        drift.deviations.clear();
        drift.channels = {{"Channel 1", ChannelQuantity::deviation, {0.0, 0.001}}};
        QCOMPARE(figureOf(test).title, u"Drift of “Channel 1”"_s);
        drift.axis.name.clear();
        drift.channels.front().name.clear();
        QCOMPARE(figureOf(test).title, u"Drift"_s);
    }

    void longTestsCountMinutesAndHours_data() {
        QTest::addColumn<double>("last");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("shown");
        QTest::newRow("ten minutes less a second") << 599.0 << u"s"_s << 599.0;
        QTest::newRow("ten minutes") << 600.0 << u"min"_s << 10.0;
        QTest::newRow("a night") << 36000.0 << u"h"_s << 10.0;
    }

    void longTestsCountMinutesAndHours() {
        QFETCH(double, last);
        QFETCH(QString, unit);
        QFETCH(double, shown);
        const CurveFigure figure = figureOf(driftTest({0, last}, {0, 0.001}));
        QCOMPARE(figure.x.unit, unit);
        QCOMPARE(figure.curves[0].points[1].x, shown);
        QVERIFY(figure.x.to >= shown);
    }

    void rotaryAxesSpeakArcSeconds() {
        const CurveFigure figure = figureOf(driftTest({0, 1}, {0, 0.001}, Motion::rotary));
        QCOMPARE(figure.y.unit, u"″"_s);
        QVERIFY(std::abs(figure.curves[0].points[1].y - 3.6) < 1e-9);
    }

    void littleToShow_data() {
        QTest::addColumn<QList<double>>("times");
        QTest::addColumn<QList<double>>("deviations");
        QTest::addColumn<int>("curves");
        QTest::addColumn<int>("dimensions");
        QTest::newRow("nothing") << QList<double>{} << QList<double>{} << 0 << 0;
        QTest::newRow("one reading") << QList{5.0} << QList{0.002} << 1 << 0;
        QTest::newRow("no drift") << QList{0.0, 5.0} << QList{0.002, 0.002} << 1 << 0;
        QTest::newRow("all at once") << QList{5.0, 5.0} << QList{0.001, 0.002} << 1 << 1;
    }

    void littleToShow() {
        QFETCH(QList<double>, times);
        QFETCH(QList<double>, deviations);
        QFETCH(int, curves);
        QFETCH(int, dimensions);
        const CurveFigure figure =
            figureOf(driftTest({times.begin(), times.end()}, {deviations.begin(), deviations.end()}));
        QCOMPARE(static_cast<int>(figure.curves.size()), curves);
        QCOMPARE(static_cast<int>(figure.dimensions.size()), dimensions);
        QVERIFY(figure.x.from < figure.x.to);
        QVERIFY(figure.y.from < figure.y.to);
    }
};

QTEST_APPLESS_MAIN(DriftFigureTest)
#include "driftfigure.moc"
