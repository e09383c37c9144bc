// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "language/rounding.h"

#include <QProcess>
#include <QTest>
#ifndef Q_MOC_RUN // moc 6.4 does not understand it
#include <bit>
#endif
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

using namespace palmer;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Exact arithmetic of another make: one line "hex-double shift decimals" in, the rounded and the shortest
/// number out, "-0" without its sign.
constexpr char exactRounding[] = R"(
import sys
from decimal import Decimal, ROUND_HALF_EVEN, getcontext
getcontext().prec = 2000
for line in sys.stdin:
    value, shift, decimals = line.split()
    exact = Decimal(repr(float.fromhex(value))).scaleb(int(shift))
    number = exact.quantize(Decimal(1).scaleb(-int(decimals)), rounding=ROUND_HALF_EVEN)
    kept = number
    if 20 * abs(kept) < 19 * abs(exact):
        kept += Decimal(1).scaleb(-int(decimals)).copy_sign(exact)
    print(*('{:f}'.format(abs(x) if x.is_zero() else x) for x in (number, kept)))
)";

} // namespace

class RoundingTest : public QObject {
    Q_OBJECT

private slots:
    void roundsTheShortestDecimal_data();
    void roundsTheShortestDecimal();
    void roundsEveryTieToEven();
    void agreesWithExactDecimals();
    void printsAllDigits_data();
    void printsAllDigits();
    void printsAllDigitsSoThatTheyReadBack();
    void showsUnits_data();
    void showsUnits();
    void roundsUncertainties_data();
    void roundsUncertainties();
    void ordersAsTheNumbers();
    void choosesDecimals_data();
    void choosesDecimals();
};

void RoundingTest::roundsTheShortestDecimal_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("shift");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *name, double value, int shift, int decimals, QString expected) {
        QTest::newRow(name) << value << shift << decimals << expected;
    };
    // clang-format off
    row("tie to even, down",             0.00125,  3, 1, "1.2");
    row("tie to even, up",               0.00135,  3, 1, "1.4");
    row("negative tie to even",         -0.00125,  3, 1, "-1.2");
    row("negative tie, up",             -0.00135,  3, 1, "-1.4");
    row("stored just below the tie",     2.675,    0, 2, "2.68");
    row("beyond the tie",                0.00125000000000001, 3, 1, "1.3");
    row("before the tie",                0.00124999999999999, 3, 1, "1.2");
    row("tie at zero",                   0.5,      0, 0, "0");
    row("beyond the tie at zero",        0.51,     0, 0, "1");
    row("tie at one",                    1.5,      0, 0, "2");
    row("tie at two",                    2.5,      0, 0, "2");
    row("carry through nines",           9.9996,   0, 3, "10.000");
    row("carry from nothing",            0.00096,  0, 3, "0.001");
    row("carry up to nothing kept",      0.96,     0, 0, "1");
    row("carry in the middle",           1.9996,   0, 3, "2.000");
    row("zeros dropped before a carry",  100.05,   0, 1, "100.0");
    row("zeros kept before a carry",     100.06,   0, 1, "100.1");
    row("padding",                       0.5,      0, 4, "0.5000");
    row("padding a whole number",        120,      0, 2, "120.00");
    row("zero",                          0.0,      3, 1, "0.0");
    row("minus zero",                   -0.0,      3, 1, "0.0");
    row("never minus nought",           -0.00004,  3, 1, "0.0");
    row("minus tie at nought",          -0.00005,  3, 1, "0.0");
    row("minus beyond the tie",         -0.000051, 3, 1, "-0.1");
    row("far below the last place",      4.9e-324, 3, 1, "0.0");
    row("denormal",                      5e-324,   0, 325, "0." + QString(323, u'0') + "50");
    row("denormal tie",                  5e-324,   0, 323, "0." + QString(323, u'0'));
    row("denormal to one",               5e-324,   1, 323, "0." + QString(322, u'0') + "5");
    row("huge",                          1e300,    3, 1, "1" + QString(303, u'0') + ".0");
    row("largest", std::numeric_limits<double>::max(), 0, 0, "17976931348623157" + QString(292, u'0'));
    row("not a number", notANumber, 3, 1, "nan");
    row("minus not a number", -notANumber, 3, 1, "nan");
    row("infinite",  infinite, 3, 1, "inf");
    row("minus infinite", -infinite, 3, 1, "-inf");
    // clang-format on
}

void RoundingTest::roundsTheShortestDecimal() {
    QFETCH(double, value);
    QFETCH(int, shift);
    QFETCH(int, decimals);
    QTEST(QString::fromStdString(Decimal(value, shift).rounded(decimals)), "expected");
}

void RoundingTest::roundsEveryTieToEven() {
    // i.5 tenths of a µm, written as mm: whole numbers say what is even.
    for (int i = 0; i < 100'000; ++i) {
        const double value = (QString::number(i) + ".5e-4").toDouble();
        const int even = i + i % 2;
        const auto expected = QString("%1.%2").arg(even / 10).arg(even % 10);
        QCOMPARE(QString::fromStdString(Decimal(value, Quantity::deviation).rounded(1)), expected);
        if (even > 0)
            QCOMPARE(QString::fromStdString(Decimal(-value, Quantity::deviation).rounded(1)), "-" + expected);
    }
}

void RoundingTest::agreesWithExactDecimals() {
    std::mt19937_64 random(230);
    std::uniform_int_distribution<int> shifts(-3, 6), places(0, 12), kind(0, 19), digits(1, 17),
        exponents(-12, 12);
    std::uniform_int_distribution<qint64> mantissas(-999'999'999'999'999'999, 999'999'999'999'999'999);
    std::vector<Decimal> numbers;
    std::vector<int> decimals;
    QByteArray input;
    while (numbers.size() < 100'000) {
        double value = 0;
        const int chosen = kind(random);
        if (chosen == 0) // any bit pattern: all magnitudes, denormal numbers
            value = std::bit_cast<double>(random());
        else // few digits, often ending in 5: ties are frequent
            value = (QByteArray::number(mantissas(random)).left(digits(random) + 1).replace("-", "") +
                     (chosen < 6 ? "" : "5") + "e" + QByteArray::number(exponents(random) - 3))
                        .toDouble() *
                    (random() % 2 == 0 ? 1 : -1);
        if (!std::isfinite(value))
            continue;
        const int shift = shifts(random);
        numbers.emplace_back(value, shift);
        decimals.push_back(places(random));
        std::array<char, 80> line;
        input.append(line.data(),
                     std::snprintf(line.data(), line.size(), "%a %d %d\n", value, shift, decimals.back()));
    }
    QProcess python;
    python.start("/usr/bin/python3", {"-c", exactRounding});
    QVERIFY(python.waitForStarted());
    python.write(input);
    python.closeWriteChannel();
    QVERIFY(python.waitForFinished(patience));
    QVERIFY2(python.exitCode() == 0, python.readAllStandardError());
    const auto lines = python.readAllStandardOutput().trimmed().split('\n');
    QCOMPARE(lines.size(), static_cast<qsizetype>(numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto expected = lines[static_cast<qsizetype>(i)].split(' ');
        QCOMPARE(QByteArray::fromStdString(numbers[i].rounded(decimals[i])), expected[0]);
        QCOMPARE(QByteArray::fromStdString(numbers[i].roundedUncertainty(decimals[i])), expected[1]);
    }
}

void RoundingTest::printsAllDigits_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("shift");
    QTest::addColumn<QString>("expected");
    QTest::newRow("as entered") << 0.01 << 3 << "10";
    QTest::newRow("fraction") << -0.0125 << 3 << "-12.5";
    QTest::newRow("no rounding") << 0.1 + 0.2 << 0 << "0.30000000000000004";
    QTest::newRow("zero") << -0.0 << 0 << "0";
    QTest::newRow("largest without exponent") << 1.5e20 << 0 << "150000000000000000000";
    QTest::newRow("exponent") << 1.5e21 << 0 << "1.5e21";
    QTest::newRow("huge") << -1e300 << 3 << "-1e303";
    QTest::newRow("smallest without exponent") << 1.5e-6 << 0 << "0.0000015";
    QTest::newRow("small exponent") << 1.5e-7 << 0 << "1.5e-7";
}

void RoundingTest::printsAllDigits() {
    QFETCH(double, value);
    QFETCH(int, shift);
    QTEST(QString::fromStdString(Decimal(value, shift).shortest()), "expected");
    QTEST(QString::fromStdString(Decimal(value, shift).rounded(-1)), "expected");
}

void RoundingTest::printsAllDigitsSoThatTheyReadBack() {
    std::mt19937_64 random(2304);
    for (int i = 0; i < 100'000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (std::isfinite(value))
            QCOMPARE(std::stod("0" + Decimal(std::abs(value) < 1e-307 ? 0 : std::abs(value)).shortest()),
                     std::abs(value) < 1e-307 ? 0 : std::abs(value)); // stod throws at denormal numbers
    }
}

void RoundingTest::showsUnits_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<QString>("expected");
    QTest::newRow("deviation in µm") << 0.0162 << Quantity::deviation << "16.2";
    QTest::newRow("position in mm") << 123.45 << Quantity::position << "123.45";
    QTest::newRow("uncertainty entered in µm") << 0.6 << Quantity::micrometres << "0.6";
    QTest::newRow("angle in degrees") << 359.5 << Quantity::angle << "359.5";
    QTest::newRow("angular deviation in arc seconds") << 0.0001 << Quantity::angularDeviation << "0.36";
    QTest::newRow("arc seconds come back as entered") << 1.25 / 3600 << Quantity::angularDeviation << "1.25";
    QTest::newRow("seven arc seconds") << 7.0 / 3600 << Quantity::angularDeviation << "7";
    QTest::newRow("negative arc seconds") << -0.45 / 3600 << Quantity::angularDeviation << "-0.45";
}

void RoundingTest::showsUnits() {
    QFETCH(double, value);
    QFETCH(Quantity, quantity);
    QTEST(QString::fromStdString(Decimal(value, quantity).shortest()), "expected");
}

void RoundingTest::roundsUncertainties_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("expected");
    QTest::newRow("half to even") << 0.25 << 1 << "0.3"; // 0.2 would lose a fifth
    QTest::newRow("down where little is lost") << 10.44 << 1 << "10.4";
    QTest::newRow("down, 4.8 %") << 1.05 << 1 << "1.0";
    QTest::newRow("up, 5.1 %") << 0.74 << 1 << "0.8";
    QTest::newRow("down, 4.9 %") << 0.841 << 1 << "0.8";
    QTest::newRow("never zero") << 0.001 << 1 << "0.1";
    QTest::newRow("tiny, never zero") << 5e-324 << 1 << "0.1";
    QTest::newRow("zero stays zero") << 0.0 << 1 << "0.0";
    QTest::newRow("up with a carry") << 0.949 << 0 << "1";
    QTest::newRow("huge") << 1e300 << 0 << "1" + QString(300, u'0');
    QTest::newRow("exact") << 2.5 << 1 << "2.5";
}

void RoundingTest::roundsUncertainties() {
    QFETCH(double, value);
    QFETCH(int, decimals);
    QTEST(QString::fromStdString(Decimal(value).roundedUncertainty(decimals)), "expected");
}

void RoundingTest::ordersAsTheNumbers() {
    std::mt19937_64 random(88);
    std::vector<double> values{0.0, -0.0,   1,       -1,    10,     9.99,     10.04,
                               0.1, 5e-324, -5e-324, 1e300, -1e300, infinite, -infinite};
    for (int i = 0; i < 300; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isnan(value))
            values.push_back(value), values.push_back(std::nextafter(value, 0.0));
    }
    for (const double a : values)
        for (const double b : values) {
            QCOMPARE(Decimal(a) < Decimal(b), a < b);
            QCOMPARE(Decimal(a) == Decimal(b), a == b);
        }
}

void RoundingTest::choosesDecimals_data() {
    QTest::addColumn<double>("expanded"); // µm
    QTest::addColumn<double>("resolution");
    QTest::addColumn<int>("expected");
    QTest::newRow("two significant digits") << 1.2 << 0.0 << 1;
    QTest::newRow("two digits of tenths") << 0.45 << 0.0 << 2;
    QTest::newRow("never coarser than 0.1") << 14.5 << 0.0 << 1;
    QTest::newRow("large") << 1e300 << 0.0 << 1;
    QTest::newRow("0.0994 is 0.099") << 0.0994 << 0.0 << 3;
    QTest::newRow("0.0996 is 0.10") << 0.0996 << 0.0 << 2;
    QTest::newRow("0.996 is 1.0") << 0.996 << 0.0 << 1;
    QTest::newRow("exactly a power") << 0.01 << 0.0 << 3;
    QTest::newRow("finest") << 1e-9 << 0.0 << 4;
    QTest::newRow("denormal") << 5e-324 << 0.0 << 4;
    QTest::newRow("resolution 0.1") << 0.045 << 0.1 << 1;
    QTest::newRow("resolution 0.01") << 0.045 << 0.01 << 2;
    QTest::newRow("resolution 0.05 forbids hundredths") << 0.045 << 0.05 << 1;
    QTest::newRow("resolution finer than needed") << 0.45 << 0.001 << 2;
    QTest::newRow("coarse resolution, not coarser than 0.1") << 14.5 << 1.0 << 1;
    QTest::newRow("zero says nothing") << 0.0 << 0.001 << 1;
    QTest::newRow("negative says nothing") << -0.045 << 0.0 << 1;
    QTest::newRow("not a number says nothing") << notANumber << 0.0 << 1;
}

void RoundingTest::choosesDecimals() {
    QFETCH(double, expanded);
    QFETCH(double, resolution);
    const auto step = resolution > 0 ? std::optional(resolution) : std::nullopt;
    QTEST(decimalsWithUncertainty(expanded, Quantity::micrometres, step), "expected");
    // The same in the base units of results.
    if (expanded > 1e-300 && expanded < 1e300 && resolution == 0)
        QTEST(decimalsWithUncertainty(expanded * 1e-3, Quantity::deviation), "expected");
    if (expanded > 1e-300 && expanded < 1e300 && resolution > 0 && resolution < 1)
        QTEST(decimalsWithUncertainty(expanded / 3600, Quantity::angularDeviation, resolution / 3600),
              "expected");
}

QTEST_GUILESS_MAIN(RoundingTest)
#include "roundingtest.moc"
