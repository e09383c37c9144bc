// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/storedworkbook.h"
#include "tables/units.h"

#include <QTest>
#include <array>
#include <cmath>

using namespace palmer;

namespace {

const std::array foreignWords{"ppm",    "ppb",      "mA",   "mV",           "kHz",  "%",         "mm/min",
                              "µm/m",   "µm/V",     "nrad", "furlong",      "ft",   "counts",    "digits",
                              "mm/rev", "arcsec/m", "dm",   "tenths of µm", "mm/°", "Zehntel µm"};
const std::array factors{"x0.1%1", "0.1 %1", "1/10 %1", "10 %1", "%1 x 10", "%1/10", "10^-4 %1", "×10 %1"};
const std::array lengths{"µm", "um", "nm", "mm", "in"};
// What people put behind a heading, and no unit.
const std::array ordinaryWords{
    "1",         "forward",    "run 2",      "X",    "comp.",    "corrected", "rev",    "A",
    "abs",       "rel",        "NA",         "n.a.", "1/3",      "in/out",    "s/n 12", "laser",
    "am",        "with comp.", "Mittelwert", "brut", "mesure 1", "Lauf 1",    "new",    "after",
    "ISO 230-2", "F",          "-",          "+",    "↑",        "1A",        "pos"};

QByteArray withBrackets(const QString &word, int form) {
    return (form == 0 ? '(' + word + ')' : form == 1 ? '[' + word + ']' : '{' + word + '}').toUtf8();
}

const Question *find(const Imported &imported, std::string_view id) {
    const auto found = std::ranges::find(imported.questions, id, &Question::id);
    return found == imported.questions.end() ? nullptr : &*found;
}

QString choiceOf(const Imported &imported, std::string_view key) {
    const auto found = std::ranges::find(imported.choices, key, &ImportChoice::key);
    return found == imported.choices.end() ? QString() : QString::fromStdString(found->value);
}

QByteArray tableWith(const QByteArray &target, const QByteArray &reading) {
    return "Position" + target + ";Forward" + reading + ";Reverse" + reading + "\n0;1;2\n90;2;3\n180;3;4\n";
}

} // namespace

/// A unit that a heading names is never denied nor replaced by a guess.
class HeadingUnitsTest : public QObject {
    Q_OBJECT

private slots:
    void namesTheUnitItCannotTake_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("said");
        QStringList said;
        for (const char *word : foreignWords)
            said << word;
        for (const char *factor : factors) {
            for (const char *unit : lengths)
                said << QString(factor).arg(unit);
        }
        int form = 0;
        for (const QString &word : said) {
            const QByteArray heading = ' ' + withBrackets(word, ++form % 3);
            QTest::newRow(qPrintable("readings " + word)) << tableWith(" (mm)", heading) << "unit" << word;
            QTest::newRow(qPrintable("targets " + word))
                << tableWith(heading, " (µm)") << "positionUnit" << word;
        }
        for (const char *word : {"ppm", "mA", "x0.1µm", "1/10 µm", "%", "furlong"})
            QTest::newRow(qPrintable(QString("no brackets ") + word))
                << tableWith(" (mm)", ' ' + QByteArray(word)) << "unit" << QString(word);
        for (const char *word : {"0.1 µm", "µm x 10", "tenths of µm"})
            QTest::newRow(qPrintable(QString("of both columns, no brackets ") + word))
                << "Position (mm);Forward dev. in " + QByteArray(word) + ";Reverse dev. in " + word +
                       "\n0;1;2\n90;2;3\n180;3;4\n"
                << "unit" << QString(word);
        for (const char *word :
             {"Hundertstel", "centièmes", "hundredths", "thousandths", "ticks", "increments", "volts"})
            QTest::newRow(qPrintable(QString("behind in: ") + word))
                << "Position (mm);Forward deviation in " + QByteArray(word) + ";Reverse deviation in " +
                       word + "\n0;1;2\n90;2;3\n180;3;4\n"
                << "unit" << QString(word);
        QTest::newRow("row of units")
            << QByteArray("Position;Forward;Reverse\nmm;ppm;ppm\n0;1;2\n90;2;3\n180;3;4\n") << "unit"
            << "ppm";
        for (const char *word : {"div", "tick", "counts", "V"}) {
            for (const char *known : {"in", "mm", "m", "µm"})
                QTest::newRow(qPrintable(QString("row of units, of the targets %1: %2").arg(known, word)))
                    << "Position;Run 1 +;Run 1 -\n" + QByteArray(known) + ';' + word + ';' + word +
                           "\n0;1;2\n90;2;3\n180;3;4\n"
                    << "unit" << QString(word);
        }
        QTest::newRow("runs down") << QByteArray(
                                          "Position (mm);0;100;200\n↑ 1 (ppm);1.1;3;5\n↓ 1 (ppm);2.1;4;6\n")
                                   << "unit"
                                   << "ppm";
        QTest::newRow("targets across")
            << QByteArray("Position (furlong);0;100;200\n↑ 1 (µm);1.1;3;5\n↓ 1 (µm);2.1;4;6\n")
            << "positionUnit"
            << "furlong";
        QTest::newRow("angles along a length") << tableWith(" (mm)", " (arcsec)") << "unit"
                                               << "″";
        QTest::newRow("seconds of time or of arc") << tableWith(" (deg)", " (sec)") << "unit"
                                                   << "“sec”";
        QTest::newRow("pitch")
            << QByteArray("Position (mm);Pitch (µrad) forward;Pitch (µrad) reverse\n0;1;2\n90;2;3\n")
            << "unit"
            << "µrad";
        QTest::newRow("lengths at angles") << tableWith(" (deg)", " (µm)") << "unit"
                                           << "µm";
        QTest::newRow("line above") << "Unit: ppm\n" + tableWith(" (mm)", "") << "unit"
                                    << "ppm";
        QTest::newRow("circle") << QByteArray("Angle (°);Radial deviation (ppm)\n0;1\n90;2\n180;3\n270;0\n")
                                << "unit"
                                << "ppm";
        QTest::newRow("circle, angles")
            << QByteArray("Angle (mm);Radial deviation (µm)\n0;1\n90;2\n180;3\n270;0\n") << "positionUnit"
            << "mm";
        QTest::newRow("drift") << QByteArray("Time (s);Deviation (mV)\n0;1\n90;2\n180;3\n270;0\n") << "unit"
                               << "mV";
        QTest::newRow("drift, times")
            << QByteArray("Time (days);Deviation (µm)\n0;1\n90;2\n180;3\n270;0\n") << "timeUnit"
            << "days";
        QTest::newRow("indexes")
            << QByteArray("UNIT=FURLONG\nTGT_DATA[1]=0\nTGT_DATA[2]=100\nREF_DATA_FWD[1,1]=0.001\n"
                          "REF_DATA_FWD[2,1]=100.002\n")
            << "unit"
            << "FURLONG";
        QTest::newRow("compensation text")
            << QByteArray(
                   "Compensation spacing 50 mm\nUnits (ppm)\nNo.  Axis position  Combined\n1  0.0  0.0\n"
                   "2  50.0  -2.5\n")
            << "unit"
            << "ppm";
    }
    void namesTheUnitItCannotTake() {
        QFETCH(QByteArray, text);
        QFETCH(QString, key);
        QFETCH(QString, said);
        const Imported imported = showMeasurement(text, "x.csv");
        QVERIFY(!imported.refusal);
        const Question *question = find(imported, key.toStdString());
        QVERIFY(question);
        QCOMPARE(question->proposal, std::string());
        const QString sentence = Language(Language::Id::english).sentence(question->sentence);
        QVERIFY2(sentence.contains(said), qPrintable(sentence));
        QVERIFY(!sentence.contains("nothing in the file"));
        const bool isUnderstood = !text.contains("Pitch"); // which is asked, too
        QVERIFY(!isUnderstood || !find(imported, "columns"));
    }

    /// A unit of the readings that is not known does not hide that of the targets beside it.
    void takesTheUnitBesideIt() {
        for (const auto &[said, unit] : {std::pair("in", "in"), std::pair("m", "m"), std::pair("µm", "um")}) {
            const Imported imported = showMeasurement("Position;Run 1 +;Run 1 -\n" + QByteArray(said) +
                                                          ";div;div\n0;1;2\n90;2;3\n180;3;4\n",
                                                      "x.csv");
            QCOMPARE(choiceOf(imported, "positionUnit"), QString(unit));
            QCOMPARE(choiceOf(imported, "columns"), "target,run+1,run-1");
            QVERIFY(!find(imported, "positionUnit"));
        }
    }

    /// A unit that a workbook only displays, by a number format or in the text of a cell.
    void takesDisplayedUnits_data() {
        QTest::addColumn<QString>("target"); ///< its number format
        QTest::addColumn<QString>("reading");
        QTest::addColumn<QString>("units"); ///< as read
        QTest::newRow("quoted") << "0.000\" in\""
                                << "0.0\" µin\""
                                << "in uin";
        QTest::newRow("unquoted signs") << "0.00°"
                                        << "0.0″"
                                        << "deg arcsec";
        QTest::newRow("escaped") << "0.0\\ \\m\\m;-0.0\\ \\m\\m"
                                 << "#,##0.00\" µm\""
                                 << "mm um";
        QTest::newRow("of any number") << "General\" mm\""
                                       << "[Red]0.0\"nm\""
                                       << "mm nm";
        QTest::newRow("no unit") << "0.0\" pcs\""
                                 << "0.0%"
                                 << "mm um";
    }
    void takesDisplayedUnits() {
        QFETCH(QString, target);
        QFETCH(QString, reading);
        QFETCH(QString, units);
        const std::vector<QStringList> rows{{"Position", "Forward", "Reverse"},
                                            {"0", "1.5", "-2.5"},
                                            {"30.25", "3", "4"},
                                            {"60.5", "0.00004", "6"}};
        const Imported imported =
            showMeasurement(testdata::storedWorkbook(rows, {}, {target, reading, reading}), "x.xlsx");
        QVERIFY(!imported.refusal);
        QCOMPARE(choiceOf(imported, "positionUnit") + ' ' + choiceOf(imported, "unit"), units);
        QCOMPARE(find(imported, "unit") != nullptr, reading == "0.0%");
        const auto &test = std::get<PositioningMeasurement>(imported.test->measurement);
        QCOMPARE(test.targets.at(1), unitOf(choiceOf(imported, "positionUnit").toStdString())->toBase(30.25));
        QCOMPARE(test.runs.at(0).deviations.at(2).value(),
                 unitOf(choiceOf(imported, "unit").toStdString())->toBase(0.00004));
    }

    void takesDisplayedTexts() {
        const Imported inches =
            showMeasurement(testdata::storedOds({{"Position", "Forward (µin)", "Reverse (µin)"},
                                                 {"0|0,000 in", "1.25|1,3", "2|2"},
                                                 {"3.9375|3,938 in", "3|3", "4|4"},
                                                 {"7.875|7,875 in", "5|5", "6|6"}}),
                            "x.ods");
        QCOMPARE(choiceOf(inches, "positionUnit"), "in");
        QVERIFY(!find(inches, "positionUnit"));
        QCOMPARE(std::get<PositioningMeasurement>(inches.test->measurement).targets.at(1), 3.9375 * 25.4);
        const Imported broken =
            showMeasurement(testdata::storedOds({{"Position (mm)", "Forward (µm)", "Reverse (µm)"},
                                                 {"0|0", "1.25|1.3", "2|###"},
                                                 {"100|100", "0|#DIV/0!", "4|4"},
                                                 {"200|200", "5|5", "0|Err:502"}}),
                            "x.ods");
        const auto &test = std::get<PositioningMeasurement>(broken.test->measurement);
        QVERIFY(test.runs.at(0).deviations.at(0) && test.runs.at(1).deviations.at(0));
        QVERIFY(!test.runs.at(0).deviations.at(1) && !test.runs.at(1).deviations.at(2));
        QVERIFY(find(broken, "unread"));
    }

    /// Who knows the unit says it, where it does not move the axis the other way.
    void takesTheUnitThatIsSaid() {
        const QByteArray text = tableWith(" (mm)", " (1/10 µm)");
        const Imported imported = importMeasurement(text, "x.csv", {{"unit", "um"}});
        QVERIFY(!find(imported, "unit") && !find(imported, "columns"));
        const Imported wrong = importMeasurement(tableWith(" (mm)", " (arcsec)"), "x.csv", {{"unit", "um"}});
        QVERIFY(!find(wrong, "unit"));
        const Imported rotary =
            importMeasurement(tableWith(" (mm)", " (arcsec)"), "x.csv", {{"positionUnit", "deg"}});
        QVERIFY(!find(rotary, "unit") && !find(rotary, "positionUnit"));
        QCOMPARE(choiceOf(rotary, "motion"), "rotary");
    }

    /// "All dimensions in inches" does not leave the positions in millimetres; a line of two clauses has two
    /// units.
    void unitsAboveTheTable_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("positionUnit");
        QTest::addColumn<bool>("isAsked");
        QTest::newRow("inches") << QByteArray("All dimensions in inches") << "in"
                                << "in" << true;
        QTest::newRow("microns, inches") << QByteArray("Values in microns, positions in inches") << "um"
                                         << "in" << false;
        QTest::newRow("m, µm") << QByteArray("Positions en m, écarts en µm") << "um"
                               << "m" << false;
        QTest::newRow("mm and µm") << QByteArray("Positions in mm and deviations in µm") << "um"
                                   << "mm" << false;
        QTest::newRow("µm") << QByteArray("All values in µm") << "um"
                            << "mm" << false;
        const auto row = [](const char *lines, const char *unit, const char *positionUnit) {
            QTest::newRow(lines) << QByteArray(lines) << unit << positionUnit << false;
        };
        row("Error units: um\nPosition units: in", "um", "in");
        row("Unité des positions : cm\nUnité des écarts : nm", "nm", "cm");
        row("Unidad posición: pulgadas\nUnidad desviación: micras", "um", "in");
        row("Sollpositionen in Zoll\nAbweichungen in µm", "um", "in");
        row("Unit of deviations;microinch\nUnit of targets;inch", "uin", "in");
        row("Unit: cm\nDeviation unit: nm", "nm", "cm");
        row("Temperature unit: C, Pressure unit: mm", "mm", "mm");
        row("单位：微米", "um", "mm");
        row("Deviations [nm]", "nm", "mm");
        row("Deviation (nm) at position (in)", "nm", "in");
    }
    void unitsAboveTheTable() {
        QFETCH(QByteArray, line);
        QFETCH(QString, unit);
        QFETCH(QString, positionUnit);
        QFETCH(bool, isAsked);
        const Imported imported = showMeasurement(
            line + "\nPosition;Forward;Reverse\n0;0.001;0.002\n90;0.002;0.003\n180;0.003;0.004\n", "x.csv");
        QCOMPARE(choiceOf(imported, "unit"), unit);
        QCOMPARE(choiceOf(imported, "positionUnit"), positionUnit);
        const Question *question = find(imported, "positionUnit");
        QCOMPARE(question && !question->canBeAssumed(), isAsked);
    }

    void refusesAMotionThatTheHeadingsDeny_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("motion");
        QTest::newRow("rotary in mm") << tableWith(" (mm)", " (µm)") << "rotary";
        QTest::newRow("rotary, readings in µm") << tableWith("", " (µm)") << "rotary";
        QTest::newRow("linear in °") << tableWith(" (°)", " (″)") << "linear";
        QTest::newRow("linear, targets in °") << tableWith(" (°)", "") << "linear";
    }
    void refusesAMotionThatTheHeadingsDeny() {
        QFETCH(QByteArray, text);
        QFETCH(QString, motion);
        QVERIFY_EXCEPTION_THROWN((void)importMeasurement(text, "x.csv", {{"motion", motion.toStdString()}}),
                                 Error);
    }

    void takesUnitsItKnows_data() {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("base"); // mm or °
        QTest::addColumn<bool>("isAngle");
        const auto row = [](const char *unit, double base, bool isAngle) {
            QTest::newRow(unit) << QString(unit) << base << isAngle;
        };
        row("cm", 10, false);
        row("m", 1000, false);
        row("mm.", 1, false);
        row("in.", 25.4, false);
        row("Zoll", 25.4, false);
        row("nm", 1e-6, false);
        row("1/1000 mm", 1e-3, false);
        row("gon", 0.9, true);
        row("arcseconds", 1.0 / 3600, true);
        row("Winkelsekunden", 1.0 / 3600, true);
        row("mrad", 180 / M_PI / 1000, true);
        row("mdeg", 0.001, true);
        row("m°", 0.001, true);
        row("millidegrees", 0.001, true);
        for (const char *second : {"arc sec", "Arc Sec", "arc seconds", "arc-seconds", "secondes d'arc"})
            row(second, 1.0 / 3600, true);
        row("\"\"", 1.0 / 3600, true); // as a quoted cell has it
        for (const char *minute : {"arc min", "arc minutes", "minutes d'arc", "'", "’", "′"})
            row(minute, 1.0 / 60, true);
    }
    void takesUnitsItKnows() {
        QFETCH(QString, unit);
        QFETCH(double, base);
        QFETCH(bool, isAngle);
        const QByteArray heading = " (" + unit.toUtf8() + ')';
        const Imported imported = importMeasurement(tableWith(isAngle ? " (°)" : " (mm)", heading), "x.csv");
        QVERIFY(!find(imported, "unit"));
        const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
        QCOMPARE(measurement.axis.motion == Motion::rotary, isAngle);
        QVERIFY(std::abs(*measurement.runs.at(0).deviations.at(2) - 3 * base) <
                1e-12 * base + 1e-15); // last bits
    }

    void leavesOrdinaryWords_data() {
        QTest::addColumn<QString>("word");
        for (const char *word : ordinaryWords)
            QTest::newRow(word) << QString(word);
    }
    void leavesOrdinaryWords() {
        QFETCH(QString, word);
        for (const int form : {0, 1, 2}) {
            const QByteArray brackets = withBrackets(word, form);
            QVERIFY(!saidUnit(("Forward " + brackets).toStdString()).isSaid());
            QCOMPARE(saidUnit(("Forward " + brackets + " (µm)").toStdString()).unit, unitOf("um"));
            QCOMPARE(saidUnit(("Forward (µm) " + brackets).toStdString()).unit, unitOf("um"));
        }
    }
};

QTEST_GUILESS_MAIN(HeadingUnitsTest)
#include "headingunits.moc"
