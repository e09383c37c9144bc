// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/documenterror.h"
#include "document/sha256.h"
#include "export/resultsjson.h"
#include "import/layouts/zipfile.h"
#include "print/pdf/writepdf.h"
#include "print/proof/pdfpages.h"
#include "proof/readreportpdf.h"
#include "report/attachedfile.h"
#include "report/composereport.h"
#include "ui/examples.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QTest>
#include <functional>

using namespace palmer;

namespace {

constexpr auto copied = "PALMER_TEST_COPY"; ///< set where this program lies without its library

QByteArray bytesOf(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray workbook() {
    return bytesOf(DATA "workbooks/cover-and-hidden.xlsx");
}

QByteArray reportPdf() {
    const EvaluatedDocument evaluated = testdata::evaluatedDocument(testdata::decidedExample());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(composeReport(evaluated, Language(Language::Id::english), {"Palmer", true, {}, {}}), buffer,
             attachedResults(evaluated));
    return buffer.data();
}

/// What is wrong when that is tried.
std::optional<Error> refusal(const std::function<void()> &attempt) {
    try {
        attempt();
    } catch (const Error &error) {
        return error;
    }
    return std::nullopt;
}

} // namespace

/// The programs without the libraries for PDF and workbooks: it loads them, or says that they are missing.
class LoadedFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void aStartDoesNotLoadThem_data() {
        QTest::addColumn<QString>("program");
        QTest::newRow("window") << PALMER;
        QTest::newRow("command line") << PALMER_CLI;
    }

    void aStartDoesNotLoadThem() {
        QFETCH(const QString, program);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("LD_TRACE_LOADED_OBJECTS", "1"); // the dynamic linker lists them
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(program, QStringList());
        QVERIFY(process.waitForFinished(-1));
        const QByteArray libraries = process.readAllStandardOutput();
        QVERIFY(libraries.contains("libQt6Gui"));
        for (const char *late : {"libqpdf", "libpoppler", "libzip", "libgnutls", "libnss3", "libcrypto"})
            QVERIFY2(!libraries.contains(late), late);
    }

    void sumsAreTheSame() {
        QCOMPARE(sha256("abc"),
                 "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"); // FIPS 180
        QCOMPARE(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        const QByteArray large(3 << 20, 'x'); // by the library, where it is there
        QCOMPARE(sha256(large),
                 QCryptographicHash::hash(large, QCryptographicHash::Sha256).toHex().toStdString());
    }

    void workbooksAreUnpacked() {
        if (qEnvironmentVariableIsSet(copied))
            QSKIP("without the library");
        const QByteArray bytes = workbook();
        const auto zip = openZip(bytes);
        QVERIFY(zip->contains("XL/workbook.xml"));
        class Names : public XmlHandler {
        public:
            void begin(const XmlElement &element) override { names << QString::fromUtf8(element.name); }
            void end(std::string_view) override {}
            void text(std::string_view) override {}
            QStringList names;
        } elements;
        zip->walk("nothing", elements);
        QVERIFY(elements.names.isEmpty());
        zip->walk("xl/workbook.xml", elements);
        QVERIFY(elements.names.contains("sheets"));
        const auto refused = refusal([&] { static_cast<void>(openZip(bytes.left(200))); });
        QVERIFY(refused && refused->kind == Error::Kind::content); // the sentence comes over, too
    }

    void reportsAreWrittenAndRead() {
        if (qEnvironmentVariableIsSet(copied))
            QSKIP("without the library");
        const QByteArray pdf = reportPdf();
        QVERIFY(!bytesOf("/proc/self/maps").contains("libpoppler")); // of no use for writing
        const ReportPdf read = readReportPdf(pdf);
        QVERIFY(read.testFile.contains("palmer"));
        QVERIFY(!read.results.isEmpty());
        const auto pages = openPages(pdf);
        QVERIFY(pages->count() > 0);
        QVERIFY(!pages->words(0).empty());
        QVERIFY(!pages->picture(0).isNull());
        QVERIFY(refusal([] { static_cast<void>(openPages("no PDF")); }));
    }

    /// A copy of this program, where there is none, of each thing that needs it says one sentence.
    void withoutThemOneSentence() {
        if (!qEnvironmentVariableIsSet(copied)) {
            const QTemporaryDir folder;
            const QString copy = folder.filePath("loadedformatstest");
            QVERIFY(QFile::copy(QCoreApplication::applicationFilePath(), copy));
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(copied, "1");
            QProcess process;
            process.setProcessEnvironment(environment);
            process.start(copy, {"withoutThemOneSentence", "sumsAreTheSame"});
            QVERIFY(process.waitForFinished(-1));
            QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
                     process.readAllStandardOutput());
            return;
        }
        const QByteArray zip = workbook();
        const QByteArray pdf = bytesOf(PALMER_SOURCE_DIR "/tests/fuzz/corpus/reportpdf/report.pdf");
        QVERIFY(!zip.isEmpty() && !pdf.isEmpty());
        const auto demand = [](const std::function<void()> &attempt, Error::Kind kind) {
            const auto refused = refusal(attempt);
            QVERIFY(refused.has_value());
            QCOMPARE(refused->kind, kind);
            QVERIFY(QByteArray(refused->what()).contains("install it again"));
        };
        demand([&] { static_cast<void>(openZip(zip)); }, Error::Kind::unreadable);
        demand([&] { static_cast<void>(readReportPdf(pdf)); }, Error::Kind::unreadable);
        demand([&] { static_cast<void>(openPages(pdf)); }, Error::Kind::unreadable);
        demand([&] { static_cast<void>(reportPdf()); }, Error::Kind::unwritable);
    }
};

QTEST_MAIN(LoadedFormatsTest)
#include "loadedformatstest.moc"
