// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/storedworkbook.h"

#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"

#include <QFile>
#include <QTest>

using namespace palmer;

namespace {

const QByteArray table = "Target (mm);Fwd (µm);Rev (µm)\n0;1;2\n100;3;4\n200;5;6\n";

/// The facts of a file as one text.
QString factsOf(const Imported &imported) {
    const auto number = [](const std::optional<double> &value) {
        return value ? QString::number(*value) : QString("-");
    };
    const Test &test = *imported.test;
    const auto &conditions = std::get<PositioningMeasurement>(test.measurement).conditions;
    QString text = QString::fromStdString(imported.machine.name + '|' + imported.machine.serialNumber + '|' +
                                          imported.operatorName + '|' + test.date.value_or("-") + '|' +
                                          test.time.value_or("-") + '|' + axisOf(test)->name + '|') +
                   number(conditions.airPressure) + '|' + number(conditions.airHumidity) + '|' +
                   number(conditions.feed);
    for (const Sensor &sensor : imported.sensors)
        text += '|' + QString::fromStdString(sensor.position) + ' ' +
                QString::number(static_cast<int>(sensor.measures)) + ' ' + number(sensor.start) + ' ' +
                number(sensor.end);
    return text;
}

QString remarksOf(const Imported &imported) {
    return testdata::remarks(imported) + testdata::questions(imported);
}

struct Fact {
    const char *label;
    const char *value;
};

/// All that a file may state, in each language as its forms have it.
const std::vector<std::vector<Fact>> &sheets() {
    static const std::vector<std::vector<Fact>> all{{{"Machine", "DMU 50"},
                                                     {"Serial number", "4711"},
                                                     {"Operator", "J. Smith"},
                                                     {"Date", "2026-02-13"},
                                                     {"Time", "14:30"},
                                                     {"Axis", "Y"},
                                                     {"Air pressure", "1013 hPa"},
                                                     {"Humidity", "45 %"},
                                                     {"Feed rate", "2000 mm/min"},
                                                     {"Air temperature", "20.5 °C"}},
                                                    {{"Machine name", "DMU 50"},
                                                     {"Machine serial no.", "4711"},
                                                     {"Measured by", "J. Smith"},
                                                     {"Date of test", "13.02.2026"},
                                                     {"Test time", "2:30 pm"},
                                                     {"Axis under test", "Y"},
                                                     {"Atmospheric pressure", "1013 mbar"},
                                                     {"Relative humidity", "45 %"},
                                                     {"Feed", "2000 mm/min"},
                                                     {"Air temp. (°C)", "20.5"}},
                                                    {{"Machine", "DMU 50"},
                                                     {"N° de série", "4711"},
                                                     {"Opérateur", "J. Smith"},
                                                     {"Date d’essai", "13 février 2026"},
                                                     {"Heure", "14:30"},
                                                     {"Axe", "Y"},
                                                     {"Pression atmosphérique", "1013 hPa"},
                                                     {"Humidité relative", "45 %"},
                                                     {"Avance", "2000 mm/min"},
                                                     {"Température de l’air", "20,5 °C"}},
                                                    {{"Maschine", "DMU 50"},
                                                     {"Seriennummer", "4711"},
                                                     {"Prüfer", "J. Smith"},
                                                     {"Messdatum", "13-Feb-2026"},
                                                     {"Uhrzeit", "14:30"},
                                                     {"Achse", "Y"},
                                                     {"Luftdruck", "1013 hPa"},
                                                     {"Luftfeuchte", "45 %"},
                                                     {"Vorschub", "2000 mm/min"},
                                                     {"Lufttemperatur", "20,5 °C"}},
                                                    {{"Maschine / Machine", "DMU 50"},
                                                     {"Seriennummer / Serial no.", "4711"},
                                                     {"Prüfer/Opérateur", "J. Smith"},
                                                     {"Date / Datum", "2026-02-13 14:30"},
                                                     {"Heure / Uhrzeit", "14:30"},
                                                     {"Achse/Axis", "Y"},
                                                     {"Luftdruck / Air pressure", "1013 hPa"},
                                                     {"Luftfeuchte / Humidity", "45 %"},
                                                     {"Vorschub / Feed [mm/min]", "2000"},
                                                     {"Temperatur / Temperature (Luft / air)", "20.5"}}};
    return all;
}

QString withoutPositions(QString facts) {
    const qsizetype at = facts.indexOf('|', facts.lastIndexOf("2000")); // the label of the sensor differs
    const qsizetype end = facts.indexOf(QString::number(static_cast<int>(SensorMeasures::air)) + " 20.5", at);
    return facts.left(at) + "|air " + facts.mid(end + 2);
}

const QString expected = "DMU 50|4711|J. Smith|2026-02-13|14:30|Y|1013|45|2000|air 20.5 -";

} // namespace

/// Statements with labels around a table, in whatever way they are written: each goes where its label says,
/// and nowhere else.
class LabelledFactsTest : public QObject {
    Q_OBJECT

private slots:
    void areReadInEveryForm_data() {
        QTest::addColumn<QByteArray>("text");
        const std::vector<std::pair<const char *, const char *>> within{
            {"", ": "}, {"", " : "}, {"", " = "}, {"# ", ": "}, {"% ", " : "}};
        for (std::size_t language = 0; language < sheets().size(); ++language) {
            const auto &facts = sheets()[language];
            const auto add = [&](const QString &name, const QByteArray &lines) {
                for (const bool isAbove : {true, false}) {
                    QTest::newRow(
                        qPrintable(QString("%1 %2 %3").arg(language).arg(name, isAbove ? "above" : "below")))
                        << (isAbove ? lines + "\n" + table : table + "\n" + lines);
                }
            };
            for (const auto &[before, join] : within) {
                QByteArray lines;
                for (const auto &[label, value] : facts)
                    lines += QByteArray(before) + label + join + value + '\n';
                add(QString(before) + join, lines);
            }
            QByteArray cells;
            QByteArray marked;
            QByteArray quoted;
            for (const auto &[label, value] : facts) {
                cells += QByteArray(label) + ';' + value + ";;\n";
                marked += QByteArray(label) + ":;" + value + '\n';
                quoted += '"' + QByteArray(label) + "\";\"" + value + "\"\n";
            }
            add("cells", cells);
            add("cells with a colon", marked);
            add("quoted", quoted);
            for (const char *between : {"   ", "; ", " | ", "\t"}) {
                QByteArray line;
                for (std::size_t i = 0; i < facts.size(); ++i)
                    line += QByteArray(i == 0       ? ""
                                       : i % 3 == 0 ? "\n"
                                                    : between) +
                            facts[i].label + ": " + facts[i].value;
                add(QString("joined by '%1'").arg(between), line + '\n');
            }
            QByteArray labels;
            QByteArray values;
            for (const auto &[label, value] : facts) {
                labels += QByteArray(label) + ';';
                values += QByteArray(value) + ';';
            }
            QTest::newRow(qPrintable(QString("%1 labels across").arg(language)))
                << labels + '\n' + values + "\n\n" + table;
        }
    }
    void areReadInEveryForm() {
        QFETCH(QByteArray, text);
        const Imported imported = showMeasurement(text, "x.csv", {});
        QVERIFY2(imported.test, qPrintable(QString::fromUtf8(text) + remarksOf(imported)));
        QCOMPARE(withoutPositions(factsOf(imported)), expected);
        QVERIFY2(!remarksOf(imported).contains("not used"), qPrintable(remarksOf(imported)));
        QVERIFY2(remarksOf(imported).contains("Statements that were read: 10"),
                 qPrintable(remarksOf(imported)));
        QCOMPARE(readingsOf(*imported.test), std::size_t(6));
    }

    /// A label with another word names something else: the line is listed, and no field has it.
    void areReadInOtherLanguages_data() {
        QTest::addColumn<QByteArray>("lines");
        const auto row = [](const char *name, const char *lines) {
            QTest::newRow(name) << QByteArray(lines);
        };
        row("Dutch", "Machine: DMU 50\nSerienummer: 4711\nGemeten door: J. Smith\nDatum: 2026-02-13\nAs: Y\n"
                     "Luchttemperatuur: 20,5 °C\n");
        row("Portuguese", "Máquina: DMU 50\nNúmero de série: 4711\nOperador: J. Smith\nData: 2026-02-13\n"
                          "Eixo: Y\nTemperatura do ar: 20,5 °C\n");
        row("Czech", "Stroj: DMU 50\nVýrobní číslo: 4711\nOperátor: J. Smith\nDatum: 2026-02-13\nOsa: Y\n"
                     "Teplota vzduchu: 20,5 °C\n");
        row("Polish", "Maszyna: DMU 50\nNumer seryjny: 4711\nOperator: J. Smith\nData: 2026-02-13\nOś: Y\n"
                      "Temperatura powietrza: 20,5 °C\n");
        row("Russian", "Станок: DMU 50\nЗаводской номер: 4711\nОператор: J. Smith\nДата: 2026-02-13\n"
                       "Ось: Y\nТемпература воздуха: 20,5 °C\n");
        row("Chinese", "机床: DMU 50\n序列号: 4711\n操作员: J. Smith\n日期: 2026-02-13\n轴: Y\n"
                       "空气温度: 20.5 °C\n");
        row("Japanese", "機械: DMU 50\n製造番号: 4711\n測定者: J. Smith\n測定日: 2026-02-13\n軸: Y\n"
                        "気温: 20.5 °C\n");
    }
    void areReadInOtherLanguages() {
        QFETCH(QByteArray, lines);
        const Imported imported = importMeasurement(lines + table, "x.csv");
        QVERIFY2(factsOf(imported).startsWith("DMU 50|4711|J. Smith|2026-02-13|-|Y|-|-|-|"),
                 qPrintable(factsOf(imported)));
        QCOMPARE(imported.sensors.size(), 1U);
        QCOMPARE(imported.sensors.front().measures, SensorMeasures::air);
        QCOMPARE(imported.sensors.front().start.value_or(0), 20.5);
    }

    void othersAreLeft_data() {
        QTest::addColumn<QByteArray>("line");
        for (const char *line : {"Calibrated by: PTB",
                                 "Approved by: Boss",
                                 "Exported by: CARTO 4.2",
                                 "Année machine : 2019",
                                 "Heures machine : 12000",
                                 "Customer machine: 77",
                                 "Machine type: VF2",
                                 "Controller S/N: 555",
                                 "Encoder serial no: 9",
                                 "Probe holder serial: 55",
                                 "Serial port: COM3",
                                 "Date of report: 2026-03-01",
                                 "Exported: 2026-03-01",
                                 "Purchased 2019-01-01",
                                 "Software 2026-01-02",
                                 "Last maintenance: 2025-12-01",
                                 "Calibration due: 2027-01-01",
                                 "Reference temperature: 20",
                                 "Température de référence : 20 °C",
                                 "Bezugstemperatur: 20 °C",
                                 "Temps de pause : 5",
                                 "Tempo di sosta: 3",
                                 "Temperature sensor: 2",
                                 "Temperature correction: 0",
                                 "Temperature gradient: 0.2",
                                 "Temperature limit: 20",
                                 "Temp coefficient: 11.7",
                                 "Machine temperature rise: 0.4 °C",
                                 "Temperature homogeneity: 0.3 °C",
                                 "Écart de température : 0,5 °C",
                                 "Temp. spread: 0.4 °C",
                                 "Temperature before warm-up: 18.0",
                                 "Air temperature: 85 °C",
                                 "Template: 12",
                                 "Attempt: 3",
                                 "Temporary mark: 20",
                                 "Spindle pressure: 60 bar",
                                 "Other axes: Y 100",
                                 "replaces ISO 230-2:1997, evaluated per ISO 230-2:2006"})
            QTest::newRow(line) << QByteArray(line);
    }
    void othersAreLeft() {
        QFETCH(QByteArray, line);
        for (const QByteArray &text :
             {line + '\n' + table, "# " + line + '\n' + table, table + '\n' + line + '\n'}) {
            const Imported imported = showMeasurement(text, "x.csv", {});
            QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
            QCOMPARE(factsOf(imported), QString("|||-|-||-|-|-"));
            QCOMPARE(imported.test->edition, std::string(defaultEdition(Kind::positioning).word));
            QVERIFY2(remarksOf(imported).contains("not used"), qPrintable(remarksOf(imported)));
        }
    }

    /// Whole values: what commas, quotes and brackets hold; a placeholder is none; the second value is
    /// listed.
    void valuesAreWhole() {
        const auto read = [](const QByteArray &lines, QByteArray below = table) {
            return showMeasurement(lines + '\n' + below, "x.csv", {});
        };
        const QByteArray commas = QByteArray(table).replace(';', ',');
        QCOMPARE(read("Machine: Mori NH4000, spindle 2").machine.name, "Mori NH4000, spindle 2");
        QCOMPARE(read("Machine: Mori NH4000, spindle 2", commas).machine.name, "Mori NH4000, spindle 2");
        QCOMPARE(read("\"Operator\",\"Dupont, Jean\"", commas).operatorName, "Dupont, Jean");
        QCOMPARE(read("\"Machine\",\"DMU \"\"50\"\", evo\"", commas).machine.name, "DMU \"50\", evo");
        QCOMPARE(read("Machine;DMU 50|evo").machine.name, "DMU 50|evo");
        QCOMPARE(read("Machine: DMU 50;Serial: 123").machine.name, "DMU 50");
        QCOMPARE(read("Machine: DMU 50;Serial: 123").machine.serialNumber, "123");
        for (const char *none : {"n/a", "-", "---", "–", "unknown"}) {
            QCOMPARE(read(QByteArray("Machine: ") + none).machine.name, "");
            QCOMPARE(read(QByteArray("Operator;") + none).operatorName, "");
            QVERIFY(!remarksOf(read(QByteArray("Operator;") + none)).contains("Operator"));
        }
        const Imported two = read("Machine: A\nMachine: B");
        QCOMPARE(two.machine.name, "A");
        QVERIFY(remarksOf(two).contains("Machine: B"));
        const Imported both = read("Temperature start: 20.1; Temperature end: 20.9");
        QCOMPARE(both.sensors.size(), std::size_t(1));
        QCOMPARE(both.sensors[0].start, 20.1);
        QCOMPARE(both.sensors[0].end, 20.9);
        QVERIFY(remarksOf(read("Air temperature;20,1;20,3")).contains("20,3"));
        QCOMPARE(read("Date of report: 2026-03-01\nDate of test: 2026-02-13").test->date, "2026-02-13");
        QCOMPARE(factsOf(read("Rotary axis: A\nAxis: X")).section('|', 5, 5), "X");
    }

    /// Statements stand to the right or left of a table as well; the table is read as without them.
    void standBesideTheTable_data() {
        QTest::addColumn<QByteArray>("text");
        const std::vector<QByteArray> facts{"Machine;DMU 50", "Location;Hall 3", "Serial number:;4711",
                                            "Operator;J. Smith", "Date of test;2026-02-13"};
        const std::vector<QByteArray> lines{"Target (mm);Fwd (µm);Rev (µm)", "0;1;2", "100;3;4", "200;5;6"};
        const auto joined = [&](bool isRight, const QByteArray &gap) {
            QByteArray text;
            for (std::size_t i = 0; i < facts.size(); ++i) {
                const QByteArray line = i < lines.size() ? lines[i] : QByteArray(";;");
                text += isRight ? line + ";" + gap + facts[i] : facts[i] + ";" + gap + line;
                text += '\n';
            }
            return text;
        };
        QTest::newRow("right, apart") << joined(true, ";");
        QTest::newRow("right") << joined(true, "");
        QTest::newRow("left, apart") << joined(false, ";");
        QTest::newRow("right, titled") << QByteArray(table)
                                                  .replace("Rev (µm)", "Rev (µm);;Conditions")
                                                  .replace("0;1;2", "0;1;2;;Machine;DMU 50")
                                                  .replace("100;3;4", "100;3;4;;Serial number;4711")
                                                  .replace("200;5;6", "200;5;6;;Operator;J. Smith") +
                                              ";;;;Date of test;2026-02-13\n;;;;Location;Hall 3\n";
    }
    void standBesideTheTable() {
        QFETCH(QByteArray, text);
        const Imported imported = showMeasurement(text, "x.csv", {});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        QCOMPARE(factsOf(imported), QString("DMU 50|4711|J. Smith|2026-02-13|-||-|-|-"));
        QVERIFY2(remarksOf(imported).contains("Hall 3"), qPrintable(remarksOf(imported)));
        QVERIFY2(!remarksOf(imported).contains("Columns"), qPrintable(remarksOf(imported)));
        QCOMPARE(testdata::picture(imported).section('\n', 0, 2),
                 testdata::picture(showMeasurement(table, "x.csv", {})));
    }

    /// Columns of a table are no statements beside it.
    void columnsStayColumns_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<std::size_t>("readings");
        QTest::newRow("operators") << QByteArray(
                                          "Target (mm);↑ (µm);;Operator;Machine\n0;1;;A;M\n100;2;;A;M\n")
                                   << std::size_t(2);
        QTest::newRow("another table")
            << QByteArray("Target (mm);↑ (µm);;Machine;↓ (µm)\n0;1;;0;5\n100;2;;100;6\n") << std::size_t(4);
        QTest::newRow("pairs below") << QByteArray(
                                            "i;Target (mm);↑ (µm)\n1;0;1\n2;100;2\n3;200;3\n\n"
                                            "Machine:;M;Travel:;1300 mm\nDwell:;3 s;Coefficient:;11 µm/m/K\n"
                                            "Operator:;A;Dead path:;82 mm\n")
                                     << std::size_t(3);
    }
    void columnsStayColumns() {
        QFETCH(QByteArray, text);
        QFETCH(std::size_t, readings);
        const Imported imported = showMeasurement(text, "x.csv", {});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        QCOMPARE(readingsOf(*imported.test), readings);
    }

    /// In cells in pairs the first is a label, known or not: its date is not that of the test.
    void pairsKeepTheirLabels() {
        const Imported imported = showMeasurement("Model;K2;;Controller;840D\nCalibrated;23.01.2020;;Place;"
                                                  "Hall 3\nCalibrated;23.01.2020;Machine;M\n"
                                                  "Machine under test;M;;Dead path;82 mm\n\n" +
                                                      table,
                                                  "x.csv", {});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        QCOMPARE(factsOf(imported), QString("M|||-|-||-|-|-"));
        QVERIFY2(remarksOf(imported).contains("Calibrated 23.01.2020"), qPrintable(remarksOf(imported)));
    }

    /// "Calibrated    23.01.2020" above columns of fixed width is quoted once, and only there.
    void wideLinesAreNotReadTwice() {
        const Imported imported = showMeasurement("Calibrated                    12.07.2021\n"
                                                  "Certificate                   A 1\n\n"
                                                  "                  Error [µm]\n"
                                                  "                      up       down\n"
                                                  "   Target (mm)     Run 1      Run 1\n"
                                                  "         0.000       2.7       -0.4\n"
                                                  "        41.860       3.6        1.2\n"
                                                  "       100.000       3.8        2.0\n",
                                                  "x.txt", {});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        QCOMPARE(imported.test->date, std::nullopt);
        QCOMPARE(remarksOf(imported).count("12.07.2021"), 1);
    }

    /// Tables of other headings are of the axis and day that stand above them.
    void belongToTheirTable() {
        const QByteArray text = "Machine: M\n\nAxis X\nDate: 2026-03-04\nAir temperature: 20.5 °C\n"
                                "Target (mm);Run 1 ↑ (µm);Run 1 ↓ (µm)\n0;1;2\n100;2;3\n200;3;4\n\n"
                                "Axis Y\nDate: 2026-03-05\nAir temperature: 22.5 °C\n"
                                "Target (mm);Error ↑ (µm);Error ↓ (µm)\n0;5;6\n50;6;7\n100;7;8\n150;8;9\n";
        const auto read = [&](const ImportOptions &options) {
            const Imported imported = importMeasurement(text, "x.csv", options);
            return factsOf(imported).section('|', 3, 5) + factsOf(imported).section('|', 9) + ' ' +
                   QString::number(readingsOf(*imported.test));
        };
        const QString ofX = "2026-03-04|-|XAir temperature 2 20.5 - 6";
        const QString ofY = "2026-03-05|-|YAir temperature 2 22.5 - 8";
        QCOMPARE(read({}), ofY);
        QCOMPARE(read({{"table", "1"}}), ofX);
        QCOMPARE(read({{"table", "2"}}), ofY);
        QCOMPARE(read({{"axis", "X"}}), ofX);
        QCOMPARE(read({{"axis", "Y"}}), ofY);
        QCOMPARE(read({{"axis", "X"}, {"table", "1"}}), ofX);
        QVERIFY(importMeasurement(text, "x.csv", {{"axis", "X"}}).questions.size() == 1); // of 20 °C
        QVERIFY_THROWS_EXCEPTION(Error, read({{"axis", "X"}, {"table", "2"}}));
    }

    void otherFormsAreRead_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("facts");
        const auto row = [](const char *line, const char *facts) {
            QTest::newRow(line) << QByteArray(line) << QString(facts);
        };
        row("Pressure: 101.3 kPa", "|||-|-||1013|-|-");
        row("Luftdruck: 750 mmHg", "|||-|-||999.9|-|-");
        row("Air pressure: 600 kPa", "|||-|-||-|-|-"); // of a supply
        row("Pression d’air: 965 mbar", "|||-|-||965|-|-");
        row("Rel. humidity: 45 %", "|||-|-||-|45|-");
        row("Feed: 1 000 mm/min", "|||-|-||-|-|1000");
        row("Feed rate: F1000 mm/min", "|||-|-||-|-|1000");
        row("Traverse speed: 1 m/min", "|||-|-||-|-|1000");
        row("Feed: 1,000 mm/min", "|||-|-||-|-|-"); // one, or a thousand
        row("Beginn: 14:06", "|||-|14:06||-|-|-");
        row("Heure : 10h25", "|||-|10:25||-|-|-");
        row("Time: 1 h 30 min", "|||-|-||-|-|-"); // a duration
        row("Uhrzeit: 16.53 Uhr", "|||-|16:53||-|-|-");
        row("Datum: 23. 10. 2025", "|||2025-10-23|-||-|-|-");
        row("Date: 20251023", "|||2025-10-23|-||-|-|-");
        row("Date: 20122012", "|||-|-||-|-|-");
        row("Date: 4th of March 2023", "|||2023-03-04|-||-|-|-");
        row("Asse misurato: Y", "|||-|-|Y|-|-|-");
        row("Macchina in prova: M", "M|||-|-||-|-|-");
        row("**Machine:** M", "M|||-|-||-|-|-");
        row("Environment temp: 20.5 ℃", "|||-|-||-|-|-|Environment temp 2 20.5 -");
    }
    void otherFormsAreRead() {
        QFETCH(QByteArray, line);
        QFETCH(QString, facts);
        const Imported imported = showMeasurement(line + "\n\n" + table, "x.csv", {});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        QCOMPARE(factsOf(imported), facts);
    }

    /// What a file says above the table of one axis is not said of the other.
    void belongToTheirBlock() {
        const QByteArray one = "Operator: A\nDate: 2026-02-13\nTemperature: 20.1\nAxis: X\n" + table;
        const QByteArray other = "\nOperator: B\nDate: 2026-02-14\nTemperature: 25\nAxis: Y\n" + table;
        const auto read = [&](const char *axis) {
            return factsOf(showMeasurement("Machine: M\n" + one + other, "x.csv", {{"axis", axis}}));
        };
        QCOMPARE(read("X"), "M||A|2026-02-13|-|X|-|-|-|Temperature 3 20.1 -");
        QCOMPARE(read("Y"), "M||B|2026-02-14|-|Y|-|-|-|Temperature 3 25 -");
    }

    void daysAreRead_data() {
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<QString>("date");
        QTest::addColumn<QString>("time");
        for (const char *day : {"2026-02-13", "2026/02/13", "13.02.2026", "13/02/2026", "13 Feb 2026",
                                "13-Feb-2026", "Feb 13, 2026", "February 13 2026", "13th February 2026",
                                "13. Februar 2026", "13 de febrero de 2026", "13 févr. 2026"}) {
            QTest::newRow(day) << QByteArray(day) << "2026-02-13"
                               << "";
            QTest::newRow(qPrintable(QString(day) + " 09:05")) << QByteArray(day) + " 09:05"
                                                               << "2026-02-13"
                                                               << "09:05";
            QTest::newRow(qPrintable(QString(day) + " 9:05:30 PM")) << QByteArray(day) + " 9:05:30 PM"
                                                                    << "2026-02-13"
                                                                    << "21:05";
        }
        QTest::newRow("of a program") << QByteArray("Fri Feb 13 09:05:25 CET 2026") << "2026-02-13"
                                      << "09:05";
        for (const char *day : {"2026-02-30", "32/13/2026", "03/04/2026", "3/4/26"})
            QTest::newRow(day) << QByteArray(day) << ""
                               << "";
    }
    void daysAreRead() {
        QFETCH(QByteArray, value);
        QFETCH(QString, date);
        QFETCH(QString, time);
        const Imported imported = showMeasurement("Date: " + value + '\n' + table, "x.csv", {});
        QCOMPARE(QString::fromStdString(imported.test->date.value_or("")), date);
        QCOMPARE(QString::fromStdString(imported.test->time.value_or("")), time);
        if (!date.isEmpty())
            return;
        QCOMPARE(imported.test->remarks, value.toStdString());
        const bool isEither = value.startsWith("03") || value.startsWith("3/");
        QVERIFY(remarksOf(imported).contains(isEither ? "in several ways" : "not one that"));
    }

    /// Two statements of an instrument's file that do not agree: the second is listed, or asked for.
    void contradictionsOfInstrumentsAreSaid() {
        const auto changed = [](const char *name, const QByteArray &from, const QByteArray &to) {
            QFile file(DATA + QString(name));
            const bool isOpen = file.open(QIODevice::ReadOnly);
            QByteArray bytes = file.readAll();
            return isOpen && bytes.contains(from) ? bytes.replace(from, to) : QByteArray();
        };
        const QByteArray machines =
            changed("rtl/typical.rtl", "USER-TEXT::", "USER-TEXT::\r\nMachine : Mill 0\r\n");
        const Imported two = showMeasurement(machines, "x.rtl", {});
        QCOMPARE(two.machine.name, "Mill 0");
        QVERIFY2(remarksOf(two).contains("Machine: "), qPrintable(remarksOf(two)));
        QVERIFY2(!remarksOf(two).contains("Statements that were read"), qPrintable(remarksOf(two)));
        const QByteArray flags = changed("rtl/typical.rtl", "Flags: 0 0", "Flags: 0 1");
        QVERIFY(remarksOf(showMeasurement(flags, "x.rtl", {})).contains("rows are followed"));
        const QByteArray plane =
            changed("b5r/typical-absolute.b5r", "TEST_PLANE=\"XY\"", "TEST_PLANE=\"YZ\"");
        QVERIFY(remarksOf(showMeasurement(plane, "x.b5r", {})).contains("names YZ and the axes XY"));
    }

    /// Every edition for this kind of test, however its year is parted from it.
    void editionsAreRead() {
        int read = 0;
        for (const Edition *edition : editions()) {
            if (edition->kind != Kind::positioning)
                continue;
            const QString word = QString::fromUtf8(edition->word);
            for (const QString &line : {word, "Standard: " + word,
                                        word.chopped(5) + " (" + word.right(4) + ")", "Test after " + word}) {
                const Imported imported = showMeasurement(line.toUtf8() + '\n' + table, "x.csv", {});
                QCOMPARE(imported.test->edition, edition->word);
                ++read;
            }
        }
        QVERIFY(read >= 24);
    }

    /// A workbook's sheet without a table states the same.
    void coversAreRead() {
        for (const auto &facts : sheets()) {
            std::vector<QStringList> rows;
            for (const auto &[label, value] : facts)
                rows.push_back({label, value});
            rows.push_back({});
            rows.push_back({"Target (mm)", "Fwd (µm)", "Rev (µm)"});
            rows.push_back({"0", "1", "2"});
            rows.push_back({"100", "3", "4"});
            rows.push_back({"200", "5", "6"});
            const Imported imported = showMeasurement(testdata::storedWorkbook(rows), "x.xlsx", {});
            QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
            QCOMPARE(withoutPositions(factsOf(imported)), expected);
        }
    }

    /// A sheet of its own says the same of the numbers as lines above them; what is not used is listed.
    void coversRuleTheTable() {
        const QByteArray bytes = testdata::storedOds({{"Target", "Fwd", "Rev"},
                                                      {"0|0", "1|1", "2|2"},
                                                      {"100|100", "3|3", "4|4"},
                                                      {"200|200", "5|5", "6|6"}},
                                                     {{"Unit of deviations", "nm"},
                                                      {"Sign", "target - actual"},
                                                      {"Axis", "Y"},
                                                      {"Edition", "ISO 230-2:2006"},
                                                      {"Hall 3 was empty"}});
        const Imported imported = showMeasurement(bytes, "x.ods", {});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
        QCOMPARE(measurement.runs.at(0).deviations.at(0), std::optional(-1e-6));
        QCOMPARE(measurement.axis.name, "Y");
        QCOMPARE(imported.test->edition, "ISO 230-2:2006");
        QVERIFY2(remarksOf(imported).contains("Cover 5: Hall 3 was empty"), qPrintable(remarksOf(imported)));
    }

    /// They also hold for the one of several tests that is read.
    void coversHoldForEachTest() {
        const auto rowsOf = [](const char *machine, const char *first) {
            return std::vector<QStringList>{{"Machine:", machine},
                                            {"Target (mm)", "Fwd (µm)", "Rev (µm)"},
                                            {"0|0", QString("%1|%1").arg(first), "2|2"},
                                            {"100|100", "3|3", "4|4"},
                                            {"200|200", "5|5", "6|6"},
                                            {}};
        };
        std::vector<QStringList> rows = rowsOf("Mill 1", "1");
        std::ranges::copy(rowsOf("Mill 2", "7"), std::back_inserter(rows));
        const QByteArray bytes =
            testdata::storedOds(rows, {{"Sign", "target - actual"}, {"Edition", "ISO 230-2:2006"}});
        const Imported imported = showMeasurement(bytes, "x.ods", {{"part", "Mill 2"}});
        QVERIFY2(imported.test, qPrintable(remarksOf(imported)));
        const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
        QCOMPARE(measurement.runs.at(0).deviations.at(0), std::optional(-0.007));
        QCOMPARE(imported.test->edition, "ISO 230-2:2006");
        QCOMPARE(imported.machine.name, "Mill 2");
    }
};

QTEST_GUILESS_MAIN(LabelledFactsTest)

#include "labelledfacts.moc"
