// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/storedworkbook.h"

#include "document/edits.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"

#include <QTemporaryDir>
#include <QTest>

using namespace palmer;

namespace {

const QByteArray numbers = "0;-1;-2\n100;-3;-4\n200;-2;-5\n";

/// The grade of a question about a choice; null where there is none.
std::optional<QuestionGrade> gradeOf(const Imported &imported, std::string_view id) {
    std::optional<QuestionGrade> grade;
    for (const Question &question : imported.questions) {
        if (question.id == id && grade != QuestionGrade::doubtful)
            grade = question.grade;
    }
    return grade;
}

const PositioningMeasurement &measurementOf(const Imported &imported) {
    return std::get<PositioningMeasurement>(imported.test->measurement);
}

} // namespace

/// What a file says beside its numbers is read or asked for, never passed over: a sign, a unit, a factor, a
/// day, a machine, a column.
class UnreadStatementsTest : public QObject {
    Q_OBJECT

private slots:
    /// Behind the targets of a table with a line for each run.
    void computedColumnsBehindTargetsAreNamed() {
        for (const char *heading : {"Temperatur (°C)", "Mean", "Note"}) {
            const QByteArray text =
                QByteArray("Soll-Pos. mm;0;100;200;") + heading + "\n1 ↑ (µm);1;2;3;20\n1 ↓ (µm);4;5;6;21\n";
            const Imported imported = importMeasurement(text, "x.csv");
            const QString said = testdata::remarks(imported) + testdata::questions(imported);
            QVERIFY2(said.contains(heading), qPrintable(said));
            QVERIFY2(!gradeOf(imported, "positionUnit"), qPrintable(said));
        }
    }

    /// The words of both sides in five languages, joined in every way: read as they stand, or asked for.
    void differencesGiveTheSign() {
        struct Sides {
            const char *target;
            const char *actual;
        };
        constexpr std::array sides{Sides{"Target", "Actual"},    Sides{"Soll", "Ist"},
                                   Sides{"Sollwert", "Istwert"}, Sides{"Nominal", "Measured"},
                                   Sides{"Théorique", "Réel"},   Sides{"Nominale", "Misurato"},
                                   Sides{"Consigna", "Real"},    Sides{"x_cmd", "x_meas"}};
        int read = 0;
        int asked = 0;
        for (const auto &[target, actual] : sides) {
            for (const char *join : {" - ", "-", "/", " − "}) {
                for (const bool isReversed : {true, false}) {
                    const QByteArray words =
                        isReversed ? QByteArray(target) + join + actual : QByteArray(actual) + join + target;
                    const QByteArray text =
                        "Position (mm);" + words + " + (µm);" + words + " - (µm)\n" + numbers;
                    const Imported imported = showMeasurement(text, "x.csv", {});
                    if (!imported.test)
                        continue; // asked for whole
                    if (gradeOf(imported, "sign") == QuestionGrade::doubtful ||
                        gradeOf(imported, "columns") == QuestionGrade::doubtful) {
                        ++asked;
                        continue;
                    }
                    ++read;
                    const auto &first = measurementOf(imported).runs.at(0).deviations.at(0);
                    QVERIFY2(first && (*first > 0) == isReversed,
                             qPrintable(QString::fromUtf8(text) + testdata::picture(imported)));
                }
            }
        }
        qInfo("read %d, asked %d", read, asked);
        QVERIFY(read > 10);
        QVERIFY(asked > 10);
    }

    void asksForWhatItDoesNotUse_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("id");
        const QByteArray plain = "Target (mm);Forward;Reverse\n0;10;20\n100;30;40\n200;20;50\n";
        for (const char *line :
             {"All values in 0.1 µm", "Deviations in tenths of a micron", "Scale factor 0.1",
              "Facteur d'échelle 10", "Valeurs en dixièmes de micron", "deviations in 0.0001 in"})
            QTest::newRow(line) << line + ("\n" + plain) << "unit";
        for (const char *line : {"Signs inverted", "Vorzeichen umgekehrt", "Signe inversé",
                                 "Correction values", "Korrekturwerte Achse X"})
            QTest::newRow(line) << line + ("\n" + plain) << "sign";
        for (const char *lines :
             {"Unit: um\nScale factor: 0.1", "Units: µm\nMultiply all values by 10", "Unit: mm\nUnit: µm",
              "Measurement units: 0.1 micrometer", "Unità scostamento: centesimi di mm", "Spindle unit: nm"})
            QTest::newRow(lines) << lines + ("\n" + plain) << "unit";
        QTest::newRow("factor below") << "Unit: µm\n" + plain + "All values x 0.1\n"
                                      << "unit";
        for (const char *line :
             {"Run 3 backward was aborted", "Down readings are invalid", "Rückfahrt ungültig"})
            QTest::newRow(line) << line + ("\n" + plain) << "statement";
        QTest::newRow("word behind a row")
            << QByteArray(plain).replace("30;40", "30;40;discard") << "statement";
        QTest::newRow("cut within a number")
            << QByteArray("Target (mm);Fwd (µm);Rev (µm)\n0;1,5;2,5\n100;3,5;4,") << "unread";
        QTest::newRow("factor between heading and unit")
            << QByteArray("Target (mm);Fwd x10 (µm);Rev x10 (µm)\n0;10;20\n100;30;40\n200;50;60\n") << "unit";
        QTest::newRow("units differ from line to line")
            << QByteArray("Target;Deviation ↑;Unit\n0;1;µm\n100;3;µm\n200;5;nm\n") << "unit";
        for (const char *cells : {"(4.5);(5.5);(6.5)", "3.5±0.2;2.5±0.2;4.5±0.2", "0x10;0x20;0x30"}) {
            const QList<QByteArray> cell = QByteArray(cells).split(';');
            QTest::newRow(cells) << "Target (mm);Forward (µm);Reverse (µm)\n0;3.5;" + cell[0] + "\n100;2.5;" +
                                        cell[1] + "\n200;1.5;" + cell[2] + '\n'
                                 << "columns";
            QTest::newRow(qPrintable(QString("targets ") + cells))
                << "Target (mm);Forward (µm);Reverse (µm)\n" + cell[0] + ";3.5;4.5\n" + cell[1] +
                       ";2.5;5.5\n" + cell[2] + ";1.5;6.5\n"
                << "columns";
        }
        QTest::newRow("days above columns")
            << QByteArray(";2024-01-01;;2024-06-01;\nTarget (mm);Fwd (µm);Rev (µm);Fwd (µm);Rev "
                          "(µm)\n0;1;2;3;4\n100;3;4;5;6\n200;5;6;7;8\n")
            << "columns";
        const QByteArray block = "\nTarget (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        QTest::newRow("two machines") << "Machine: A" + block + "\nMachine: B" + block << "part";
        QTest::newRow("planes of two circles")
            << QByteArray("Radius: 100 mm\nPlane: XY\nAngle (°);Deviation (µm)\n0;1\n90;2\n180;3\n\n"
                          "Radius: 150 mm\nPlane: ZX\nAngle (°);Deviation (µm)\n0;4\n90;5\n180;6\n")
            << "part";
        QTest::newRow("units of two blocks")
            << QByteArray("Forward\nUnit: µm\nTarget (mm);Run 1\n0;1.5\n100;3.5\n\n"
                          "Backward\nUnit: nm\nTarget (mm);Run 1\n0;500\n100;700\n")
            << "unit";
        const QByteArray numbered = "\nTarget (mm);Run 1 (µm);Run 2 (µm);Run 3 (µm);Run 4 "
                                    "(µm)\n0;9;1;8;2\n100;7;2;9;1\n200;9;3;7;2\n";
        for (const char *line : {"Runs 1,3: backward; runs 2,4: forward", "Odd runs: negative direction",
                                 "First run in the reverse direction"})
            QTest::newRow(line) << line + numbered << "directions";
        for (const char *line : {"Forward = negative direction", "+ = negative direction of the axis"})
            QTest::newRow(line) << line + block << "directions";
        for (const char *cells : {"L;R", "1st;2nd", "3;4"}) {
            const QList<QByteArray> cell = QByteArray(cells).split(';');
            QTest::newRow(qPrintable(QString("directions ") + cells))
                << "Target (mm);Direction;Deviation (µm)\n0;" + cell[0] + ";9\n100;" + cell[0] + ";8\n0;" +
                       cell[1] + ";1\n100;" + cell[1] + ";2\n"
                << (cells[0] == '3' ? "columns" : "directions");
        }
        const QByteArray circle = "\nRadius: 80 mm\nPlane: XY\nAngle (°);Deviation (µm)\n0;1\n90;2\n180;3\n";
        for (const char *line : {"Direction: CW", "Sense: positive angles are clockwise", "CW then CCW"})
            QTest::newRow(line) << line + circle << "sense";
        for (const char *columns :
             {"X (mm);Y (mm);Deviation (µm)\n80;0;5\n0;80;-7\n-80;0;4\n0;-80;9\n",
              "Angle (°);Radius (mm);Deviation (µm)\n0;80.001;3\n90;80.002;6\n180;80.001;3\n270;80;0\n"})
            QTest::newRow(columns) << QByteArray("Radius: 80 mm\nPlane: XY\n") + columns << "columns";
        QTest::newRow("a column behind the targets")
            << QByteArray("Run;0;100;200;Wxyz\n1 ↑ (µm);1;2;3;9\n1 ↓ (µm);4;5;6;8\n") << "columns";
        QTest::newRow("two feeds") << "F1000" + block + "\nF5000" + block << "layout";
        const QByteArray runs =
            "\nTarget (mm);Up 1 (µm);Down 1 (µm);Up 2 (µm);Down 2 (µm)\n0;1;2;3;4\n150;5;6;7;8\n";
        for (const auto &[first, second] :
             {std::pair("Test 1 2026-03-02", "Test 2 2026-03-03"), std::pair("Test 1", "Test 2"),
              std::pair("Essai 1 du 23/02/2026", "Essai 2 du 24/02/2026"), std::pair("Run 1", "Run 2"),
              std::pair("Prova 1", "Prova 2"), std::pair("Run 1 of 12 March", "Run 2 of 13 March")})
            QTest::newRow(first) << first + runs + '\n' + second + runs
                                 << (QByteArray(first).contains("2026") ? "part" : "layout");
        QTest::newRow("runs of two days")
            << "Run 1 02.03.2026" + block + "\nRun 2 03.03.2026" + block << "part";
        QTest::newRow("letters behind directions")
            << QByteArray("Target (mm);Fwd A (µm);Bwd A (µm);Fwd B (µm);Bwd B (µm)\n0;1;2;3;4\n100;3;4;5;6\n")
            << "columns";
        for (const char *title : {"Measurement: Straightness in Y", "Geradheit", "Schleppfehler", "Lacet"})
            QTest::newRow(title) << title + block << "kind";
        for (const char *heading : {"Status", "Valid", "gültig", "Statut"})
            QTest::newRow(heading) << "Target (mm);Direction;Run;Deviation (µm);" + QByteArray(heading) +
                                          "\n0;+;1;1;1\n100;+;1;3;0\n0;-;1;2;1\n100;-;1;4;1\n"
                                   << "columns";
        for (const char *rows : {"0;1;2\n100;3;4\n100;5;6\n300;7;8\n", "0;1;2\n0;3;4\n0;5;6\n100;7;8\n"})
            QTest::newRow(QByteArray(rows).left(20).constData())
                << QByteArray("Target (mm);Fwd (µm);Rev (µm)\n") + rows << "layout";
        QTest::newRow("thousands and a half, or decimals")
            << QByteArray("Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n1.000;3;4\n1.500;5;6\n") << "decimalMark";
        const QByteArray commas = "Target (mm),Fwd,Rev\n0,1.5,2.5\n100,3.5,4.5\n200,5.5,6.5\n";
        QTest::newRow("a unit torn by a comma") << "Einheit der Abweichungen: 0,1 µm\n" + commas << "unit";
        QTest::newRow("thousands or decimals")
            << QByteArray("Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n1.000;3;4\n2.000;5;6\n") << "decimalMark";
    }
    void asksForWhatItDoesNotUse() {
        QFETCH(QByteArray, text);
        QFETCH(QString, id);
        const Imported imported = showMeasurement(text, "x.csv", {});
        const bool isRefused = imported.refusal.has_value();
        QVERIFY2(isRefused || gradeOf(imported, id.toStdString()) == QuestionGrade::doubtful,
                 qPrintable(testdata::picture(imported) + testdata::questions(imported)));
    }

    /// A decimal comma in a line above a table whose columns commas separate shifts nothing.
    void commasOfStatementsPartNothing() {
        const QByteArray table = "Target (mm),Fwd (µm),Rev (µm)\n0,1.5,2.5\n100,3.5,4.5\n200,5.5,6.5\n";
        for (const QByteArray line : {"Air temperature: 20,5\n", "Temperature drift 3,5\n"})
            QCOMPARE(measurementOf(importMeasurement(line + table, "x.csv")).runs,
                     measurementOf(importMeasurement(table, "x.csv")).runs);
    }

    /// Sentences with the word of a direction are listed, every line of them.
    void listsWhatItDoesNotUse() {
        const QByteArray table = "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        const QList<QByteArray> lines{
            "up = towards the gate, which is the far end of the hall seen from here",
            "Stage moved backward between",
            "One",
            "Two",
            "Three",
            "Four",
            "Five"};
        const QString remarks =
            testdata::remarks(importMeasurement(lines.join('\n') + "\n\n" + table, "x.csv"));
        for (const QByteArray &line : lines)
            QVERIFY2(remarks.contains(QString::fromUtf8(line)), qPrintable(remarks));
    }

    /// Degrees Fahrenheit and kelvins are converted; a broken sensor is asked about; each sensor has its
    /// remark.
    void readsTemperaturesInTheirUnit() {
        const auto first = [](const QByteArray &text) {
            const Imported imported = importMeasurement(text, "x.csv");
            return imported.sensors.at(0).series ? imported.sensors.at(0).series->temperatures.at(0)
                                                 : imported.sensors.at(0).start.value_or(-1);
        };
        const QByteArray table = "\nTarget (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        QCOMPARE(first("Air temperature: 77 °F" + table), 25.0);
        QCOMPARE(first("Machine temp (K): 294.15" + table), 21.0);
        QCOMPARE(first("Air temperature: 50 Fahrenheit" + table), 10.0);
        const QByteArray series = "Time (min);Air temp%1;Bed temp%1\n0;%2;%2\n30;%2;%2\n60;%2;%2\n";
        const auto filled = [&](const char *unit, const char *value) {
            return QByteArray(series).replace("%1", unit).replace("%2", value);
        };
        QCOMPARE(first(filled(" (°F)", "50")), 10.0);
        QCOMPARE(first(filled(" (K)", "293.65")), 20.5);
        QCOMPARE(first("Temperature unit: °F\n" + filled("", "50")), 10.0);
        const Imported broken = importMeasurement(filled(" (°C)", "85"), "x.csv");
        QCOMPARE(gradeOf(broken, "temperatures"), QuestionGrade::doubtful);
        const QString remarks = testdata::remarks(broken);
        QVERIFY2(remarks.contains("“Air temp”") && remarks.contains("“Bed temp”"), qPrintable(remarks));
    }

    /// Times in the unit of a line, counted lines, minutes and seconds, and clocks of twelve hours.
    void readsTimesInTheirUnit() {
        const auto last = [](const QByteArray &head, const QList<QByteArray> &times) {
            QByteArray text = head + ";Deviation (µm)\n";
            for (const QByteArray &time : times)
                text += time + ";1.5\n";
            return std::get<DriftMeasurement>(
                       importMeasurement(text, "x.csv", {{"kind", "drift"}}).test->measurement)
                .times.back();
        };
        QCOMPARE(last("Time in minutes\nTime", {"0", "5", "10"}), 600.0);
        QCOMPARE(last("Time unit: min\nTime", {"0", "5", "10"}), 600.0);
        QCOMPARE(last("Time (mm:ss)", {"00:00", "01:30", "02:10"}), 130.0);
        QCOMPARE(last("Sample interval: 10 s\nSample", {"0", "1", "2"}), 20.0);
        QCOMPARE(last("Time", {"11:30:00 AM", "12:30:00 PM", "1:00:00 PM"}), 5400.0);
    }

    /// Lines found above many tables that say nothing of their numbers raise no doubt.
    void doubtsNothingElse() {
        const QByteArray table = "Target (mm);Fwd 1;Rev 1\n0;1.5;2\n100;3;4\n200;5;6\n";
        for (const char *line : {"Resolution 0.1 µm",
                                 "Laser: XL-80",
                                 "Travel 500 mm",
                                 "Measured in hall 3",
                                 "Scale: Heidenhain LS 187",
                                 "Sign-off: QA",
                                 "Signature: J. Doe",
                                 "Dead path 0.1 m",
                                 "Uncertainty 0.5 µm",
                                 "Rate 10 in/min",
                                 "Test 1/10",
                                 "Values after compensation",
                                 "Grid 100 mm",
                                 "Deviations in µm",
                                 "Calibration date: 2023-01-01",
                                 "Warm-up 30 min before test",
                                 "Humidity up to 60 %",
                                 "Forward = positive direction",
                                 "State: after compensation",
                                 "Measured after adjustment, to be compared with before adjustment",
                                 "Unit no: 12 mm spindle",
                                 "Laser head unit: XL-80",
                                 "Number of units: 5",
                                 "Scale factor: 1.000"}) {
            const Imported imported = importMeasurement(line + ("\n" + table), "x.csv");
            QVERIFY2((imported.test->role != TestRole::notStated) ==
                         QByteArray(line).contains("compensation"),
                     line);
            QVERIFY2(std::ranges::all_of(imported.questions, &Question::canBeAssumed),
                     qPrintable(QString(line) + testdata::questions(imported)));
        }
    }

    /// A column with the same word in each line is a statement; what has no field is listed.
    void takesColumnsOfConditions() {
        const QByteArray head =
            "Machine;Serial number;Operator;Date;Feed (mm/min);Hall;Target (mm);Dir;Dev (µm)";
        QByteArray text = head + '\n';
        for (const char *line : {"0;+;1", "100;+;2", "100;-;3", "0;-;4"})
            text += "ABC 40;77;Ann;2026-03-02;900;North;" + QByteArray(line) + '\n';
        const Imported imported = importMeasurement(text, "x.csv");
        QVERIFY2(std::ranges::all_of(imported.questions, &Question::canBeAssumed),
                 qPrintable(testdata::questions(imported)));
        QCOMPARE(imported.machine.name, "ABC 40");
        QCOMPARE(imported.machine.serialNumber, "77");
        QCOMPARE(imported.operatorName, "Ann");
        QCOMPARE(imported.test->date.value(), "2026-03-02");
        QCOMPARE(measurementOf(imported).conditions.feed.value(), 900.0);
        QVERIFY2(testdata::remarks(imported).contains("not read: Hall."),
                 qPrintable(testdata::remarks(imported)));
    }

    /// Thousands that both marks, or an apostrophe, make plain.
    void takesThousands() {
        for (const char *rows : {"0,00;0,4;1,4\n500,50;1,2;2,2\n1.250,75;2,5;3,5\n",
                                 "0.00;0.4;1.4\n500.50;1.2;2.2\n1,250.75;2.5;3.5\n",
                                 "0.00;0.4;1.4\n500.50;1.2;2.2\n1'250.75;2.5;3.5\n"}) {
            const Imported imported =
                importMeasurement(QByteArray("Target (mm);Up 1 (µm);Down 1 (µm)\n") + rows, "x.csv");
            QVERIFY2(std::ranges::all_of(imported.questions, &Question::canBeAssumed),
                     qPrintable(testdata::questions(imported)));
            QCOMPARE(measurementOf(imported).targets.at(2), 1250.75);
        }
        for (const char *rows : {"0,000;0.4;1.4\n500,500;1.2;2.2\n1250,250;2.5;3.5\n",
                                 "0.000;0,4;1,4\n500.500;1,2;2,2\n1250.250;2,5;3,5\n"}) {
            const Imported mixed =
                showMeasurement(QByteArray("Target (mm);Up 1 (µm);Down 1 (µm)\n") + rows, "x.csv");
            QVERIFY(mixed.refusal);
            const QString sentence = Language(Language::Id::english).sentence(mixed.refusal->message);
            QVERIFY2(sentence.contains("decimal mark"), qPrintable(sentence));
        }
    }

    /// A cell that displays another unit than the heading of its column.
    void asksForCellsInAnotherUnit() {
        const auto read = [](const char *cell) {
            return showMeasurement(testdata::storedOds({{"Target (mm)", "Up 1 (µm)", "Down 1 (µm)"},
                                                        {"0|0", "1|1", "2|2"},
                                                        {"100|100", cell, "4|4"},
                                                        {"200|200", "5|5", "6|6"}}),
                                   "x.ods");
        };
        QCOMPARE(gradeOf(read("3|3 nm"), "unread"), QuestionGrade::doubtful);
        QVERIFY(!gradeOf(read("3|3 µm"), "unread"));
    }

    void namesFormulasWithoutValues() {
        const Imported imported =
            showMeasurement(testdata::storedWorkbook(
                                {{"Target (mm)", "Up 1 (µm)"}, {"0", "=B1"}, {"100", "=B2"}, {"200", "=B3"}}),
                            "x.xlsx");
        QVERIFY(imported.refusal);
        const QString sentence = Language(Language::Id::english).sentence(imported.refusal->message);
        QVERIFY2(sentence.contains("formulas"), qPrintable(sentence));
    }

    /// Blocks that are titled as runs, or as measured on one day.
    void takesBlocksOfRuns() {
        const QByteArray block = "\nTarget (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        for (const auto &[first, second] :
             {std::pair("Run 1", "Run 2"), std::pair("Messung 1", "Messung 2"), std::pair("Test 1", "Test 2"),
              std::pair("Run 1 02.03.2026", "Run 2 02.03.2026")}) {
            const Imported imported = importMeasurement(first + block + '\n' + second + block, "x.csv");
            QVERIFY2(std::ranges::all_of(imported.questions, &Question::canBeAssumed),
                     qPrintable(first + testdata::questions(imported)));
            QCOMPARE(measurementOf(imported).runs.size(), std::size_t(4));
        }
    }

    /// Three decimals of micrometres are no thousands.
    void takesThreeDecimals() {
        for (const char delimiter : {',', ';', '\t'}) {
            QByteArray text =
                "Target (mm);Fwd (µm);Rev (µm)\n0;1.234;2.345\n100;3.456;4.567\n200;5.678;6.789\n";
            text.replace(';', delimiter);
            const Imported imported = importMeasurement(text, "x.csv");
            QVERIFY2(std::ranges::all_of(imported.questions, &Question::canBeAssumed),
                     qPrintable(testdata::questions(imported)));
            QCOMPARE(*measurementOf(imported).runs.at(0).deviations.at(0) * 1000, 1.234);
        }
    }

    void readsWhatItUnderstands_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("target"); ///< the second, mm
        QTest::addColumn<double>("first");  ///< deviation, µm
        const QByteArray plain = "\nTarget;Forward;Reverse\n0;10;20\n100;30;40\n200;20;50\n";
        for (const char *line : {"Readings in nm", "Werte in nm", "Écarts en nm", "deviations in nanometres"})
            QTest::newRow(line) << line + plain << 100.0 << 0.01;
        QTest::newRow("positions in inches") << "Positions in inches\nUnit: µm" + plain << 2540.0 << 10.0;
        QTest::newRow("unit in a column")
            << QByteArray("Target;Deviation ↑;Unit\n0;1;nm\n100;3;nm\n200;5;nm\n") << 100.0 << 0.001;
        for (const char *blank : {"\u00A0", "\u202F", " "})
            QTest::newRow(
                qPrintable(QString("thousands parted by U+%1").arg(QString(blank)[0].unicode(), 4, 16)))
                << "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n1" + QByteArray(blank) + "000;3;4\n2" + blank +
                       "000,5;5;6\n"
                << 1000.0 << 1.0;
    }
    void readsWhatItUnderstands() {
        QFETCH(QByteArray, text);
        QFETCH(double, target);
        QFETCH(double, first);
        const Imported imported = importMeasurement(text, "x.csv");
        const PositioningMeasurement &measurement = measurementOf(imported);
        QCOMPARE(measurement.targets.at(1), target);
        QVERIFY(measurement.runs.at(0).deviations.at(0).has_value());
        QCOMPARE(*measurement.runs.at(0).deviations.at(0) * 1000, first);
    }

    /// A statement above a table goes where its label says, and nowhere else.
    void putsStatementsWhereTheyBelong() {
        const QByteArray table = "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        const auto read = [&](const char *lines) {
            return importMeasurement(lines + ("\n" + table), "x.csv");
        };
        QCOMPARE(measurementOf(read("Feed: 5000 mm/min")).conditions.feed, std::optional(5000.0));
        QCOMPARE(read("Laser serial no: 999\nMachine serial no: 123").machine.serialNumber, "123");
        QCOMPARE(read("Machine: Foo\nLaser: XL80\nSerial number: 999").machine.serialNumber, "");
        QCOMPARE(read("Machine: Foo\nSerial number: 123\nLaser: XL80").machine.serialNumber, "123");
        QCOMPARE(read("Seriennummer Laser: L7\nSeriennummer: M12").machine.serialNumber, "M12");
        QCOMPARE(read("Machine: Foo 2, S/N 18, Axis Y").machine.serialNumber, "18");
        QCOMPARE(read("Machine: Foo 2, S/N 18, Axis Y").machine.name, "Foo 2");
        QCOMPARE(measurementOf(read("Feed: 2 m/min")).conditions.feed, std::optional(2000.0));
        const Imported corrected = read("Corrected to 20 °C: yes");
        QCOMPARE(conditionsOf(*corrected.test)->correctionTo20, CorrectionTo20::appliedByInstrument);
        for (const char *label :
             {"Calibration date", "Kalibriert am", "Certificat valide jusqu'au", "Druckdatum"}) {
            QCOMPARE(read(qPrintable(QString(label) + ": 2022-01-01")).test->date, std::nullopt);
            QCOMPARE(read(qPrintable(QString(label) + ": 2022-01-01\nDate: 2024-05-05")).test->date,
                     "2024-05-05");
        }
        QCOMPARE(read("Standard: ISO 230-2:1988").test->edition, "ISO 230-2:1988");
        QCOMPARE(read("nach VDI/DGQ 3441").test->edition, "VDI/DGQ 3441:1977");
        QCOMPARE(read("Circles after ISO 230-4:2005").test->edition, defaultEdition(Kind::positioning).word);
        const auto measured = [&](const char *line) { return read(line).sensors.at(0).measures; };
        QCOMPARE(measured("Room temperature: 22.5"), SensorMeasures::air);
        QCOMPARE(measured("Laser temperature: 22.5"), SensorMeasures::instrument);
        QCOMPARE(measured("Material temperature: 22.5"), SensorMeasures::machine);
        QCOMPARE(measured("Temperature: 22.5"), SensorMeasures::notStated);
        const Imported torn =
            showMeasurement("Axis: Y\nX target (mm);X fwd (µm);X rev (µm)\n0;1;2\n100;3;4\n", "x.csv", {});
        QCOMPARE(gradeOf(torn, "axis"), QuestionGrade::doubtful);
    }

    /// Two files that name two machines never make one: its name from one and its serial number from the
    /// other.
    void keepsMachinesApart() {
        struct Pair {
            const char *first;
            const char *second;
            bool isOther;
        };
        for (const auto &[first, second, isOther] :
             {Pair{"Machine: Foo\n", "Machine: Bar\nSerial number: 2\n", true},
              Pair{"Machine: Foo\nSerial number: 1\n", "Machine: Foo\nSerial number: 2\n", true},
              Pair{"Machine: Foo\nSerial number: 1\n", "Machine: FOO\n", false},
              Pair{"Machine: Foo\nSerial number: 1\n", "Machine: Foo mill\nSerial number: 1\n", false},
              Pair{"", "Machine: Bar\nSerial number: 2\n", false}}) {
            const QByteArray table = "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
            Document document;
            addImported(document, importMeasurement(first + table, "1.csv"), first + table, "1.csv", false);
            const Machine before = document.machine;
            const Imported next = importMeasurement(second + table, "2.csv");
            QCOMPARE(areOtherMachines(before, next.machine), isOther);
            addImported(document, next, second + table, "2.csv", false);
            QCOMPARE(document.machine == before, isOther ||
                                                     next.machine.serialNumber == before.serialNumber ||
                                                     next.machine.serialNumber.empty());
            const bool isNamedDifferently =
                !before.name.empty() &&
                QString::fromStdString(before.name)
                    .compare(QString::fromStdString(next.machine.name), Qt::CaseInsensitive);
            QCOMPARE(document.tests[1]->remarks.empty(), !isOther && !isNamedDifferently);
        }
    }

    /// What a document states once and a second file differently stays with that file's test.
    void keepsWhatTheSecondFileStatesDifferently() {
        const QByteArray bytes = "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        const Imported plain = importMeasurement(bytes, "x.csv");
        const auto remarkOf = [&](auto state) {
            Document document;
            for (const char *name : {"1.csv", "2.csv"}) {
                Imported imported = plain;
                state(imported) = std::string("of ") + name;
                addImported(document, std::move(imported), bytes + name, name, false);
            }
            return document.tests[0]->remarks + '|' + document.tests[1]->remarks;
        };
        const std::string kept = "|2.csv: of 2.csv";
        QCOMPARE(remarkOf([](Imported &one) -> std::string & { return one.operatorName; }), kept);
        QCOMPARE(remarkOf([](Imported &one) -> std::string & { return one.machine.location; }), kept);
        QCOMPARE(remarkOf([](Imported &one) -> std::string & { return one.machine.controller; }), kept);
        QCOMPARE(remarkOf([](Imported &one) -> std::string & { return one.machine.name; }), kept);
    }

    /// A file named twice makes no two tests, also after its conditions were edited.
    void takesAFileOnce() {
        const auto take = [](Document &document, const QByteArray &bytes, const QString &name) {
            addImported(document, importMeasurement(bytes, name), bytes, name, false);
        };
        const QByteArray table = "Operator: Dupont\nTarget (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;\n200;5;6\n";
        for (const QByteArray &bytes :
             {table,
              QByteArray(
                  "angle (deg);radius (mm)\n0;100.001\n90;100.002\n180;100\n270;100.001\n360;100.001\n"),
              QByteArray("Timestamp;Dev (µm)\n2024-01-31T23:50:00;0\n2024-02-01T00:10:00;1\n")}) {
            Document document;
            take(document, bytes, "1.csv");
            editTest(document, 0, [](Test &test) {
                if (Conditions *conditions = conditionsOf(test))
                    conditions->expansion.machine = 11;
            });
            const Document before = document;
            QVERIFY_EXCEPTION_THROWN(take(document, bytes, "2.csv"), Error);
            QVERIFY(document == before);
        }
        Document document;
        take(document, table, "1.csv");
        take(document, QByteArray(table).replace("Dupont", "Martin"), "2.csv");
        QCOMPARE(document.tests.size(), std::size_t(2));
    }

    /// The clock of an oscilloscope is no target; its columns have the file's own names.
    void namesTheColumnsOfAnOscilloscope() {
        QByteArray text = "Name;Circle XY;\n\nName;X fActPosition;Y fActPosition\nData-Type;REAL64;REAL64\n"
                          "SampleTime;10;10\nUnit;mm;mm\nUnit Offset;0;0\n\n";
        for (int i = 0; i < 40; ++i)
            text += QByteArray::number(132900081483250000 + 100000LL * i) + ';' +
                    QByteArray::number(50 * std::cos(i / 6.0), 'f', 6) + ';' +
                    QByteArray::number(50 * std::sin(i / 6.0), 'f', 6) + '\n';
        const Imported shown = showMeasurement(text, "x.csv");
        QVERIFY(std::holds_alternative<CircularMeasurement>(shown.test->measurement));
        QCOMPARE(shown.columns.size(), std::size_t(3));
        QCOMPARE(shown.columns[1].heading, "X fActPosition (mm)");
        QCOMPARE(shown.columns[2].heading, "Y fActPosition (mm)");
    }

    /// A unit in a line of its own that no heading has.
    void asksForAUnitThatNoHeadingHas() {
        const QByteArray table = "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";
        for (const QByteArray line : {"Unit: inch\n", "Unit;nm\n", "Unit;inch\n", "Scale factor 0.1\n",
                                      "All values x 10\n", "Deviations in tenths\n"}) {
            for (const QByteArray &text : {line + table, table + line})
                QVERIFY2(gradeOf(importMeasurement(text, "x.csv"), "unit") == QuestionGrade::doubtful,
                         text.constData());
        }
        for (const QByteArray line :
             {"Unit: mm\n", "Unit: µm\n", "Unit;mm\n", "Coverage factor k = 2\n", "Expansion factor 11.7\n",
              "Table 500 x 1000 mm\n", "Grid: 100x100\n", "Points 5 × 10\n", "Facteur d'élargissement : 2\n",
              "Erweiterungsfaktor k=2\n"})
            QVERIFY2(!gradeOf(importMeasurement(line + table, "x.csv"), "unit"), line.constData());
    }

    /// Which sense of rotation is positive depends on the side it is seen from.
    void asksWhichSenseIsPositive() {
        for (const auto &[up, down] : {std::pair{"CW", "CCW"}, std::pair{"clockwise", "counterclockwise"},
                                       std::pair{"horaire", "antihoraire"}}) {
            const Imported imported = importMeasurement(QByteArray("Target (°);") + up + " (arcsec);" + down +
                                                            " (arcsec)\n0;1;4\n90;3;6\n180;5;7\n",
                                                        "x.csv");
            QCOMPARE(gradeOf(imported, "directions"), std::optional(QuestionGrade::doubtful));
        }
        const Imported imported = importMeasurement(
            QByteArray("Target (°);CW + (arcsec);CCW - (arcsec)\n0;1;4\n90;3;6\n180;5;7\n"), "x.csv");
        QVERIFY(!gradeOf(imported, "directions"));
    }

    /// A comparison takes no measurement whose doubts nobody has answered.
    void comparesNothingDoubtful() {
        const QTemporaryDir folder;
        const auto guessesOf = [&](const QByteArray &unit) {
            QFile file(folder.filePath("x.csv"));
            (void)file.open(QIODevice::WriteOnly);
            file.write("Target (mm);Fwd (" + unit + ");Rev (" + unit + ")\n0;1;2\n100;3;4\n200;5;6\n");
            file.close();
            std::vector<Message> guesses;
            (void)readTests(file.fileName(), guesses);
            return guesses.size();
        };
        (void)guessesOf("µm");
        QVERIFY_EXCEPTION_THROWN(guessesOf("mil"), Error);
    }

    void driftsHaveTheDayOfTheirFirstReading() {
        for (const char *text :
             {"Timestamp;Dev (µm)\n2024-01-31T23:50:00;0\n2024-02-01T00:10:00;1\n2024-02-01T00:30:00;2\n",
              "Date;Time;Dev (µm)\n2024-01-31;23:50;0\n2024-02-01;00:10;1\n2024-02-01;00:30;2\n"}) {
            const Imported imported = importMeasurement(QByteArray(text), "x.csv");
            QCOMPARE(imported.test->date, "2024-01-31");
            QCOMPARE(std::get<DriftMeasurement>(imported.test->measurement).times.back(), 2400.0);
        }
    }

    void knowsShortDirections() {
        const Imported imported = importMeasurement(
            QByteArray(
                "Sollposition [mm];Abweichung vorw. 1 [µm];Abweichung rückw. 1 [µm]\n0;1;2\n100;3;4\n"),
            "x.csv");
        QCOMPARE(measurementOf(imported).runs.at(0).approach, Direction::positive);
        QCOMPARE(measurementOf(imported).runs.at(1).approach, Direction::negative);
        QVERIFY(!gradeOf(imported, "directions") && !gradeOf(imported, "columns"));
    }

    /// Means and standard deviations are no runs, whichever way their direction is written.
    void readsNoStatistics() {
        for (const char *back : {"rev", "bwd", "neg", "retour", "↓"}) {
            const QByteArray up = QByteArray(back) == "↓" ? "↑" : "fwd";
            const QByteArray text = "Target (mm);Mean " + up + " (µm);s " + up + " (µm);Mean " + back +
                                    " (µm);s " + back + " (µm)\n0;1;0.1;2;0.1\n100;3;0.1;4;0.1\n";
            const Imported imported = showMeasurement(text, "x.csv", {});
            QVERIFY2(!imported.test, qPrintable(QString::fromUtf8(text) + testdata::picture(imported)));
        }
    }

    /// A web page and a text of a word processor are called what they are.
    void knowsWebPagesAndRichText() {
        for (const char *page :
             {"<!DOCTYPE html><html><table><tr><td>0</td></tr></table></html>", "<table>"}) {
            try {
                (void)importMeasurement(QByteArray(page), "x.html");
                QFAIL("a web page is read");
            } catch (const Error &error) {
                QVERIFY(Language(Language::Id::english).sentence(error.message).contains("web page"));
            }
        }
        const QByteArray row = R"(\trowd\cellx1000\cellx2000\cellx3000 )";
        const QByteArray rich =
            R"({\rtf1\ansi )" + row + R"(Target (mm)\cell Fwd (um)\cell Rev (um)\cell\row )" + row +
            R"(0\cell 1.5\cell 2.5\cell\row )" + row + R"(100\cell 3.5\cell 4.5\cell\row})";
        QCOMPARE(measurementOf(importMeasurement(rich, "x.rtf")).targets, (std::vector<double>{0, 100}));
    }

    /// Whatever unit the readings of a ballbar state, absolute or not, the deviations are the same.
    void honoursTheUnitOfBallbarReadings() {
        const auto deviationFor = [](const QByteArray &type, double scale, double offset) {
            QByteArray readings;
            for (int i = 0; i < 40; ++i)
                readings +=
                    QByteArray::number((offset + (i % 2 == 0 ? 0.005 : -0.005)) * scale, 'g', 12) + ' ';
            const QByteArray run = "<BALLBAR_RUN><RUN_DIRECTION>CCW</RUN_DIRECTION><READINGS DT=\"" + type +
                                   "\">" + readings + "</READINGS></BALLBAR_RUN>";
            const Imported imported =
                importMeasurement("<TEST_DOCUMENT><NOMINAL_LENGTH DT=\"UT_LENGTH_MM\">150</NOMINAL_LENGTH>" +
                                      run + "</TEST_DOCUMENT>",
                                  "x.b5r");
            return std::get<CircularMeasurement>(imported.test->measurement)
                .arcs.at(0)
                .radialDeviations.at(0);
        };
        for (const double offset : {0.0, 150.0}) {
            QVERIFY(std::abs(deviationFor("UT_LENGTH_MM", 1, offset) - 0.005) < 1e-9);
            QVERIFY(std::abs(deviationFor("UT_LENGTH_UM", 1000, offset) - 0.005) < 1e-9);
            QVERIFY(std::abs(deviationFor("UT_LENGTH_M", 0.001, offset) - 0.005) < 1e-9);
        }
    }

    void halvesDiameters_data() {
        QTest::addColumn<QByteArray>("heading");
        for (const char *heading : {"Diameter", "Durchmesser", "Diamètre", "Diametro"})
            QTest::newRow(heading) << QByteArray(heading);
    }
    void halvesDiameters() {
        QFETCH(QByteArray, heading);
        QByteArray text = "Angle (deg);" + heading + " (mm)\n";
        for (int i = 0; i <= 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(300.006 - 0.012 * (i % 2), 'f', 3) +
                    '\n';
        const Imported imported = importMeasurement(text, "x.csv");
        const auto &circle = std::get<CircularMeasurement>(imported.test->measurement);
        QCOMPARE(circle.nominalRadius, 150.0);
        QVERIFY(std::abs(circle.arcs.at(0).radialDeviations.at(0) - 0.003) < 1e-9);
    }
};

QTEST_GUILESS_MAIN(UnreadStatementsTest)

#include "unreadstatements.moc"
