// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace {

using namespace palmer::testdata;

const QString example = QStringLiteral(EXAMPLES "iso230-2-1988-example.palmer");
const QString imported = QStringLiteral(DATA "rtl/typical.rtl");

QByteArray output(const QString &program, const QStringList &arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(patience) || process.exitCode() != 0)
        qFatal("%s failed", qPrintable(program));
    return process.readAllStandardOutput();
}

} // namespace

/// A report as its recipient has it: nothing but the PDF.
class VerifyCommandTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_report = m_folder.filePath("report.pdf");
        const CliResult result = runCli({"report", example, "--language", "en", "-o", m_report});
        QVERIFY2(result.code == 0 || result.code == 1, result.err.constData());
    }

    /// A report made where fonts for all of its characters are installed, read where there is none, and the
    /// other way round: what was drawn from another font is no part of the proof, and all else is.
    void otherFontsChangeNothing() {
        QString text = QString::fromUtf8(contents(example));
        text.replace("\"machine\": {}", "\"machine\": {\"name\": \"立式加工中心 Ωμέγα Станок № 12 😀☃\"}");
        QCOMPARE(text.count("立式"), 1);
        const QString file = m_folder.filePath("fonts.palmer");
        write(file, text.toUtf8());
        const QString none = m_folder.filePath("fonts.conf");
        write(none,
              "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><cachedir>" +
                  m_folder.path().toUtf8() + "</cachedir></fontconfig>");
        const std::map<QString, QString> withoutFonts{{"FONTCONFIG_FILE", none}};
        const QString here = m_folder.filePath("here.pdf");
        const QString there = m_folder.filePath("there.pdf");
        QVERIFY(runCli({"report", file, "--language", "fr", "-o", here}).code < 2);
        QVERIFY(runCli({"report", file, "--language", "fr", "-o", there}, {}, withoutFonts).code < 2);
        for (const auto &[pdf, environment] :
             {std::pair{here, withoutFonts}, std::pair{there, std::map<QString, QString>{}}}) {
            const CliResult result = runCli({"verify", pdf}, {}, environment);
            QVERIFY2(result.code == 0, result.out.constData());
        }
        const QByteArray words = output("pdftotext", {here, "-"}); // the remark that names them
        QVERIFY2(words.contains("U+7ACB"), words.constData());
    }

    /// A report under another edition than the file's says in itself which.
    void viewsFollowToo() {
        const QString view = m_folder.filePath("view.pdf");
        const auto follows = [&](const QString &file, const char *edition) {
            const CliResult made =
                runCli({"report", file, "--language", "fr", "--edition", edition, "-o", view});
            QVERIFY2(made.code == 0 || made.code == 1, made.err.constData());
            const CliResult result = runCli({"verify", view});
            QVERIFY2(result.code == 0, result.out.constData());
            // The whole is the same: nothing of the view was left out when it was made again.
            QVERIFY2(result.out.contains("The whole PDF is the same, byte for byte."),
                     result.out.constData());
        };
        for (const char *edition :
             {"ISO 230-2:1988", "ISO 230-2:1997", "ISO 230-2:2014", "GB/T 17421.2-2016", "VDI"})
            follows(QStringLiteral(EXAMPLES "../../tests/data/report/limits-2006.palmer"), edition);
        for (const char *edition : {"ISO 230-4:1996", "ISO 230-4:2022"})
            follows(QStringLiteral(EXAMPLES "iso230-4-full-circles-xy.palmer"), edition);
    }

    void followsOrNot() {
        CliResult result = runCli({"verify", m_report});
        QCOMPARE(result.err, QByteArray());
        QCOMPARE(result.code, 0);
        QVERIFY2(
            result.out.startsWith("The numbers follow from the attached data. Where the data come from is "
                                  "not verified.\n"),
            result.out.constData());
        result = runCli({"verify", "--language", "fr", m_report});
        QVERIFY2(result.out.startsWith("Les nombres découlent des données jointes."), result.out.constData());

        // The whole of a page is another's: a page that is missing.
        const QString cut = m_folder.filePath("cut.pdf");
        output("qpdf", {m_report, "--pages", m_report, "1", "--", cut});
        result = runCli({"verify", cut});
        QCOMPARE(result.code, 1);
        QVERIFY2(result.out.contains("pages of the PDF: 1;"), result.out.constData());

        // Other bytes of the same pages: it follows, and the bytes are said to be others.
        const QString rewritten = m_folder.filePath("rewritten.pdf");
        output("qpdf", {"--linearize", m_report, rewritten});
        result = runCli({"verify", rewritten});
        QCOMPARE(result.code, 0);
        QVERIFY2(result.out.contains("The PDF was rewritten: "), result.out.constData());

        result = runCli({"verify", m_report, cut, example});
        QCOMPARE(result.code, 3); // the worst
        QVERIFY(result.out.contains(m_report.toUtf8() + "\nThe numbers follow"));
        QVERIFY2(result.err.contains("this is no PDF"), result.err.constData());
        QCOMPARE(runCli({"verify"}).code, 2);
    }

    void asJson() {
        const CliResult result = runCli({"verify", "--json", m_report});
        const QJsonObject object = QJsonDocument::fromJson(result.out).object();
        QCOMPARE(object["format"].toString(), "palmer verification");
        QCOMPARE(object["follows"].toBool(), true);
        QCOMPARE(object["identical"].toBool(), true);
        QCOMPARE(object["file"].toString(), m_report);
        QCOMPARE(object["madeBy"].toString().left(7), "Palmer ");
        QVERIFY(object["differences"].isArray() && object["signatures"].isArray());
        const QList<QByteArray> lines =
            runCli({"verify", "--json", m_report, m_report}).out.trimmed().split('\n');
        QCOMPARE(lines.size(), 2);
        QVERIFY(QJsonDocument::fromJson(lines.back()).isObject());
    }

    void theFingerprintIsThatOfTheAttachedFile() {
        // Once by our own program, once by another.
        const QString own = m_folder.filePath("own.palmer");
        QCOMPARE(runCli({"verify", m_report, "--extract", own}).code, 0);
        QTemporaryDir folder;
        output("pdfdetach", {"-saveall", "-o", folder.path(), m_report});
        const QStringList files = QDir(folder.path()).entryList({"*.palmer"}, QDir::Files);
        QCOMPARE(files.size(), 1);
        const QByteArray bytes = contents(folder.filePath(files.front()));
        QCOMPARE(contents(own), bytes);
        const QByteArray digits = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
        QByteArray text = output("pdftotext", {"-raw", m_report, "-"});
        text.replace(' ', "").replace('\n', "");
        QVERIFY2(text.contains("FingerprintSHA-256" + digits), digits.constData());
        const qsizetype pages = text.count("FingerprintSHA-256" + digits.left(16));
        QVERIFY(pages > 2); // every footer, and once in full
        QCOMPARE(pages, output("pdftotext", {m_report, "-"}).count('\f') + 1);
        QCOMPARE(runCli({"verify", m_report, "--extract", m_folder.filePath("own.pdf")}).code, 2);
    }

    void aReportIsAFileEverywhere() {
        const QString file = m_folder.filePath("from.palmer");
        QCOMPARE(runCli({"verify", m_report, "--extract", file}).code, 0);
        for (const QString command : {"evaluate", "check"}) {
            const CliResult fromFile = runCli({command, file});
            const CliResult fromReport = runCli({command, m_report});
            QCOMPARE(fromReport.code, fromFile.code);
            QCOMPARE(fromReport.out, fromFile.out);
            QCOMPARE(fromReport.err, fromFile.err);
        }
        const QString again = m_folder.filePath("again.pdf");
        QCOMPARE(runCli({"report", m_report, "--language", "en", "-o", again}).code, 0);
        QCOMPARE(contents(again), contents(m_report));
        QCOMPARE(runCli({"figure", m_report, "-o", m_folder.filePath("f.svg")}).code, 0);
        QCOMPARE(runCli({"export", m_report, "--as", "csv", "-o", m_folder.filePath("e.csv")}).code, 0);
        QCOMPARE(runCli({"evaluate", "-"}, contents(m_report)).code, runCli({"evaluate", file}).code);
        QCOMPARE(runCli({"import", m_report, "-o", m_folder.filePath("i.palmer")}).code, 3);
    }

    void resultsTravelWithThem() {
        QTemporaryDir folder;
        output("pdfdetach", {"-saveall", "-o", folder.path(), m_report});
        const QJsonObject attached =
            QJsonDocument::fromJson(contents(folder.filePath("results.json"))).object();
        const QJsonObject computed =
            QJsonDocument::fromJson(runCli({"evaluate", "--json", example}).out).object();
        QCOMPARE(attached["tests"], computed["tests"]);
        QCOMPARE(attached["program"], computed["program"]);
    }

    void originalsGoOutWhenAsked() {
        const QString test = m_folder.filePath("imported.palmer");
        QCOMPARE(runCli({"import", imported, "--accept", "-o", test}).code, 0);
        // The bytes of the instrument file, as the window keeps them.
        QJsonObject object = QJsonDocument::fromJson(contents(test)).object();
        QJsonArray tests = object["tests"].toArray();
        QJsonObject first = tests[0].toObject();
        QJsonArray imports = first["imports"].toArray();
        QJsonObject file = imports[0].toObject();
        file["data"] = QString::fromLatin1(contents(imported).toBase64());
        imports[0] = file;
        first["imports"] = imports;
        tests[0] = first;
        object["tests"] = tests;
        write(test, QJsonDocument(object).toJson());
        const auto attachedTo = [&](const QStringList &more) {
            const QString pdf = m_folder.filePath("o.pdf");
            const QString out = m_folder.filePath("o.palmer");
            const CliResult made = runCli(QStringList{"report", test, "--language", "fr", "-o", pdf} + more);
            if (made.code > 1)
                qFatal("%s", made.err.constData());
            if (runCli({"verify", pdf, "--extract", out}).code != 0 || runCli({"verify", pdf}).code != 0)
                qFatal("does not verify");
            return contents(out);
        };
        QVERIFY(!attachedTo({}).contains(contents(imported).toBase64().first(60)));
        QVERIFY(attachedTo({"--with-originals"}).contains(contents(imported).toBase64().first(60)));
    }

    void damagedFilesEndWithOneSentence() {
        const QByteArray pdf = contents(m_report);
        const QString file = m_folder.filePath("damaged.pdf");
        for (const qsizetype length : {qsizetype(8), pdf.size() / 2, pdf.size() - 10}) {
            write(file, pdf.first(length));
            for (const QString command : {"verify", "evaluate"}) {
                const CliResult result = runCli({command, file});
                QCOMPARE(result.code, 3);
                QCOMPARE(result.out, QByteArray());
                QVERIFY2(result.err.startsWith("palmer-cli: ") && result.err.count('\n') == 1,
                         result.err.constData());
            }
        }
        const CliResult missing = runCli({"verify", m_folder.filePath("none.pdf")});
        QCOMPARE(missing.code, 3);
    }

private:
    QTemporaryDir m_folder;
    QString m_report;
};

QTEST_GUILESS_MAIN(VerifyCommandTest)
#include "verifycommandtest.moc"
