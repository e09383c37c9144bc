// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/contribution.h"

#include "kernel/uncertainty/simulation.h"

#include <QTest>

#include <cmath>

using namespace palmer;

namespace {

Contribution contribution(const char *id, std::optional<double> expanded, bool applies = true) {
    return {id, {}, {}, expanded, applies, {}};
}

QByteArray ids(const std::vector<const Contribution *> &contributions) {
    QByteArray result;
    for (const Contribution *one : contributions)
        result += one->id;
    return result;
}

} // namespace

/// Budgets as they are read: order, shares, what to improve; figures of simulations.
class ContributionTest : public QObject {
    Q_OBJECT

private slots:
    void unknownFirstThenBySize() {
        const std::vector all{contribution("a", 1.0),     contribution("-", 0.0, false),
                              contribution("0", 0.0),     contribution("c", 3.0),
                              contribution("?", {}),      contribution("b", 1.0),
                              contribution("=", 0, false)};
        QCOMPARE(ids(bySize(all)), QByteArray("?cab0-=")); // equal ones in their order
    }

    void sharesOfTheSquares() {
        const std::vector all{contribution("a", 3.0), contribution("b", 4.0), contribution("?", {})};
        QCOMPARE(shareOf(all[0], all), 9.0 / 25);
        QCOMPARE(shareOf(all[1], all), 16.0 / 25);
        QCOMPARE(shareOf(all[2], all), 0.0);
        const std::vector none{contribution("a", 0.0), contribution("?", {})};
        QCOMPARE(shareOf(none[0], none), 0.0);
    }

    void theLargestIsToImprove() {
        const std::vector all{contribution("?", {}), contribution("a", 1.0), contribution("b", 2.0)};
        QCOMPARE(toImproveFirst(all), &all[2]);
        QVERIFY(!toImproveFirst({}));
        QVERIFY(!toImproveFirst({contribution("a", 0.0)}));
        QVERIFY(!toImproveFirst({contribution("?", {})}));
        // each of n alike makes 1/n: 5 % of 20, less of 21
        const std::vector twenty(20, contribution("a", 1.0));
        QCOMPARE(toImproveFirst(twenty), &twenty[0]);
        QVERIFY(!toImproveFirst(std::vector(21, contribution("a", 1.0))));
    }

    void toleranceIsHalfOfTheSecondDigit() {
        QVERIFY(std::abs(numericalTolerance(1.5) - 0.05) < 1e-15);
        QVERIFY(std::abs(numericalTolerance(9.9) - 0.05) < 1e-15);
        QVERIFY(std::abs(numericalTolerance(10) - 0.5) < 1e-15);
        QVERIFY(std::abs(numericalTolerance(0.0023) - 0.00005) < 1e-18);
        QCOMPARE(numericalTolerance(0), 0.0);
        QCOMPARE(numericalTolerance(-1), 0.0);
        QCOMPARE(numericalTolerance(std::nan("")), 0.0);
    }

    void figuresOfAParameter() {
        // U = (13 − 7)/2, shift 10 − 9, guarded by 2 s_U
        SimulatedParameter p{"A", 9, 10, 1.5, 7, 13, {}, {}};
        QCOMPARE(p.expanded(), 3.0);
        QCOMPARE(p.shift(), 1.0);
        QCOMPARE(p.guarded(), 3.0);
        p.expandedError = 0.25;
        QCOMPARE(p.guarded(), 3.5);
        QCOMPARE(p.tolerance(), numericalTolerance(1.5));
        QVERIFY(!p.largeShift()); // 1 is a third of 3
        p.value = 8.999;
        QVERIFY(p.largeShift());
        p.value = 11.001;
        QVERIFY(p.largeShift());
    }

    void parametersAreFoundById() {
        Simulation simulation;
        simulation.parameters = {{"A", 1, 1, 0, 1, 1, {}, {}}, {"E", 2, 2, 0, 2, 2, {}, {}}};
        QCOMPARE(simulation.find("E"), &simulation.parameters[1]);
        QVERIFY(!simulation.find("M"));
    }
};

QTEST_APPLESS_MAIN(ContributionTest)
#include "contribution.moc"
