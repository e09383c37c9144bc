// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/ticks.h"

#include <QTest>

#include <cmath>

using namespace palmer;
using namespace Qt::StringLiterals;

/// Round ticks and their labels.
class Ticks : public QObject {
    Q_OBJECT

private slots:
    void stepIsRound_data();
    void stepIsRound();
    void labels_data();
    void labels();
    void ticksLieInTheRange();
};

void Ticks::stepIsRound_data() {
    QTest::addColumn<double>("span");
    QTest::addColumn<double>("most");
    QTest::addColumn<int>("steps");
    QTest::addColumn<double>("step");
    const auto values = static_cast<int>(TickSteps::values);
    const auto lengths = static_cast<int>(TickSteps::lengths);
    const auto angles = static_cast<int>(TickSteps::angles);

    QTest::newRow("values go 1-2-5: 18.6 in 12 parts") << 18.6 << 12.0 << values << 2.0;
    QTest::newRow("a step that fits exactly is taken") << 20.0 << 10.0 << values << 2.0;
    QTest::newRow("values know no 2.5") << 1500.0 << 6.5 << values << 500.0;
    QTest::newRow("lengths know 2.5") << 1500.0 << 6.5 << lengths << 250.0;
    QTest::newRow("nanometres") << 0.0031 << 10.0 << values << 0.0005;
    QTest::newRow("kilometres") << 1e6 << 5.0 << lengths << 2e5;
    QTest::newRow("a full turn in 60°") << 360.0 << 6.5 << angles << 60.0;
    QTest::newRow("a quarter turn in 15°") << 90.0 << 6.5 << angles << 15.0;
    QTest::newRow("half a turn in 30°") << 180.0 << 6.5 << angles << 30.0;
    QTest::newRow("five turns in whole turns") << 1800.0 << 6.5 << angles << 360.0;
    QTest::newRow("small angles go 1-2-5") << 2.2 << 6.5 << angles << 0.5;
}

void Ticks::stepIsRound() {
    QFETCH(double, span);
    QFETCH(double, most);
    QFETCH(int, steps);
    QFETCH(double, step);
    const double found = roundStep(span, most, static_cast<TickSteps>(steps));
    QVERIFY2(std::abs(found - step) <= 1e-12 * step, qPrintable(QString::number(found, 'g', 17)));
}

void Ticks::labels_data() {
    QTest::addColumn<bool>("french");
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<QStringList>("labels");

    QTest::newRow("French writes a decimal comma and a minus")
        << true << -0.6 << 0.6 << QStringList{u"−0,5"_s, u"0,0"_s, u"0,5"_s};
    QTest::newRow("English writes a decimal point")
        << false << -0.6 << 0.6 << QStringList{u"−0.5"_s, u"0.0"_s, u"0.5"_s};
    QTest::newRow("thousands are kept apart by a narrow space")
        << true << -100.0 << 2100.0 << QStringList{u"0"_s, u"1\u202f000"_s, u"2\u202f000"_s};
    QTest::newRow("whole steps have no decimals")
        << false << 9.5 << 12.5 << QStringList{u"10"_s, u"11"_s, u"12"_s};
}

void Ticks::labels() {
    QFETCH(bool, french);
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(QStringList, labels);
    FigureAxis axis;
    setRange(axis, from, to, 4, TickSteps::values,
             Language(french ? Language::Id::french : Language::Id::english));
    QStringList found;
    for (const Tick &tick : axis.ticks)
        found += tick.label;
    QCOMPARE(found, labels);
}

void Ticks::ticksLieInTheRange() {
    const Language language(Language::Id::english);
    for (int i = 0; i < 400; ++i) {
        const double span = std::pow(10.0, -6 + 0.031 * i);
        const double from = -0.37 * span;
        FigureAxis axis;
        setRange(axis, from, from + span, 10, TickSteps::values, language);
        QVERIFY(axis.ticks.size() >= 4);
        QVERIFY(axis.ticks.size() <= 11);
        for (const Tick &tick : axis.ticks) {
            QVERIFY(tick.value >= from - 1e-9 * span);
            QVERIFY(tick.value <= from + span + 1e-9 * span);
            // What is written is where the tick stands, but for the rounding of the decimals.
            QString plain = tick.label;
            plain.remove(QChar(0x202f)).replace(QChar(0x2212), QLatin1Char('-'));
            bool number = false;
            const double written = plain.toDouble(&number);
            QVERIFY2(number, qPrintable(tick.label));
            QVERIFY(std::abs(written - tick.value) <= 1e-9 * span);
        }
    }
}

QTEST_GUILESS_MAIN(Ticks)
#include "ticks.moc"
