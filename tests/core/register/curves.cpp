// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "register/curves.h"

#include <QTest>

using namespace palmer;

class CurvesTest : public QObject {
    Q_OBJECT

private slots:
    void meansOfDirections() {
        const std::vector<CurvePoint> curve{{0, 1.0, 3.0}, {10, 2.0, {}}, {20, {}, 4.0}};
        QVERIFY(meansOf(curve, CurveOf::both) == (std::vector<PlacedValue>{{0, 2.0}, {10, {}}, {20, {}}}));
        QVERIFY(meansOf(curve, CurveOf::up) == (std::vector<PlacedValue>{{0, 1.0}, {10, 2.0}, {20, {}}}));
        QVERIFY(meansOf(curve, CurveOf::down) == (std::vector<PlacedValue>{{0, 3.0}, {10, {}}, {20, 4.0}}));
    }
    /// Both are straight: the difference is known at every target of either.
    void differsOnTheCommonTravel() {
        const std::vector<PlacedValue> a{{0, 0.0}, {100, 10.0}, {200, 20.0}};
        const std::vector<PlacedValue> b{{50, 1.0}, {150, 1.0}, {250, 1.0}};
        const auto difference = differenceOf(a, b);
        QVERIFY(difference);
        QCOMPARE(difference->from, 50.0);
        QCOMPARE(difference->to, 200.0);
        QVERIFY(difference->values ==
                (std::vector<PlacedValue>{{50, 4.0}, {100, 9.0}, {150, 14.0}, {200, 19.0}}));
        QVERIFY(difference->largest == PlacedValue({200, 19.0}));
        QVERIFY(differenceOf(b, a)->largest == PlacedValue({200, -19.0}));
    }
    void nothingIsMadeUpOverAGap() {
        const std::vector<PlacedValue> a{{0, 0.0}, {100, {}}, {200, 20.0}, {300, 30.0}};
        const std::vector<PlacedValue> b{{0, 0.0}, {50, 0.0}, {150, 0.0}, {250, 0.0}, {300, 0.0}};
        const auto difference = differenceOf(a, b);
        QVERIFY(difference->values ==
                (std::vector<PlacedValue>{
                    {0, 0.0}, {50, {}}, {100, {}}, {150, {}}, {200, 20.0}, {250, 25.0}, {300, 30.0}}));
    }
    void withoutCommonTravel() {
        QVERIFY(!differenceOf({{0, 1.0}, {10, 1.0}}, {{20, 1.0}, {30, 1.0}}));
        QVERIFY(!differenceOf({{0, 1.0}, {10, 1.0}}, {{10, 1.0}, {30, 1.0}}));
        QVERIFY(!differenceOf({}, {{0, 1.0}}));
    }
};

QTEST_GUILESS_MAIN(CurvesTest)
#include "curves.moc"
