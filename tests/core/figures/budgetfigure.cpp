// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "core/kernel/uncertainty/uncertaintydata.h"

#include <QTest>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

Test x1(UncertaintyMethod method = UncertaintyMethod::budget) {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    measurement(test).uncertainty.length = 500;
    measurement(test).uncertainty.method = method;
    return test;
}

BarFigure figureOf(const Test &test, Language::Id language = Language::Id::english) {
    return budgetFigure(test, evaluated(test), Language(language));
}

} // namespace

/// The contributions to an uncertainty as bars.
class BudgetFigureTest : public QObject {
    Q_OBJECT

private slots:
    void theLargestIsFirst() {
        const BarFigure figure = figureOf(x1());
        // X1 at L 500: 3.60, 3.00, 1.80, 0.75, 0.60 µm, of which 3.60² makes 49.6 % of the sum of the
        // squares.
        QCOMPARE(figure.bars.size(), std::size_t{7});
        QCOMPARE(figure.bars[0].id, u"temperatureMachine"_s);
        QCOMPARE(figure.bars[0].name, u"Temperature of the machine"_s);
        QCOMPARE(figure.bars[0].value, u"3.60"_s);
        QCOMPARE(figure.bars[0].share, u"50"_s);
        QVERIFY(figure.bars[0].first);
        QVERIFY(std::abs(figure.bars[0].size - 3.6) < 1e-9);
        for (std::size_t i = 1; i < figure.bars.size(); ++i) {
            QVERIFY(figure.bars[i].size <= figure.bars[i - 1].size);
            QVERIFY(!figure.bars[i].first);
        }
        QVERIFY(figure.note.contains(u"temperature of the machine"_s));
    }

    void theScaleHoldsAllBars() {
        const BarFigure figure = figureOf(x1());
        QCOMPARE(figure.x.from, 0.0);
        QCOMPARE(figure.x.to, 4.0); // 1-1.2-1.5-2-2.5-3-4 …
        QCOMPARE(figure.x.unit, u"µm"_s);
        QVERIFY(!figure.x.ticks.empty());
    }

    void whatDoesNotApplyHasADash() {
        const BarFigure figure = figureOf(x1()); // a laser has no expansion
        QCOMPARE(figure.bars.back().value, u"–"_s);
        QCOMPARE(figure.bars.back().share, u"–"_s);
        QCOMPARE(figure.bars.back().size, 0.0);
    }

    void theUnknownComesFirstWithoutABar() {
        Test test = x1();
        measurement(test).uncertainty.misalignmentRange.reset();
        const BarFigure figure = figureOf(test);
        QCOMPARE(figure.bars[0].id, u"misalignment"_s);
        QCOMPARE(figure.bars[0].value, u"–"_s);
        QCOMPARE(figure.bars[0].size, 0.0);
        QVERIFY(figure.note.isEmpty()); // of half a budget nothing is said to be first
        for (const Bar &bar : figure.bars)
            QVERIFY(!bar.first);
    }

    void theIndexOfEveStandsLower() {
        const BarFigure figure = figureOf(x1());
        const auto found = std::ranges::find(figure.bars, u"environmentalVariation"_s, &Bar::id);
        QVERIFY(found != figure.bars.end());
        QVERIFY(found->name.endsWith(u"E"_s));
        QCOMPARE(found->subscript, u"VE"_s);
    }

    void nothingWithoutABudget() {
        QVERIFY(figureOf(x1(UncertaintyMethod::none)).bars.empty());
        QVERIFY(figureOf(x1(UncertaintyMethod::direct)).bars.empty());
        QVERIFY(!figureOf(x1(UncertaintyMethod::monteCarlo)).bars.empty());
    }

    void rotaryAxesSpeakArcSeconds() {
        Test test = positioningTest("ISO 230-2:2006", {0, 90}, {{0, 100}, {0, 100}}, {});
        measurement(test).axis.motion = Motion::rotary;
        measurement(test).uncertainty.method = UncertaintyMethod::budget;
        measurement(test).uncertainty.device.fixed = 1;
        measurement(test).uncertainty.environmentalVariation = 2;
        const BarFigure figure = figureOf(test);
        QCOMPARE(figure.x.unit, u"″"_s);
        QCOMPARE(figure.bars[0].value, u"1.20"_s);
    }

    void shares_data() {
        QTest::addColumn<double>("share");
        QTest::addColumn<QString>("text");
        QTest::newRow("nothing") << 0.0 << u"0"_s;
        QTest::newRow("little") << 0.004 << u"<\u00A01"_s;
        QTest::newRow("half a percent") << 0.0051 << u"1"_s;
        QTest::newRow("all") << 1.0 << u"100"_s;
    }

    void shares() {
        QFETCH(double, share);
        QFETCH(QString, text);
        QCOMPARE(shareText(share, Language(Language::Id::english)), text);
    }
};

QTEST_APPLESS_MAIN(BudgetFigureTest)
#include "budgetfigure.moc"
