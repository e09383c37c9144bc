// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "document/edits.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <QCryptographicHash>
#include <QDirIterator>
#include <QFile>
#include <QStringEncoder>
#include <QTest>

using namespace palmer;

namespace {

QByteArray contents(const QString &path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(path));
    return file.readAll();
}

QStringList filesIn(const QString &folder) {
    QStringList files;
    QDirIterator found(DATA + folder, QDir::Files, QDirIterator::Subdirectories);
    while (found.hasNext()) {
        const QString file = found.next();
        if (!file.endsWith(".expected") && !file.endsWith(".md"))
            files << file.mid(QString(DATA).size());
    }
    files.sort();
    return files;
}

/// Measurement, remarks and choices, or the error, as the .expected file beside it says.
QString outcome(const QByteArray &bytes, const QString &name) {
    try {
        const Imported imported = importMeasurement(bytes, name);
        return testdata::picture(imported) + "\n\n" + testdata::questions(imported) + "\n\n" +
               testdata::remarks(imported) + "\n\n" + testdata::choices(imported) + "\n";
    } catch (const Error &error) {
        return "refused " + QString::fromStdString(error.place) + ": " +
               Language(Language::Id::english).sentence(error.message) + "\n";
    }
}

} // namespace

/// Files written from the descriptions of the formats (tests/data/import/ORIGIN.md), and what they say.
class ImportedFilesTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatIsExpected_data();
    void saysWhatIsExpected();
    void lineEndsChangeNothing_data();
    void lineEndsChangeNothing();
    void utf16ChangesNoNumber_data();
    void utf16ChangesNoNumber();
    void everyTruncationIsAnErrorOrAMeasurement_data();
    void everyTruncationIsAnErrorOrAMeasurement();
    void takesChoices_data();
    void takesChoices();
    void refusesUnknownChoices();
    void refusesHugeFilesAtOnce();
    void keepsTheOriginal();
    void putsTemperaturesIntoTheTests();
    void takesTheGradientOfTheAir_data();
    void takesTheGradientOfTheAir();
    void coloursTheCells();
    void readsWhatStandsBesideTheTable();
    void showsWhatCannotBeRead();
};

void ImportedFilesTest::saysWhatIsExpected_data() {
    QTest::addColumn<QString>("file");
    for (const QString &file : filesIn(""))
        QTest::newRow(qPrintable(file)) << file;
}

void ImportedFilesTest::saysWhatIsExpected() {
    QFETCH(QString, file);
    const QStringList actual = outcome(contents(DATA + file), file).split('\n');
    const QStringList expected = QString::fromUtf8(contents(DATA + file + ".expected")).split('\n');
    for (qsizetype i = 0; i < std::min(actual.size(), expected.size()); ++i)
        QCOMPARE(actual[i], expected[i]);
    QCOMPARE(actual.size(), expected.size());
}

void ImportedFilesTest::lineEndsChangeNothing_data() {
    QTest::addColumn<QString>("file");
    for (const QString folder : {"tables", "rtl", "indexed", "ren", "pos"}) {
        for (const QString &file : filesIn(folder)) {
            if (!file.contains("utf-16"))
                QTest::newRow(qPrintable(file)) << file;
        }
    }
}

void ImportedFilesTest::lineEndsChangeNothing() {
    QFETCH(QString, file);
    const QByteArray unixFile = contents(DATA + file).replace("\r\n", "\n").replace('\r', '\n');
    const QString expected = outcome(unixFile, file);
    QCOMPARE(outcome(QByteArray(unixFile).replace('\n', "\r\n"), file), expected);
    QCOMPARE(outcome(QByteArray(unixFile).replace('\n', '\r'), file), expected);
}

void ImportedFilesTest::utf16ChangesNoNumber_data() {
    QTest::addColumn<QString>("file");
    for (const QString folder : {"rtl", "indexed", "ren", "pos"}) {
        for (const QString &file : filesIn(folder)) {
            if (!file.contains("1252") && !file.contains("gbk"))
                QTest::newRow(qPrintable(file)) << file;
        }
    }
}

void ImportedFilesTest::utf16ChangesNoNumber() {
    QFETCH(QString, file);
    const QByteArray bytes = contents(DATA + file);
    QStringEncoder encode(QStringConverter::Utf16LE, QStringConverter::Flag::WriteBom);
    const QByteArray wide = encode(QString::fromUtf8(bytes));
    const QString expected = testdata::picture(importMeasurement(bytes, file));
    QVERIFY(!expected.isEmpty());
    QCOMPARE(testdata::picture(importMeasurement(wide, file)), expected);
}

void ImportedFilesTest::everyTruncationIsAnErrorOrAMeasurement_data() {
    QTest::addColumn<QString>("file");
    for (const QString file :
         {"tables/typical.csv", "tables/list.csv", "tables/group-headings.csv", "tables/temperatures.csv",
          "tables/circle-both-senses.csv", "rtl/typical.rtl", "b5r/typical-absolute.b5r", "rtx/typical.rtx",
          "indexed/typical.txt", "ren/typical.ren", "workbooks/typical.xlsx", "workbooks/typical.ods"})
        QTest::newRow(qPrintable(file)) << file;
}

void ImportedFilesTest::everyTruncationIsAnErrorOrAMeasurement() {
    QFETCH(QString, file);
    const QByteArray whole = contents(DATA + file);
    for (qsizetype size = 0; size < whole.size(); ++size) {
        try {
            const Imported imported = importMeasurement(QByteArrayView(whole).first(size), file);
            // What is accepted is a document like any other: no array is shorter than its neighbour.
            if (imported.test) {
                Document document;
                addImported(document, imported, QByteArrayView(whole).first(size), file, true);
                QVERIFY(readDocument(writeDocument(document)) == document);
            }
        } catch (const Error &error) {
            QVERIFY(!error.message.text.empty());
        }
    }
    // Formats that say where they end are refused when they were cut off.
    if (file.startsWith("rtl") || file.startsWith("b5r") || file.startsWith("workbooks"))
        QVERIFY(outcome(whole.left(whole.size() - 9), file).startsWith("refused"));
}

void ImportedFilesTest::takesChoices_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("expected");
    const QByteArray table = "0\t1\t2\n100\t3\t4\n";
    const QString head = "ISO 230-2:2014  mm: 0 100\n";
    QTest::newRow("nothing chosen") << table << "" << head + "↑ 1 3\n↓ 2 4";
    QTest::newRow("unit") << table << "unit=nm" << head + "↑ 0.001 0.003\n↓ 0.002 0.004";
    QTest::newRow("other sign") << table << "sign=targetMinusActual" << head + "↑ -1 -3\n↓ -2 -4";
    QTest::newRow("all ↓") << table << "directions=negative" << head + "↓ 1 3\n↓ 2 4";
    QTest::newRow("one direction") << table << "directions=positive" << head + "↑ 1 3\n↑ 2 4";
    QTest::newRow("positions") << QByteArray("0\t0.001\n100\t99.998\n200\t200\n") << "content=positions"
                               << "ISO 230-2:2014  mm: 0 100 200\n↑ 1 -2 0";
    QTest::newRow("unit of positions") << table << "positionUnit=in unit=um"
                                       << "ISO 230-2:2014  mm: 0 2540\n↑ 1 3\n↓ 2 4";
    QTest::newRow("axis and edition") << table << "axis=Z edition=ISO 230-2:1988"
                                      << "ISO 230-2:1988 Z mm: 0 100\n↑ 1 3\n↓ 2 4";
    QTest::newRow("rotary")
        << table << "motion=rotary"
        << "ISO 230-2:2014  °: 0 100\n↑ 0.0002777778 0.0008333333\n↓ 0.0005555556 0.001111111";
    QTest::newRow("runs down") << QByteArray("0 100\n1 3\n2 4\n") << "layout=runsDown"
                               << head + "↑ 1 3\n↓ 2 4";
    QTest::newRow("decimal mark") << QByteArray("0\t1,5\t2\n100\t3,5\t4\n") << "decimalMark=point"
                                  << head + "↑ – –\n↓ 2 4";
    QTest::newRow("drift") << QByteArray("0\t1\n100\t3\n") << "kind=drift unit=um timeUnit=min axis=X"
                           << "drift X 0:1 6000:3";
    QTest::newRow("circle") << QByteArray("0\t1\n100\t3\n200\t2\n")
                            << "kind=circular layout=angleDeviation unit=um nominalRadius=75 plane=ZX "
                               "feed=500 angleReference=commanded"
                            << "ISO 230-4:2005 ZX R 75 mm F 500\nccw commanded 3: 0:1 100:3 200:2";
    QTest::newRow("radial deviations alone")
        << QByteArray("1\n3\n2\n4\n5\n")
        << "kind=circular unit=um nominalRadius=75 plane=ZX startAngle=90 arc=-180 angleReference=polar"
        << "ISO 230-4:2005 ZX R 75 mm F –\ncw polar 5: 90:1 45:3 0:2 -45:4 -90:5";
    QTest::newRow("radial deviations alone in two columns")
        << QByteArray("CW µm;CCW µm\n1;3\n2;4\n5;6\n")
        << "kind=circular layout=deviations nominalRadius=75 plane=ZX startAngle=0 angleReference=polar"
        << "ISO 230-4:2005 ZX R 75 mm F –\ncw polar 3: 0:1 -180:2 -360:5\nccw polar 3: 0:3 180:4 360:6";
}

void ImportedFilesTest::takesChoices() {
    QFETCH(QByteArray, text);
    QFETCH(QString, options);
    QFETCH(QString, expected);
    ImportOptions chosen;
    for (const QString &option : options.split(' ', Qt::SkipEmptyParts)) {
        if (option.contains('='))
            chosen[option.section('=', 0, 0).toStdString()] = option.section('=', 1).toStdString();
        else
            chosen["edition"] += ' ' + option.toStdString(); // editions have a blank
    }
    const Imported imported = importMeasurement(text, "x.csv", chosen);
    QCOMPARE(testdata::picture(imported), expected);
    // What is chosen is no guess, and no remark asks for it.
    for (const auto &[key, word] : chosen) {
        const auto choice = std::ranges::find(imported.choices, key, &ImportChoice::key);
        QVERIFY2(choice != imported.choices.end(), key.c_str());
        QVERIFY2(choice->origin == Origin::chosen && choice->value == word, key.c_str());
        QVERIFY(std::ranges::none_of(imported.questions,
                                     [&](const Question &question) { return question.id == key; }));
    }
}

void ImportedFilesTest::refusesUnknownChoices() {
    for (const ImportOptions &options :
         {ImportOptions{{"unitt", "mm"}}, ImportOptions{{"unit", "furlong"}},
          ImportOptions{{"nominalRadius", "wide"}}, ImportOptions{{"edition", "ISO 1"}},
          ImportOptions{{"unit", "deg"}, {"motion", "linear"}}, ImportOptions{{"edition", "ISO 230-4:2005"}},
          ImportOptions{{"kind", "circular"}, {"edition", "ISO 230-2:2014"}}})
        QVERIFY_EXCEPTION_THROWN((void)importMeasurement("0\t1\n100\t2\n", "x.csv", options), Error);
    QVERIFY_EXCEPTION_THROWN(
        (void)importMeasurement(contents(DATA "rtl/typical.rtl"), "x.rtl", {{"edition", "ISO 230-4:2005"}}),
        Error);
}

void ImportedFilesTest::refusesHugeFilesAtOnce() {
    // A view that claims more than there is: it must not be touched.
    const char nothing = 0;
    const qsizetype twoGigabytes = qsizetype(2) << 30;
    QVERIFY_EXCEPTION_THROWN((void)importMeasurement(QByteArrayView(&nothing, twoGigabytes), "x.csv"), Error);
}

void ImportedFilesTest::keepsTheOriginal() {
    const QByteArray bytes = contents(DATA "rtl/typical.rtl");
    for (const bool keep : {false, true}) {
        Document document;
        addImported(document, importMeasurement(bytes, "a/b.rtl"), bytes, "a/b.rtl", keep);
        QCOMPARE(document.machine.name, std::string("Mill 5"));
        QCOMPARE(document.report.operatorName, std::string("J. Martin"));
        const Test &test = *document.tests.at(0);
        QCOMPARE(test.id, std::string("x"));
        QCOMPARE(test.title, std::string("X axis as found"));
        QCOMPARE(test.imports.at(0).fileName, std::string("b.rtl"));
        QCOMPARE(test.imports.at(0).sha256,
                 QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().toStdString());
        QCOMPARE(test.imports.at(0).data.has_value(), keep);
        if (keep)
            QCOMPARE(QByteArray::fromBase64(QByteArray::fromStdString(*test.imports.at(0).data)), bytes);
        const auto &conditions = std::get<PositioningMeasurement>(test.measurement).conditions;
        QCOMPARE(conditions.airPressure, std::optional(1013.25));
        QCOMPARE(conditions.airHumidity, std::optional(45.0));
        QCOMPARE(conditions.common.expansion.machine, std::optional(11.7));
        QCOMPARE(conditions.common.sensors.size(),
                 std::size_t(3)); // the third at the machine was not connected
        QVERIFY(readDocument(writeDocument(document)) == document);
    }
    const QByteArray ballbar = contents(DATA "b5r/typical-absolute.b5r");
    Document document;
    addImported(document, importMeasurement(ballbar, "x.b5r"), ballbar, "x.b5r", false);
    const std::vector<ImportedResult> results = document.tests.at(0)->imports.at(0).results;
    QCOMPARE(results.size(), std::size_t(3));
    QVERIFY(results.at(1) == (ImportedResult{"Renishaw: AF_CIRCULARITY", 8.4, "µm"}));
    QCOMPARE(document.instruments.at(0).serialNumber, std::string("QC-0815"));
    QCOMPARE(document.instruments.at(0).calibrationDate, std::optional<std::string>("2025-09-01"));
    QCOMPARE(document.machine.serialNumber, std::string("4711"));
    QCOMPARE(document.tests.at(0)->date, std::optional<std::string>("2026-03-12"));
    QCOMPARE(document.tests.at(0)->time, std::optional<std::string>("10:25"));
    QCOMPARE(document.tests.at(0)->instruments, std::vector<std::string>{"instrument"});
    QVERIFY(readDocument(writeDocument(document)) == document);
}

void ImportedFilesTest::putsTemperaturesIntoTheTests() {
    const QByteArray temperatures = contents(DATA "tables/temperatures.csv");
    Document document;
    QVERIFY_EXCEPTION_THROWN(
        addImported(document, importMeasurement(temperatures, "t.csv"), temperatures, "t.csv", false), Error);
    const QByteArray table = contents(DATA "tables/typical.csv");
    addImported(document, importMeasurement(table, "x.csv"), table, "x.csv", false);
    addImported(document, importMeasurement(temperatures, "t.csv"), temperatures, "t.csv", false);
    const Test &test = *document.tests.at(0);
    const auto &conditions = std::get<PositioningMeasurement>(test.measurement).conditions;
    QCOMPARE(conditions.common.sensors.size(), std::size_t(3));
    QVERIFY(conditions.gradientPerHour &&
            std::abs(*conditions.gradientPerHour - 0.5) < 1e-12); // rounding of 20.6 − 20.1
    QCOMPARE(test.imports.size(), std::size_t(2));
    QVERIFY(readDocument(writeDocument(document)) == document);
}

void ImportedFilesTest::takesTheGradientOfTheAir_data() {
    QTest::addColumn<QByteArray>("heading");
    QTest::addColumn<QByteArray>("time"); // of the test
    QTest::addColumn<double>("gradient"); // 0: none
    QTest::addColumn<double>("hours");    // −1: not known
    QTest::newRow("air, half a day before") << QByteArray("Air (°C)") << QByteArray("08:30") << 0.4 << 12.5;
    QTest::newRow("air, when the test began is not stated")
        << QByteArray("Air (°C)") << QByteArray() << 0.4 << -1.0;
    QTest::newRow("machine") << QByteArray("Machine (°C)") << QByteArray("08:30") << 0.0 << -1.0;
}

/// The gradient is that of the environment; before the test lie the hours from the start of a dated series.
void ImportedFilesTest::takesTheGradientOfTheAir() {
    QFETCH(QByteArray, heading);
    QFETCH(QByteArray, time);
    QFETCH(double, gradient);
    QFETCH(double, hours);
    const QByteArray table = contents(DATA "tables/typical.csv");
    Document document;
    addImported(document, importMeasurement(table, "x.csv"), table, "x.csv", false);
    editTest(document, 0, [&](Test &test) {
        test.date = "2026-11-20";
        test.time = time.isEmpty() ? std::nullopt : std::optional(time.toStdString());
    });
    const QByteArray series = "Time;" + heading +
                              "\n2026-11-19 20:00:00;20,0\n2026-11-19 21:00:00;20,4\n"
                              "2026-11-20 09:00:00;20,5\n";
    addImported(document, importMeasurement(series, "t.csv"), series, "t.csv", false);
    const auto &conditions = std::get<PositioningMeasurement>(document.tests.at(0)->measurement).conditions;
    QCOMPARE(conditions.gradientPerHour.has_value(), gradient > 0);
    if (gradient > 0)
        QVERIFY(std::abs(*conditions.gradientPerHour - gradient) < 1e-12); // rounding of 20.4 − 20.0
    QCOMPARE(conditions.gradientHoursBefore, hours < 0 ? std::nullopt : std::optional(hours));
}

void ImportedFilesTest::coloursTheCells() {
    const Imported imported = importMeasurement(contents(DATA "tables/typical.csv"), "x.csv");
    const TableRow row = imported.table.rows()[3];
    QString colours;
    for (std::size_t c = 0; c < row.count; ++c)
        colours +=
            "-hp+n"[static_cast<std::size_t>(imported.roles[row.first + c])]; // in the order of CellRole
    QCOMPARE(colours, QString("p+n+n+n"));
    QVERIFY(imported.roles[imported.table.rows()[2].first] == CellRole::head);
}

void ImportedFilesTest::readsWhatStandsBesideTheTable() {
    const Imported imported = importMeasurement(contents(DATA "workbooks/cover-and-hidden.xlsx"), "x.xlsx");
    QCOMPARE(imported.machine.name, std::string("HAAS"));
    QCOMPARE(imported.operatorName, std::string("M. Weber"));
    QCOMPARE(imported.test->date, std::optional<std::string>("2024-03-05"));
    QCOMPARE(imported.sheets.size(), std::size_t(3));
    QVERIFY(imported.sheets.at(1) == (ImportSheet{"Data", false, true}));
    QVERIFY(imported.sheets.at(2).isHidden && imported.sheets.at(2).name == "Old");
    // A hidden sheet that comes first is offered last.
    const Imported hidden = importMeasurement(contents(DATA "workbooks/hidden-first.xlsx"), "x.xlsx");
    const auto sheet = std::ranges::find(hidden.questions, "sheet", &Question::id);
    QVERIFY(sheet != hidden.questions.end());
    QCOMPARE(sheet->answers, (std::vector<std::string>{"X", "Y", "Old"}));
    // A label with its colon in one cell, values in other languages, a date that can be read in two ways.
    const Imported text = importMeasurement("Maschine: Mill 5\nSeriennummer: 4711\nOpérateur : J. "
                                            "Martin\n03/04/2024\nP (mm);1↑ (µm);1↓ (µm)\n0;1;2\n100;3;4\n",
                                            "x.csv");
    QCOMPARE(text.machine.name, std::string("Mill 5"));
    QCOMPARE(text.machine.serialNumber, std::string("4711"));
    QCOMPARE(text.operatorName, std::string("J. Martin"));
    QVERIFY(!text.test->date);
    QCOMPARE(text.test->remarks, std::string("03/04/2024"));
}

void ImportedFilesTest::showsWhatCannotBeRead() {
    const QByteArray text = "Target (mm);Note\n0;a\n100;b\n";
    const Imported shown = showMeasurement(text, "x.csv");
    QVERIFY(shown.refusal && !shown.test);
    QCOMPARE(shown.table.rows().size(), std::size_t(3));
    QVERIFY_EXCEPTION_THROWN((void)importMeasurement(text, "x.csv"), Error);
    QVERIFY_EXCEPTION_THROWN((void)showMeasurement("", "x.csv"), Error);
}

QTEST_GUILESS_MAIN(ImportedFilesTest)
#include "importedfiles.moc"
