// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

namespace {

using namespace palmer::testdata;

CliResult run(const QStringList &arguments, const QString &locale = "C", const QString &zone = "UTC") {
    return runCli(arguments, {}, {{"LC_ALL", locale}, {"TZ", zone}});
}

const QString example = EXAMPLES "iso230-2-1988-example.palmer";
const QString rejected = DOCUMENTS "limits-2006.palmer";

} // namespace

/// The commands that draw.
class ReportCommandTest : public QObject {
    Q_OBJECT

private slots:
    void writesOneLanguage();
    void writesAFileForEachLanguage();
    void writesTheReportOfARejectedTest();
    void writesToStandardOutput();
    void saysBeforehandThatAReportIsLong();
    void sameBytesAnywhere();
    void noFontOfTheSystemIsTaken();
    void saysThatALogoIsNoPicture_data();
    void saysThatALogoIsNoPicture();
    void refusesWrongUsage_data();
    void refusesWrongUsage();
    void noReportTakesTheNameOfAnother();
    void saysWhatItCannotReadOrWrite();
    void drawsFigures_data();
    void drawsFigures();
    void figureSpeaksTheLanguageAskedFor();
};

void ReportCommandTest::writesOneLanguage() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("r.pdf");
    const CliResult result = run({"report", example, "--language", "en", "-o", out});
    QCOMPARE(result.code, 0);
    QCOMPARE(result.out, QByteArray());
    QCOMPARE(result.err, QByteArray());
    QVERIFY(contents(out).startsWith("%PDF-1.7"));
}

void ReportCommandTest::writesAFileForEachLanguage() {
    const QTemporaryDir folder;
    QCOMPARE(run({"report", example, "--language=fr,en", "-o", folder.filePath("r.pdf")}).code, 0);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files, QDir::Name), QStringList({"r.en.pdf", "r.fr.pdf"}));
    QVERIFY(contents(folder.filePath("r.en.pdf")) != contents(folder.filePath("r.fr.pdf")));
}

void ReportCommandTest::writesTheReportOfARejectedTest() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("r.pdf");
    QCOMPARE(run({"report", rejected, "--language", "fr", "-o", out}).code, 1);
    QVERIFY(contents(out).startsWith("%PDF-"));
}

void ReportCommandTest::writesToStandardOutput() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("r.pdf");
    run({"report", example, "--language", "fr", "-o", out});
    const CliResult result = run({"report", example, "--language", "fr", "-o", "-"});
    QCOMPARE(result.code, 0);
    QVERIFY(result.out == contents(out));
}

/// More rows than are printed unasked, and asked for: said on stderr; else nothing is.
void ReportCommandTest::saysBeforehandThatAReportIsLong() {
    const QTemporaryDir folder;
    const auto saidOf = [&](int targets, bool all) {
        QStringList positions;
        QStringList deviations;
        for (int i = 0; i < targets; ++i) {
            positions << QString::number(i);
            deviations << QString::number(0.001 * (i % 7));
        }
        const QString file = folder.filePath("long.palmer");
        QFile written(file);
        if (!written.open(QIODevice::WriteOnly))
            qFatal("cannot write");
        const QString text =
            QStringLiteral(
                R"({"format": "palmer test report", "version": 2, "report": {"languages": ["en"]%1},
"tests": [{"kind": "positioning", "id": "x", "edition": "ISO 230-2:2006", "axis": {"name": "X"}, "targets": [%2],
"runs": [{"approach": "positive", "deviations": [%3]}, {"approach": "negative", "deviations": [%3]}]}]})")
                .arg(all ? R"(, "include": ["allReadings"])" : "", positions.join(", "),
                     deviations.join(", "));
        written.write(text.toUtf8());
        written.close();
        return run({"report", file, "-o", folder.filePath("long.pdf"), "--force"}).err;
    };
    QCOMPARE(saidOf(2001, false), QByteArray());
    QCOMPARE(saidOf(2000, true), QByteArray());
    const QByteArray said = saidOf(2001, true);
    QVERIFY2(said.startsWith("palmer-cli: all readings are to be printed, on about "), said.constData());
    QCOMPARE(said.count('\n'), 1);
}

void ReportCommandTest::sameBytesAnywhere() {
    for (const QStringList &command : {QStringList{"report", rejected, "--language", "fr", "-o"},
                                       QStringList{"figure", rejected, "--language", "fr", "-o"}}) {
        const QTemporaryDir folder;
        const QString here = folder.filePath("here.pdf");
        const QString there = folder.filePath("there.pdf");
        run(command + QStringList{here});
        QTest::qWait(1100);
        run(command + QStringList{there}, "fr_FR.UTF-8", "Asia/Tokyo");
        QVERIFY(contents(here).startsWith("%PDF"));
        QVERIFY(contents(here) == contents(there));
    }
}

/// Another version of the same family, as many systems have it: each letter as wide as the others.
QByteArray otherVersion(QByteArray face) {
    const auto number = [&face](qsizetype at) { return qFromBigEndian<quint32>(face.constData() + at); };
    for (qsizetype row = 12; row < 12 + 16 * qFromBigEndian<quint16>(face.constData() + 4); row += 16) {
        if (face.sliced(row, 4) != "hmtx")
            continue;
        for (quint32 at = number(row + 8), end = at + number(row + 12); at + 4 <= end; at += 4)
            qToBigEndian<quint16>(1000, face.data() + at);
    }
    return face;
}

/// Without it a report would be drawn otherwise on another machine, and `verify` would say so.
void ReportCommandTest::noFontOfTheSystemIsTaken() {
    const QTemporaryDir folder;
    const QString fonts = folder.filePath("fonts");
    QVERIFY(QDir().mkdir(fonts));
    for (const QString face : {"Regular", "Bold", "Italic", "BoldItalic"}) {
        const QString name = "/LiberationSans-" + face + ".ttf";
        QFile file(fonts + name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(otherVersion(contents(EXAMPLES "../fonts" + name)));
    }
    QByteArrayList reports;
    for (const QString &place : {fonts, folder.filePath("nothing")}) {
        QFile configuration(folder.filePath("fonts.conf"));
        QVERIFY(configuration.open(QIODevice::WriteOnly));
        configuration.write(
            ("<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>" + place +
             "</dir><cachedir>" + folder.filePath("cache") + "</cachedir></fontconfig>")
                .toUtf8());
        configuration.close();
        const QString out = folder.filePath("r.pdf");
        QCOMPARE(runCli({"report", example, "--language", "fr", "-o", out}, {},
                        {{"FONTCONFIG_FILE", configuration.fileName()}})
                     .code,
                 0);
        reports << contents(out);
    }
    QVERIFY(!reports.front().isEmpty());
    QVERIFY(reports.front() == reports.back());
}

void ReportCommandTest::saysThatALogoIsNoPicture_data() {
    QTest::addColumn<QByteArray>("picture");
    QTest::addColumn<bool>("isPicture");
    const QByteArray damaged =
        QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x0a\0\0\0\x0a\x08\x02\0\0\0", 29) +
        QByteArray::fromHex("025058ea00000007494441546761726261676500000000");
    QTest::newRow("a PNG that is damaged") << damaged << false;
    QTest::newRow("the beginning of one") << QByteArray("\x89PNG\r\n") << false;
    QTest::newRow("a text") << QByteArray("foo") << false;
    QTest::newRow("a drawing")
        << QByteArray(
               R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M0 0h9v9z"/></svg>)")
        << true;
}

void ReportCommandTest::saysThatALogoIsNoPicture() {
    QFETCH(const QByteArray, picture);
    QFETCH(const bool, isPicture);
    const QTemporaryDir folder;
    const QString out = folder.filePath("r.pdf");
    const CliResult result = run({"report", example, "--language", "en", "-o", out, "--set",
                                  "report.laboratory.logo=" + QString::fromLatin1(picture.toBase64())});
    QCOMPARE(result.code, 0);
    QVERIFY(contents(out).startsWith("%PDF-"));
    if (isPicture) {
        QCOMPARE(result.err, QByteArray());
        QVERIFY(!run({"check", example, "--json", "--set",
                      "report.laboratory.logo=" + QString::fromLatin1(picture.toBase64())})
                     .out.contains("\"pictures\""));
        return;
    }
    QCOMPARE(result.err.count('\n'), 1); // and nothing of libpng
    const CliResult checked = run({"check", example, "--language", "en", "--json", "--set",
                                   "report.laboratory.logo=" + QString::fromLatin1(picture.toBase64())});
    QVERIFY2(checked.out.contains("\"id\": \"pictures\""), checked.out);
    QCOMPARE(checked.err, QByteArray());
    QVERIFY2(result.err.contains("report.laboratory.logo: this is no PNG or SVG picture"), result.err);
}

void ReportCommandTest::refusesWrongUsage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    QTest::newRow("report without output") << QStringList{"report", example} << "-o OUT.pdf";
    QTest::newRow("unknown language")
        << QStringList{"report", example, "-o", "x.pdf", "--language", "fr,de"} << "de";
    QTest::newRow("two languages to standard output")
        << QStringList{"report", example, "-o", "-", "--language", "fr,en"} << "standard output";
    QTest::newRow("two files") << QStringList{"report", example, example, "-o", "x.pdf"}
                               << "would both be written as";
    QTest::newRow("figure without output") << QStringList{"figure", example} << "-o OUT.svg|png|pdf";
    QTest::newRow("unknown ending") << QStringList{"figure", example, "-o", "x.bmp"} << "svg";
    QTest::newRow("no such test") << QStringList{"figure", example, "-o", "x.svg", "--test", "2"} << "test 2";
    QTest::newRow("unknown figure") << QStringList{"figure", example, "-o", "x.svg", "--figure", "pie"}
                                    << "deviation";
}

void ReportCommandTest::refusesWrongUsage() {
    QFETCH(const QStringList, arguments);
    QFETCH(const QString, says);
    const CliResult result = run(arguments);
    QCOMPARE(result.code, 2);
    QCOMPARE(result.out, QByteArray());
    QCOMPARE(result.err.count('\n'), 1);
    QVERIFY2(result.err.contains(says.toUtf8()), result.err.constData());
}

/// a in French and English is a.fr.pdf and a.en.pdf: the name of the report of a.fr.
void ReportCommandTest::noReportTakesTheNameOfAnother() {
    const QTemporaryDir folder;
    QFile file(example);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray one = file.readAll();
    for (const auto &[name, languages] :
         {std::pair{"a.palmer", R"(["fr", "en"])"}, std::pair{"a.fr.palmer", R"(["fr"])"}}) {
        QFile written(folder.filePath(name));
        QVERIFY(written.open(QIODevice::WriteOnly));
        QJsonObject test = QJsonDocument::fromJson(one).object();
        QJsonObject report = test["report"].toObject();
        report["languages"] = QJsonDocument::fromJson(languages).array();
        test["report"] = report;
        written.write(QJsonDocument(test).toJson());
    }
    const QStringList call{"report", folder.filePath("a.palmer"), folder.filePath("a.fr.palmer"), "-o",
                           folder.filePath("out")};
    const CliResult both = run(call);
    QCOMPARE(both.code, 2);
    QVERIFY2(both.err.contains("would both be written as") && !QFileInfo::exists(folder.filePath("out")),
             both.err.constData());
    QVERIFY(run(call + QStringList{"--language", "fr"}).code < 2);
    QCOMPARE(QDir(folder.filePath("out")).entryList(QDir::Files), (QStringList{"a.fr.pdf", "a.pdf"}));
}

void ReportCommandTest::saysWhatItCannotReadOrWrite() {
    const CliResult unreadable = run({"report", "missing.palmer", "-o", "x.pdf"});
    QCOMPARE(unreadable.code, 3);
    QVERIFY2(unreadable.err.startsWith("palmer-cli: missing.palmer: "), unreadable.err.constData());
    for (const QString &out : {QString("/missing-folder/r.pdf"), QString("/dev/full")}) {
        const CliResult unwritable = run({"report", example, "--language", "fr", "-o", out});
        QCOMPARE(unwritable.code, 3);
        QVERIFY2(unwritable.err.startsWith("palmer-cli: " + out.toUtf8()), unwritable.err.constData());
        QCOMPARE(unwritable.err.count('\n'), 1);
    }
    const QTemporaryDir folder;
    for (const QString &out : {QString("/dev/full"), folder.path(), folder.filePath("to come/")}) {
        const CliResult unwritable = run({"report", example, "--language", "fr,en", "-o", out});
        QCOMPARE(unwritable.code, 3);
        QVERIFY2(unwritable.err.startsWith("palmer-cli: " + out.toUtf8() + ": "), unwritable.err.constData());
    }
    QVERIFY(QDir(folder.path()).isEmpty());
}

void ReportCommandTest::drawsFigures_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("begins");
    QTest::newRow("SVG") << "f.svg" << QByteArray("<?xml");
    QTest::newRow("PDF") << "f.pdf" << QByteArray("%PDF-");
    QTest::newRow("PNG") << "f.png" << QByteArray("\x89PNG");
}

void ReportCommandTest::drawsFigures() {
    QFETCH(const QString, name);
    QFETCH(const QByteArray, begins);
    const QTemporaryDir folder;
    const QString out = folder.filePath(name);
    const CliResult result = run({"figure", example, "--figure", "deviation", "--test", "1", "-o", out});
    QCOMPARE(result.err, QByteArray());
    QCOMPARE(result.code, 0);
    QVERIFY(contents(out).startsWith(begins));
    if (name.endsWith(".png"))
        QCOMPARE(QImage(out).size(), QSize(2067, 1016)); // 175 × 86 mm at 300 dots per inch
}

void ReportCommandTest::figureSpeaksTheLanguageAskedFor() {
    const QTemporaryDir folder;
    run({"figure", example, "--language", "fr", "-o", folder.filePath("fr.svg")});
    run({"figure", example, "-o", folder.filePath("en.svg")});
    QVERIFY(contents(folder.filePath("fr.svg")).contains("Point visé"));
    QVERIFY(contents(folder.filePath("en.svg")).contains("Target position"));
}

QTEST_GUILESS_MAIN(ReportCommandTest)

#include "reportcommandtest.moc"
