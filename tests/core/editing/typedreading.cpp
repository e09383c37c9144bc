// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "editing/typedreading.h"

#include "language/language.h"

#include <QTest>
#include <random>

using namespace palmer;

namespace {

Axis axis(Motion motion) {
    Axis result;
    result.motion = motion;
    return result;
}

constexpr DisplayUnits usual;
constexpr DisplayUnits millimetres{LengthDisplay::millimetres, AngleDisplay::degrees};
constexpr DisplayUnits inches{LengthDisplay::inches, AngleDisplay::arcSeconds};

} // namespace

class TypedReadingTest : public QObject {
    Q_OBJECT

private slots:
    void isTheDecimalThatWasTyped() {
        QCOMPARE(*typedReading(u"5,4", axis(Motion::linear), usual).value, 0.0054);
        QCOMPARE(*typedReading(u"-0.3", axis(Motion::linear), usual).value, -0.0003);
        QCOMPARE(*typedReading(u"0.0054", axis(Motion::linear), millimetres).value, 0.0054);
        QCOMPARE(*typedReading(u"100", axis(Motion::linear), inches).value, 0.00254);
        QCOMPARE(*typedReading(u"36", axis(Motion::rotary), usual).value, 0.01);
        QCOMPARE(*typedReading(u"0.01", axis(Motion::rotary), millimetres).value, 0.01);
    }

    void positionsBecomeDeviations() {
        QCOMPARE(*typedReading(u"150.7154", axis(Motion::linear), usual, 150.71).value, 0.0054);
        QCOMPARE(*typedReading(u"1050,0152", axis(Motion::linear), usual, 1050.02).value, -0.0048);
        QCOMPARE(*typedReading(u"1", axis(Motion::linear), inches, 25.4).value, 0.0);
        QCOMPARE(*typedReading(u"90.0011", axis(Motion::rotary), usual, 90).value, 0.0011);
    }

    void refusesAndKeepsEmpty() {
        for (const char16_t *nothing : {u"", u"  ", u"–", u"-"}) {
            const NumberEntry entry = typedReading(nothing, axis(Motion::linear), usual);
            QVERIFY(!entry.value && !entry.refusal);
        }
        QCOMPARE(typedReading(u"4,,8", axis(Motion::linear), usual).refusal,
                 std::optional(REPORT_TEXT("report", "two commas")));
    }

    /// What the test file refuses is refused where it is typed, from both sides of the bound.
    void staysWithinWhatAFileHolds() {
        for (const char16_t *held : {u"1000000", u"-1000000", u"999999.999"})
            QVERIFY(typedReading(held, axis(Motion::linear), millimetres).value);
        for (const char16_t *refused : {u"1000000.001", u"-1000000.001", u"1e15"}) {
            const NumberEntry entry = typedReading(refused, axis(Motion::linear), millimetres);
            QVERIFY(!entry.value && entry.refusal);
        }
        QVERIFY(typedReading(u"1000000001", axis(Motion::linear), usual).refusal); // µm
        QVERIFY(typedReading(u"1000001", axis(Motion::linear), usual, 0).refusal);
        QVERIFY(typedReading(u"1000001", axis(Motion::linear), usual, 1).value);
    }

    void aTargetLiesBetweenItsNeighbours() {
        PositioningMeasurement measurement;
        measurement.targets = {0, 100, 200};
        QCOMPARE(typedTarget(u"150,5", measurement, 1, usual).value, std::optional(150.5));
        QCOMPARE(typedTarget(u"-3", measurement, 0, usual).value, std::optional(-3.0));
        for (const char16_t *refused : {u"0", u"200", u"", u"12..5", u"1e999"}) {
            const TargetEntry entry = typedTarget(refused, measurement, 1, usual);
            QVERIFY(!entry.value && entry.refusal);
        }
        const auto refusal = typedTarget(u"250", measurement, 1, usual).refusal;
        QCOMPARE(Language(Language::Id::french).sentence(refusal.value()).contains(QStringLiteral("200")),
                 true);
    }

    void listsOfTargets_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<std::vector<double>>("targets"); // empty: refused
        const std::vector<double> three{0, 50, 1000.5};
        QTest::newRow("semicolons") << QStringLiteral("0; 50; 1000,5") << three;
        QTest::newRow("blanks") << QStringLiteral("0 50 1000.5") << three;
        QTest::newRow("lines") << QStringLiteral("0\n50\n1000,5\n") << three;
        QTest::newRow("tabs") << QStringLiteral("0\t50\t1000.5") << three;
        QTest::newRow("groups of three digits") << QStringLiteral("0;50;1 000,5") << three;
        QTest::newRow("blanks between hundreds")
            << QStringLiteral("100 200 300") << std::vector<double>{100, 200, 300};
        QTest::newRow("blanks between hundreds, comma")
            << QStringLiteral("100 150,71 300,85") << std::vector<double>{100, 150.71, 300.85};
        QTest::newRow("blanks between hundreds, point")
            << QStringLiteral("100 150.71 300.85") << std::vector<double>{100, 150.71, 300.85};
        QTest::newRow("a heading") << QStringLiteral("Position (mm)\n0\n50\n1000.5") << three;
        QTest::newRow("a heading with another unit") << QStringLiteral("P (m)\n0\n0.05\n1.0005") << three;
        QTest::newRow("a column of a table")
            << QStringLiteral("i\tP (mm)\t1 ↑ (µm)\n1\t0\t3\n2\t50\t4\n3\t1000.5\t5") << three;
        QTest::newRow("a line without the column")
            << QStringLiteral("i\tP (mm)\n1\t0\n2\t50\n0; 50; 100") << std::vector<double>();
        QTest::newRow("no number") << QStringLiteral("0; x; 100") << std::vector<double>();
        QTest::newRow("a unit of another motion") << QStringLiteral("P (°)\n0\n50") << std::vector<double>();
        QTest::newRow("words that say nothing") << QStringLiteral("hello\n0\n50") << std::vector<double>();
    }
    void listsOfTargets() {
        QFETCH(const QString, text);
        QFETCH(const std::vector<double>, targets);
        std::optional<PastedTargets> found;
        try {
            found = targetsFrom(text.toStdString(), axis(Motion::linear), usual);
        } catch (const Error &error) {
            QVERIFY(text.contains("°") &&
                    Language(Language::Id::english).sentence(error.message).contains("°"));
        }
        QCOMPARE(found.value_or(PastedTargets()).targets, targets);
    }

    /// The unit that was taken is said, and another can be chosen.
    void unitsOfTargets() {
        const auto read = [](const char *text, const ImportOptions &answers = {}) {
            return targetsFrom(text, axis(Motion::linear), usual, answers).value();
        };
        const PastedTargets plain = read("0\n0.5\n");
        QVERIFY(plain.units == (std::vector<ImportChoice>{{"positionUnit", "mm", Origin::guessed}}));
        QVERIFY(read("P (m)\n0\n0.5\n").units ==
                (std::vector<ImportChoice>{{"positionUnit", "m", Origin::recognised}}));
        const PastedTargets chosen = read("P (m)\n0\n0.5\n", {{"positionUnit", "in"}});
        QCOMPARE(chosen.targets, (std::vector<double>{0, 12.7}));
        QVERIFY(chosen.units == (std::vector<ImportChoice>{{"positionUnit", "in", Origin::chosen}}));
    }

    /// What is shown with all its digits and typed again is the same number.
    void shownAndTypedAgain() {
        std::mt19937 random(7); // NOLINT: the same every time
        std::uniform_int_distribution<int> tenths(-2000, 2000);
        for (const DisplayUnits &units : {usual, millimetres, inches}) {
            const Language language = Language(Language::Id::french).withUnits(units);
            for (int i = 0; i < 500; ++i) {
                const double deviation = tenths(random) / 1e4;
                const QString shown = language.number(deviation, Quantity::deviation);
                const auto again = typedReading(shown, axis(Motion::linear), units).value;
                QVERIFY(again);
                // In microinches to two digits: 0.01 µin are 0.25 nm.
                QVERIFY(std::abs(*again - deviation) <= (units == inches ? 2.6e-7 : 0.0));
            }
        }
    }
};

QTEST_GUILESS_MAIN(TypedReadingTest)
#include "typedreading.moc"
