// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "language/language.h"

#include <QTest>
#include <cmath>

using namespace palmer;

namespace {

constexpr DisplayUnits millimetres{LengthDisplay::millimetres, AngleDisplay::arcSeconds};
constexpr DisplayUnits inches{LengthDisplay::inches, AngleDisplay::arcSeconds};
constexpr DisplayUnits degrees{LengthDisplay::micrometres, AngleDisplay::degrees};

} // namespace

class UnitsTest : public QObject {
    Q_OBJECT

private slots:
    void showsInTheUnitChosen_data() {
        QTest::addColumn<DisplayUnits>("units");
        QTest::addColumn<Quantity>("quantity");
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("shown");

        // clang-format off
        QTest::newRow("deviation in µm")             << DisplayUnits{} << Quantity::deviation << 0.0162   << 1  << "16.2\u00a0µm";
        QTest::newRow("the same in mm")              << millimetres << Quantity::deviation    << 0.0162   << 1  << "0.0162\u00a0mm";
        QTest::newRow("the same in µin")             << inches << Quantity::deviation         << 0.0162   << 1  << "638\u00a0µin";
        QTest::newRow("all digits in mm")            << millimetres << Quantity::deviation    << 0.0162   << -1 << "0.0162\u00a0mm";
        QTest::newRow("all digits in µin")           << inches << Quantity::deviation         << 0.00254  << -1 << "100\u00a0µin";
        QTest::newRow("position in mm")              << DisplayUnits{} << Quantity::position  << 1500.41  << 2  << "1\u202f500.41\u00a0mm";
        QTest::newRow("the same in inches")          << inches << Quantity::position          << 1500.41  << 2  << "59.0713\u00a0in";
        QTest::newRow("an inch")                     << inches << Quantity::position          << 25.4     << -1 << "1\u00a0in";
        QTest::newRow("angular deviation in ″")      << DisplayUnits{} << Quantity::angularDeviation << 0.0015 << 1 << "5.4″";
        QTest::newRow("the same in degrees")         << degrees << Quantity::angularDeviation << 0.0015   << 1  << "0.00150°";
        QTest::newRow("entered in µm, in mm")        << millimetres << Quantity::micrometres  << 1.2      << 1  << "0.0012\u00a0mm";
        QTest::newRow("entered in µm, in µin")       << inches << Quantity::micrometres       << 2.54     << -1 << "100\u00a0µin";
        QTest::newRow("entered in ″, in degrees")    << degrees << Quantity::arcSeconds       << 5.4      << 1  << "0.00150°";
        QTest::newRow("temperatures stay")           << inches << Quantity::temperature       << 20.5     << 1  << "20.5\u00a0°C";
        // clang-format on
    }

    void showsInTheUnitChosen() {
        QFETCH(DisplayUnits, units);
        QFETCH(Quantity, quantity);
        QFETCH(double, value);
        QFETCH(int, decimals);
        QFETCH(QString, shown);
        const Language language = Language(Language::Id::english).withUnits(units);
        QCOMPARE(language.quantity(value, quantity, decimals), shown);
        QCOMPARE(Language(Language::Id::english).units(), DisplayUnits());
    }

    void scaleIsThatOfTheNumberShown() {
        for (const DisplayUnits &units : {DisplayUnits{}, millimetres, inches, degrees}) {
            for (const Quantity quantity :
                 {Quantity::deviation, Quantity::position, Quantity::angle, Quantity::angularDeviation,
                  Quantity::feed, Quantity::micrometres, Quantity::arcSeconds}) {
                const double typed = fromShown("1", quantity, units);
                // A millionth of a micrometre is what a conversion keeps.
                QVERIFY(std::abs(typed * unitScale(quantity, units) - 1) <
                        1e-9 * unitScale(quantity, units) + 1e-12);
            }
        }
        QVERIFY(std::isnan(fromShown("", Quantity::deviation)));
        QVERIFY(std::isnan(fromShown("1,5", Quantity::deviation)));
    }
};

QTEST_GUILESS_MAIN(UnitsTest)
#include "unitstest.moc"
