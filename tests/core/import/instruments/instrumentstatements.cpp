// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"

#include <QTest>
#include <QtEndian>

using namespace palmer;

namespace {

const QByteArray laser = "HEADER::\nFile type : LIN\nTARGET DATA::\nTargets : 0.000 50.000 125.000\n"
                         "Flags: 0 0 2 0\nUSER-TEXT::\nAxis : Z\nRUNS::\nRun-count : 2\n"
                         "DEVIATIONS::\nRun Target Data:\n1 1 -0.400\n1 2 1.300\n1 3 2.700\n"
                         "2 3 3.100\n2 2 1.900\n2 1 0.600\nEOF::\n";
const QByteArray means = "Position Forward Directional Avg Error\n0 0.0011\n4 0.0032\n"
                         "Position Bidirectional Avg Error\n0 0.0014\n4 0.0036\n";
const QByteArray table = "Compensation start (mm) : 0\nCompensation end (mm) : 80\n"
                         "No.  Axis position  Combined\n1  0  0\n2  40  -3\n3  80  5\n";
const QByteArray indexed = "UNIT=mm\nTGT_DATA[1]=0.0\nTGT_DATA[2]=60.0\nREF_DATA_FWD[1,1]=0.0007\n"
                           "REF_DATA_FWD[2,1]=60.0021\n";
const QByteArray ballbar =
    "<TEST_DOCUMENT><TEST_SPEC NAME=\"XY\"><DYNAMIC_BALLBAR><NOMINAL_LENGTH>80</NOMINAL_LENGTH>"
    "<PLANE TEST_PLANE=\"XY\"/></DYNAMIC_BALLBAR></TEST_SPEC><RUN_RESULTS>"
    "<BALLBAR_RUN><RUN_DIRECTION>CW</RUN_DIRECTION>"
    "<READINGS DT=\"UT_LENGTH_MM\">0.001 0.002 0.003 0.002 0.001</READINGS></BALLBAR_RUN>"
    "</RUN_RESULTS></TEST_DOCUMENT>";

/// The text with lines put in before a place in it.
QByteArray with(const QByteArray &text, const QByteArray &before, const QByteArray &lines) {
    const qsizetype at = before.isEmpty() ? text.size() : text.indexOf(before);
    return text.left(at) + lines + text.mid(at);
}

QByteArray capture(const QByteArray &lines) {
    QByteArray file = "HEADER::\r\nSample no : 3\r\n" + lines + "Data:\r\n";
    for (const double value : {0.0, 0.0004, 0.0013}) {
        const quint64 bits = qToLittleEndian(std::bit_cast<quint64>(value));
        file.append(reinterpret_cast<const char *>(&bits), sizeof bits);
    }
    return file + "EOF::\r\n";
}

} // namespace

/// Every line and element of an instrument's file is read, listed, or asked for.
class InstrumentStatementsTest : public QObject {
    Q_OBJECT

private slots:
    void asksOrLists_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QString>("said"); // a line of the picture, questions or remarks, or of the refusal
        const auto row = [](const char *name, const QByteArray &file, const QString &said) {
            QTest::newRow(name) << file << said;
        };
        row("laser: unit of the targets", with(laser, "Flags", "Units : inches\n"), "!! positionUnit=: ");
        row("laser: unit of the deviations", with(laser, "Run Target", "Units : tenths\n"), "!! unit=: ");
        row("laser: the units of the format", with(laser, "Run Target", "Units : µm\n"),
            "Statements that were read: 1 (11: Units: µm)");
        row("laser: a unit that is a device", with(laser, "RUNS", "Unit no : 4\n"),
            "Lines of text that were not used: 1 (8: Unit no: 4)");
        row("laser: second measurement", laser + QByteArray(laser).replace("Axis : Z", "Axis : X"),
            "!! table=1: Table: the file has several, in the lines 1: 1–18 (Z); 2: 19–36 (X)");
        row("laser: deviations once more", with(laser, "EOF", "DEVIATIONS::\n1 1 7.500\n"),
            "!! unread=: 18: The section DEVIATIONS is there once more");
        row("laser: direction of a run", with(laser, "DEVIATIONS", "Run 2 : Forward\n"),
            "!! directions=stated: ");
        row("laser: sign", with(laser, "DEVIATIONS", "Sign : target - actual\n"),
            "!! sign=targetMinusActual: ");
        row("laser: comment", with(laser, "DEVIATIONS", "Note : beam lost once\n"),
            "10: Note: beam lost once");
        row("laser: above the sections", "Exported by shop 7\n" + laser, "1: Exported by shop 7");
        row("laser: kind in the head", with(laser, "TARGET DATA", "Measurement : Squareness\n"),
            "!! kind=positioning: 3: ");
        row("laser: kind in the title", with(laser, "RUNS", "TITLE : Flatness of the table\n"),
            "!! kind=positioning: ");
        row("laser: a number cut off", QByteArray(laser).replace("1 2 1.300", "1 2 1."), "!! unread=: ");
        row("laser: thousands or decimals", QByteArray(laser).replace("1 2 1.300", "1 2 1,300"),
            "!! decimalMark=comma: 13: ");
        row("laser: list of other targets", with(laser, "USER-TEXT", "Spare :\n0 1 2\n"), "!! unread=: 7: ");
        row("laser: a row with a colon", with(laser, "2 3 3.100", "1 : 3 2.800\n"), "!! unread=: 15: ");

        row("means: inches above the table", "Units: Inches\n" + means, "mm: 0 101.6\n↑ 27.94 81.28");
        row("means: unit of the heading", "Units: mm\n" + QByteArray(means).replace("Error", "Error (um)"),
            "mm: 0 4\n↑ 0.0011 0.0032");
        row("means: units of both columns",
            QByteArray(means).replace("Error", "Error (um)").replace("Position", "Position (in)"),
            "mm: 0 101.6\n↑ 0.0011 0.0032");
        row("means: headings that differ",
            QByteArray(means).replace("Bidirectional Avg Error", "Bidirectional Avg Error (nm)"),
            "!! unit=: ");
        row("means: statements above", "Machine: Lathe 3\nBay 12\n" + means,
            "Lines of text that were not used: 1 (2: Bay 12)");
        row("means: numbers above", "0 0.0009\n" + means, "!! unread=: 1: ");

        row("compensation: inches", QByteArray(table).replace("(mm)", "(in)"), "mm: 0 1016 2032");
        row("compensation: two units of positions", QByteArray(table).replace("end (mm)", "end (in)"),
            "!! positionUnit=: ");
        row("compensation: resolution", "Compensation resolution : 0.1 um\n" + table, "!! unit=: ");
        row("compensation: resolution of one", "Compensation resolution (nm) : 1\n" + table,
            "↑ 0 0.003 -0.005");
        row("compensation: sign", "Compensation sign : As errors\n" + table, "!! sign=actualMinusTarget: ");
        row("compensation: increments", "Compensation calculation : Incremental\n" + table,
            "the table holds increments from one position to the next");
        row("compensation: direction", "Direction : Reverse\n" + table, "!! directions=negative: ");
        row("compensation: type", "Compensation type : Combined\n" + table,
            "1: Compensation type : Combined");

        row("indexed: comments", "; Machine: Mill 9\n; cold start\n" + indexed,
            "Statements that were read: 2 (1: Machine: Mill 9; 3: UNIT: mm)");
        row("indexed: other comments", "; cold start\n" + indexed, "1: cold start");
        row("indexed: the cycle before the target",
            "UNIT=mm\nTGT_DATA[1]=0\nTGT_DATA[2]=60\nREF_DATA_FWD[1,1]=0.0007\nREF_DATA_FWD[1,2]=60.0021\n"
            "REF_DATA_FWD[2,1]=0.0015\nREF_DATA_FWD[2,2]=60.0044\n",
            "↑ 0.7 2.1\n↑ 1.5 4.4");
        row("indexed: behind a value", QByteArray(indexed).replace("=60.0\n", "=60.0 ; moved\n"), "3: moved");
        row("indexed: unit in a comment", "; Units: inch\n" + QByteArray(indexed).replace("UNIT=mm\n", ""),
            "mm: 0 1524");
        row("indexed: second axis", "AXIS=X\n" + indexed + "AXIS=Y\n", "!! unread=: 7: ");
        row("indexed: a number cut off", QByteArray(indexed).replace("60.0021", "60."), "!! unread=: ");

        row("capture: velocity", capture("File Type : Velocity\r\nSample rate : 20\r\n"), "!! kind=drift: ");
        row("capture: straightness", capture("File Type : STR\r\nSample rate : 20\r\n"), "!! kind=drift: ");
        row("capture: kind in the title",
            capture("File Type : LIN\r\nSample rate : 20\r\nTITLE : Straightness of Y\r\n"),
            "!! kind=drift: ");
        row("capture: rotary", capture("File Type : ROT\r\nSample rate : 20\r\n"), "unit=mrad ");
        row("capture: kHz", capture("Sample rate : 4 kHz\r\n"), "0.00025:0.4 ");
        row("capture: per minute", capture("Sample rate : 20 per minute\r\n"),
            "the unit of the sample rate “20 per minute” is not known");
        row("capture: unit", capture("Sample rate : 20\r\nUnits : microns\r\n"), "!! unit=: ");
        row("capture: section", capture("Sample rate : 20\r\nENVIRONMENT::\r\nAir temp : 23.5\r\n"),
            "5: Air temp: 23.5");

        row("ballbar: second test",
            with(ballbar, "</TEST_DOC", QByteArray(ballbar).mid(15).replace("</TEST_DOCUMENT>", "")),
            "!! table=1: ");
        row("ballbar: units of two runs",
            with(ballbar, "</RUN_RESULTS",
                 "<BALLBAR_RUN><RUN_DIRECTION>CCW</RUN_DIRECTION>"
                 "<READINGS DT=\"UT_LENGTH_UM\">1.5 2.5 3.5 2.5 1.5</READINGS></BALLBAR_RUN>"),
            "ccw commanded 5: 0:1.5 90:2.5");
        row("ballbar: a unit in one run only",
            with(ballbar, "</RUN_RESULTS",
                 "<BALLBAR_RUN><RUN_DIRECTION>CCW</RUN_DIRECTION>"
                 "<READINGS>0.002 0.003 0.004 0.003 0.002</READINGS></BALLBAR_RUN>"),
            "!! unit=: ");
        row("ballbar: runs of other length",
            with(ballbar, "</RUN_RESULTS",
                 "<BALLBAR_RUN><RUN_DIRECTION>CCW</RUN_DIRECTION>"
                 "<READINGS DT=\"UT_LENGTH_MM\">0.002 0.003 0.004</READINGS></BALLBAR_RUN>"),
            "!! arc=360: ");
        row("ballbar: a run without readings",
            with(ballbar, "</RUN_RESULTS>",
                 "<BALLBAR_RUN><RUN_DIRECTION>CCW</RUN_DIRECTION><READINGS/></BALLBAR_RUN>"),
            "!! unread=: Runs without readings: 1.");
        row("ballbar: feed with thousands",
            with(ballbar, "<PLANE", "<PROGRAMMED_FEEDRATE DT=\"UT_FEEDRATE\">2,500.0</PROGRAMMED_FEEDRATE>"),
            "PROGRAMMED_FEEDRATE: 2,500.0");
        row("ballbar: start angle", with(ballbar, "<PLANE", "<START_ANGLE>45</START_ANGLE>"),
            "!! startAngle=45: ");
        row("ballbar: overshoot of a run",
            with(ballbar, "<READINGS", "<FEATURE NAME=\"OVERSHOOT\" DT=\"UT_ANGLE\">30</FEATURE>"),
            "!! overshoot=30: ");
        row("ballbar: the usual arc", with(ballbar, "<PLANE", "<ARC_SIZE DT=\"UT_ANGLE\">360</ARC_SIZE>"),
            "?? arc=360: Arc (°): the file says “ARC_SIZE: 360”");
        row("ballbar: day of calibration",
            with(ballbar, "<DYNAMIC", "<LAST_CALIBRATED>02/05/2025</LAST_CALIBRATED>"),
            "Elements that were not read: LAST_CALIBRATED: 02/05/2025.");
        row("ballbar: result that is no number",
            with(ballbar, "</TEST_DOC", "<ANALYSIS><FEATURE NAME=\"F\">7.1 *</FEATURE></ANALYSIS>"),
            "Elements that were not read: F: 7.1 *.");
        row("ballbar: attribute", QByteArray(ballbar).replace("<READINGS", "<READINGS RATE=\"100\""),
            "READINGS@RATE: 100");
        QByteArray elements;
        for (char letter = 'A'; letter <= 'P'; ++letter)
            elements += QByteArray("<E_") + letter + ">7</E_" + letter + '>';
        row("ballbar: many elements", with(ballbar, "<PLANE", elements), "E_P: 7.");
    }
    void asksOrLists() {
        QFETCH(QByteArray, file);
        QFETCH(QString, said);
        const Imported imported = showMeasurement(file, "x.txt", {});
        QString all = testdata::picture(imported) + '\n' + testdata::questions(imported) + '\n' +
                      testdata::remarks(imported) + '\n' + testdata::choices(imported);
        if (imported.refusal)
            all += '\n' + Language(Language::Id::english).sentence(imported.refusal->message);
        QVERIFY2(all.contains(said), qPrintable(all));
    }

    void aLengthInAnotherUnitIsRefused() {
        try {
            (void)importMeasurement(
                QByteArray(ballbar).replace("<NOMINAL_LENGTH>", "<NOMINAL_LENGTH DT=\"UT_LENGTH_IN\">"),
                "x.b5r");
            QFAIL("it is read");
        } catch (const Error &error) {
            QVERIFY(Language(Language::Id::english)
                        .sentence(error.message)
                        .contains("the unit “UT_LENGTH_IN” of the nominal length is not known"));
        }
    }

    void answersAreFollowed_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QString>("choice");
        QTest::addColumn<QString>("said");
        QTest::newRow("second measurement")
            << laser + QByteArray(laser).replace("0.600", "0.800") << "table=2"
            << "↓ 0.8 1.9 3.1";
        QTest::newRow("thousands") << QByteArray(laser).replace("1 2 1.300", "1 2 1,300")
                                   << "decimalMark=point"
                                   << "↑ -0.4 1300 2.7";
        QTest::newRow("unit of the targets") << with(laser, "Flags", "Units : inches\n") << "positionUnit=in"
                                             << "mm: 0 1270 3175";
        QTest::newRow("direction of a table") << "Direction : Reverse\n" + table << "directions=positive"
                                              << "↑ 0 3 -5";
        QTest::newRow("second test of a ballbar")
            << with(ballbar, "</TEST_DOC",
                    QByteArray(ballbar).mid(15).replace("</TEST_DOCUMENT>", "").replace("0.003", "0.007"))
            << "table=2"
            << "180:7 ";
    }
    void answersAreFollowed() {
        QFETCH(QByteArray, file);
        QFETCH(QString, choice);
        QFETCH(QString, said);
        const std::string key = choice.section('=', 0, 0).toStdString();
        const Imported imported =
            importMeasurement(file, "x.txt", {{key, choice.section('=', 1).toStdString()}});
        QVERIFY2(testdata::picture(imported).contains(said), qPrintable(testdata::picture(imported)));
        QVERIFY(std::ranges::none_of(imported.questions,
                                     [&](const Question &question) { return question.id == key; }));
    }
};

QTEST_GUILESS_MAIN(InstrumentStatementsTest)
#include "instrumentstatements.moc"
