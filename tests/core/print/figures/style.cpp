// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/style.h"

#include <QTest>

#include <cstdlib>

using namespace palmer;

/// What the parts of a figure look like on each medium.
class Style : public QObject {
    Q_OBJECT

private slots:
    void measuresOfThePage_data();
    void measuresOfThePage();
    void directionsDifferWithoutColour();
    void coloursAreOpaque();
};

void Style::measuresOfThePage_data() {
    QTest::addColumn<int>("role");
    QTest::addColumn<double>("width"); // mm
    QTest::addColumn<QColor>("colour");
    QTest::newRow("↑ is solid blue") << int(FigureRole::up) << 0.45 << QColor(0x00, 0x44, 0x88);
    QTest::newRow("↓ is dashed orange") << int(FigureRole::down) << 0.45 << QColor(0xb3, 0x5c, 0x00);
    QTest::newRow("the mean of both is black") << int(FigureRole::mean) << 0.28 << QColor(Qt::black);
    QTest::newRow("axes are black") << int(FigureRole::axis) << 0.28 << QColor(Qt::black);
    QTest::newRow("the grid is faint") << int(FigureRole::grid) << 0.13 << QColor(0xdc, 0xdc, 0xdc);
}

void Style::measuresOfThePage() {
    QFETCH(int, role);
    QFETCH(double, width);
    QFETCH(QColor, colour);
    const QPen pen = figurePen(static_cast<FigureRole>(role), Medium::paper);
    QCOMPARE(pen.widthF() / pointsPerMillimetre, width);
    QCOMPARE(pen.color(), colour);
}

void Style::directionsDifferWithoutColour() {
    for (const Medium medium : {Medium::paper, Medium::screenLight, Medium::screenDark}) {
        QCOMPARE(figurePen(FigureRole::up, medium).style(), Qt::SolidLine);
        QCOMPARE(figurePen(FigureRole::upEdge, medium).style(), Qt::SolidLine);
        QCOMPARE(figurePen(FigureRole::down, medium).style(), Qt::CustomDashLine);
        QCOMPARE(figurePen(FigureRole::downEdge, medium).style(), Qt::CustomDashLine);
        QCOMPARE(figurePen(FigureRole::mean, medium).dashPattern().size(), qsizetype{4});
    }
    // A copier of one bit keeps both: neither is lighter than 58 % black. Dashes and markers tell them apart
    // there.
    for (const FigureRole role : {FigureRole::up, FigureRole::down, FigureRole::clockwise})
        QVERIFY(qGray(figureColor(role, Medium::paper).rgb()) <= 0.42 * 255);
    const int bandUp = qGray(bandColor(true, false, Medium::paper).rgb());
    const int both = qGray(bandColor(true, true, Medium::paper).rgb());
    QVERIFY(both < bandUp);
}

void Style::coloursAreOpaque() {
    for (const Medium medium : {Medium::paper, Medium::screenLight, Medium::screenDark}) {
        for (int role = int(FigureRole::background); role <= int(FigureRole::leader); ++role)
            QCOMPARE(figureColor(static_cast<FigureRole>(role), medium).alpha(), 255);
        for (const bool up : {false, true}) {
            for (const bool down : {false, true})
                QCOMPARE(bandColor(up, down, medium).alpha(), 255);
        }
    }
    // 12 % of #004488 on white.
    QCOMPARE(bandColor(true, false, Medium::paper), QColor(224, 233, 241));
}

QTEST_GUILESS_MAIN(Style)
#include "style.moc"
