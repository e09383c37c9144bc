// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/coefficients.h"

#include <QTest>

#include <cmath>

using namespace palmer;

namespace {

/// Five readings up, three down: a mean has 1/5 or 1/3 of the variance of one reading, s 1/4 or 1/2.
RulingReadings five(std::optional<Direction> approach) {
    return {5, 3, approach};
}

const Rulers twoTargets{five(Direction::positive), five(Direction::negative), false};
const Rulers bothDirections{five(std::nullopt), five(std::nullopt), false};
const Rulers oneTarget{five(Direction::positive), five(Direction::negative), true};
const Rulers oneEnd{five(Direction::positive), five(Direction::positive), true};

} // namespace

/// How contributions combine: each row by hand, c = 2.
class CoefficientsTest : public QObject {
    Q_OBJECT

private slots:
    void rowByHand_data() {
        QTest::addColumn<Rulers>("rulers");
        QTest::addColumn<bool>("systematic");
        QTest::addColumn<double>("factor");
        constexpr double means = 1.0 / 5 + 1.0 / 3;
        constexpr double scatters = 1.0 / 4 + 1.0 / 2;
        const auto row = [](const char *id, const Rulers &rulers, bool systematic, double factor) {
            QTest::addRow("%s %d%d", id, rulers.sameTarget ? 1 : 0,
                          rulers.lower.approach == Direction::negative ? 1 : 0)
                << rulers << systematic << factor;
        };
        for (const char *id : {"A", "A+", "A-"}) {
            row(id, twoTargets, true, means + 4 * scatters);
            row(id, oneTarget, true, means + 4 * scatters);
            row(id, oneEnd, true, 4.0 * 4 / 4);
        }
        for (const char *id : {"E", "E+", "E-"})
            row(id, twoTargets, true, means);
        for (const char *id : {"M", "Pa"})
            row(id, bothDirections, true, means / 2);
        for (const char *id : {"R", "R+", "R-", "UPR"}) {
            row(id, bothDirections, false, means + 4 * scatters);
            row(id, oneEnd, false, 4.0 * 4 / 4);
        }
        for (const char *id : {"r", "r+", "r-"})
            row(id, bothDirections, false, 4.0 * 4 / 2); // the fewer
        for (const char *id : {"B", "Bmean", "Umax", "Umean"})
            row(id, bothDirections, false, means);
        row("P", twoTargets, true, means + 4 * 2 * scatters / 4);
        row("P", oneTarget, true, means + 4 * scatters);
        for (const char *id : {"Psmax", "Psmean"})
            row(id, bothDirections, false, 4 * scatters);
    }

    void rowByHand() {
        QFETCH(Rulers, rulers);
        QFETCH(bool, systematic);
        QFETCH(double, factor);
        const QByteArray tag = QTest::currentDataTag();
        const Coefficients *row = coefficients(tag.left(tag.indexOf(' ')).toStdString());
        QVERIFY(row);
        const auto u = combined(*row, 3, 0.5, rulers, 2);
        QVERIFY(u);
        const double expected = std::sqrt((systematic ? 9 : 0) + factor * 0.25);
        QVERIFY2(std::abs(*u - expected) < 1e-14, qPrintable(QString::number(*u))); // a few roundings of 3
    }

    /// A mean needs a reading, an s two.
    void tooFewReadingsHaveNoUncertainty() {
        const auto has = [](const char *id, int up, int down) {
            const RulingReadings end{up, down, std::nullopt};
            return combined(*coefficients(id), 1, 1, {end, end, false}, 2).has_value();
        };
        QVERIFY(has("E", 1, 1) && !has("E", 0, 1) && !has("E", 1, 0));
        QVERIFY(has("A", 2, 2) && !has("A", 1, 2) && !has("A", 2, 1));
        QVERIFY(has("Psmax", 2, 2) && !has("Psmax", 2, 1));
    }

    void unknownIdsHaveNoRow() {
        QVERIFY(!coefficients("a"));
        QVERIFY(!coefficients(""));
    }
};

QTEST_GUILESS_MAIN(CoefficientsTest)
#include "coefficients.moc"
