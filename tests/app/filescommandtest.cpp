// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <csignal>
#include <functional>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace palmer::testdata;

const QString example = QStringLiteral(EXAMPLES "iso230-2-1988-example.palmer");
const QString measured = QStringLiteral(DATA "rtl/typical.rtl");

/// The program where no file may grow beyond `limit` bytes, as on a disk that fills up.
CliResult runWithin(qsizetype limit, const QStringList &arguments) {
    QProcess process;
    process.setChildProcessModifier([limit] {
        const rlimit most{static_cast<rlim_t>(limit), static_cast<rlim_t>(limit)};
        ::setrlimit(RLIMIT_FSIZE, &most);
    });
    process.start(QStringLiteral(PALMER_CLI), arguments);
    if (!process.waitForFinished(patience) || process.exitStatus() != QProcess::NormalExit)
        qFatal("palmer-cli did not end by itself");
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

/// What is written is written whole or not at all, and never over what is read.
class FilesCommandTest : public QObject {
    Q_OBJECT

private slots:
    void aFullDiskLeavesTheOldFile_data() {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<QString>("output");
        QTest::newRow("import") << QStringList{"import", measured, "--accept"} << "o.palmer";
        QTest::newRow("report") << QStringList{"report", example, "--language", "fr"} << "o.pdf";
        QTest::newRow("readings") << QStringList{"export", example, "--as", "csv"} << "o.csv";
        QTest::newRow("results") << QStringList{"export", example, "--as", "json"} << "o.json";
        QTest::newRow("figure") << QStringList{"figure", example} << "o.svg";
        QTest::newRow("plan") << QStringList{"targets", "--travel", "1000"} << "o.palmer";
    }

    void aFullDiskLeavesTheOldFile() {
        QFETCH(QStringList, command);
        QFETCH(QString, output);
        const QTemporaryDir folder;
        const QString file = folder.filePath(output);
        command += {"-o", file};
        QCOMPARE(runCli(command).code, 0);
        const qsizetype size = contents(file).size();
        const QByteArray before(30'000, 'o');
        std::vector<qsizetype> limits{size - 1, size, 40 * 1024};
        for (qsizetype limit = 0; limit < 40 * 1024; limit += 5003)
            limits.push_back(limit);
        for (const qsizetype limit : limits) {
            write(file, before);
            const CliResult result = runWithin(limit, command);
            const bool fits = limit >= size;
            QCOMPARE(result.code, fits ? 0 : 3);
            QCOMPARE(contents(file).size(), fits ? size : before.size());
            QVERIFY(fits || (contents(file) == before && result.err.contains(output.toUtf8() + ": ")));
            QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
        }
    }

    /// Of two languages both reports are new, or neither: whichever is the larger one.
    void twoLanguagesAreOneStep() {
        const QTemporaryDir folder;
        const QString out = folder.filePath("r.pdf");
        const std::array files{folder.filePath("r.fr.pdf"), folder.filePath("r.en.pdf")};
        for (const char *order : {"fr,en", "en,fr"}) {
            const QStringList command{"report", example, "--language", order, "-o", out};
            QCOMPARE(runCli(command).code, 0);
            const std::array sizes{contents(files[0]).size(), contents(files[1]).size()};
            QVERIFY(sizes[0] != sizes[1]); // so that a limit lies between
            const auto [small, large] = std::minmax(sizes[0], sizes[1]);
            for (const qsizetype limit :
                 {qsizetype(0), small - 1, small, (small + large) / 2, large - 1, large}) {
                for (const bool there : {true, false}) {
                    for (const QString &file : files) {
                        QFile::remove(file);
                        if (there)
                            write(file, "old");
                    }
                    const CliResult result = runWithin(limit, command);
                    QCOMPARE(result.code, limit >= large ? 0 : 3);
                    QCOMPARE(result.err.count('\n'), limit >= large ? 0 : 1);
                    for (std::size_t i = 0; i < 2; ++i) {
                        const QByteArray old = there ? "old" : "cannot be read";
                        if (limit >= large)
                            QCOMPARE(contents(files[i]).size(), sizes[i]);
                        else
                            QCOMPARE(contents(files[i]), old);
                    }
                    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(),
                             there || limit >= large ? 2 : 0);
                }
            }
        }
    }

    void neverOverItsInput_data() {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("name");
        const QStringList reporting{"report", "IN", "--language", "fr", "-o", "OUT", "--force"};
        QTest::newRow("report") << reporting << example << "t.palmer";
        QTest::newRow("import") << QStringList{"import", "IN", "-o", "OUT", "--force"} << measured << "d.csv";
        QTest::newRow("one of two inputs")
            << QStringList{"import", measured, "IN", "-o", "OUT", "--force"} << measured << "d.palmer";
        QTest::newRow("readings") << QStringList{"export", "IN", "--as", "csv", "-o", "OUT", "--force"}
                                  << example << "u.palmer";
        QTest::newRow("figure") << QStringList{"figure", "IN", "-o", "OUT"} << measured << "d.csv";
    }

    void neverOverItsInput() {
        QFETCH(QStringList, command);
        QFETCH(QString, source);
        QFETCH(QString, name);
        const QTemporaryDir folder;
        const QString input = folder.filePath(name);
        const QByteArray before = contents(source);
        write(input, before);
        const QString suffix = name.section('.', 1);
        const QString link = folder.filePath("link." + suffix);
        const QString hard = folder.filePath("hard." + suffix);
        QVERIFY(QFile::link(input, link));
        QCOMPARE(::link(input.toUtf8().constData(), hard.toUtf8().constData()), 0);
        for (const QString &output :
             {input, folder.path() + "/../" + QDir(folder.path()).dirName() + "/" + name, link, hard}) {
            QStringList words = command;
            words.replaceInStrings("IN", input);
            words.replaceInStrings("OUT", output);
            const CliResult result = runCli(words);
            QCOMPARE(result.code, 2);
            QCOMPARE(result.err.count('\n'), 1);
            QCOMPARE(contents(input), before);
            QVERIFY(QFileInfo(link).isSymLink());
        }
    }

    void neverOverOneOfTwoLanguages() {
        const QTemporaryDir folder;
        const QString input = folder.filePath("r.en.pdf"); // a test file under a name that deceives
        write(input, contents(example));
        const CliResult result =
            runCli({"report", input, "--language", "fr,en", "-o", folder.filePath("r.pdf"), "--force"});
        QCOMPARE(result.code, 2);
        QCOMPARE(contents(input), contents(example));
        QVERIFY(!QFile::exists(folder.filePath("r.fr.pdf"))); // nothing is half done
    }

    void anotherKindOfFileNeedsForce_data() {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<QStringList>("own");
        QTest::newRow("import") << QStringList{"import", measured, "--accept"} << QStringList{"palmer"};
        QTest::newRow("report") << QStringList{"report", example, "--language", "fr"} << QStringList{"pdf"};
        QTest::newRow("csv") << QStringList{"export", example, "--as", "csv"} << QStringList{"csv", "txt"};
        QTest::newRow("json") << QStringList{"export", example, "--as", "json"} << QStringList{"json"};
        QTest::newRow("compensation")
            << QStringList{"export", example, "--as", "compensation-csv"} << QStringList{"csv"};
        QTest::newRow("program") << QStringList{"targets", "--travel", "1000", "--program", "iso"}
                                 << QStringList{"nc", "txt"};
        QTest::newRow("plan") << QStringList{"targets", "--travel", "1000"} << QStringList{"palmer", "txt"};
    }

    void anotherKindOfFileNeedsForce() {
        QFETCH(QStringList, command);
        QFETCH(QStringList, own);
        const QTemporaryDir folder;
        const auto run = [&](const QString &name, const QStringList &more) {
            return runCli(command + QStringList{"-o", folder.filePath(name)} + more).code;
        };
        for (const QString ending : {"palmer", "csv", "pdf", "json", "nc", "xlsx", "svg", "PDF", "Palmer"}) {
            const bool isOwn = own.contains(ending.toLower());
            if (command[0] == "targets" && ending.toLower() == "pdf")
                continue; // a plan as PDF; a program needs an axis drawn no more than here
            if (command[0] == "import" && ending == "json")
                continue; // a test file is JSON
            for (const bool exists : {false, true}) {
                const QString name = (exists ? "there." : "new.") + ending;
                if (exists)
                    write(folder.filePath(name), "precious");
                QCOMPARE(run(name, {}), isOwn ? 0 : 2);
                if (!isOwn)
                    QCOMPARE(contents(folder.filePath(name)),
                             QByteArray(exists ? "precious" : "cannot be read"));
            }
        }
        QCOMPARE(run("forced.xlsx", {"--force"}), 0);
        QCOMPARE(run("free", {}), 0);
        QCOMPARE(run("free.v2", {}), 0);
        for (const QString &ending : own)
            QCOMPARE(run("own." + ending, {}), 0);
    }

    void devicesStayWhatTheyAre() {
        for (const char *output : {"-", "/dev/stdout"}) {
            const CliResult result = runCli({"export", example, "--as", "csv", "-o", output});
            QCOMPARE(result.code, 0);
            QVERIFY(result.out.size() > 1000);
        }
        const CliResult full = runCli({"export", example, "--as", "csv", "-o", "/dev/full"});
        QCOMPARE(full.code, 3);
        QCOMPARE(full.err.count('\n'), 1);
        QVERIFY(full.err.contains("the device is full"));
        QCOMPARE(runCli({"export", example, "--as", "csv", "-o", "/dev/null"}).code, 0);
        // A pipe, read by another program.
        const QTemporaryDir folder;
        const QString pipe = folder.filePath("pipe");
        QCOMPARE(::mkfifo(pipe.toUtf8().constData(), 0600), 0);
        // As a shell's redirection: whoever comes first waits for the other.
        QProcess writer;
        writer.start(PALMER_CLI, {"export", example, "--as", "csv", "-o", pipe});
        QVERIFY(writer.waitForStarted());
        QProcess reader;
        reader.start("cat", {pipe});
        QVERIFY(writer.waitForFinished(patience));
        QCOMPARE(writer.exitCode(), 0);
        QVERIFY(reader.waitForFinished());
        QVERIFY(reader.readAllStandardOutput().size() > 1000);
    }

    void onlyFilesAreRead() {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath("pipe.csv");
        QCOMPARE(::mkfifo(pipe.toUtf8().constData(), 0600), 0);
        const QString huge = folder.filePath("huge.csv");
        QFile hole(huge);
        QVERIFY(hole.open(QIODevice::WriteOnly) && hole.resize((qint64(1) << 28) + 1));
        for (const QString &file : {pipe, QString("/dev/zero"), QString("/dev/null"), folder.path(),
                                    QString("/proc/self/status"), QString("/proc/kmsg"), huge}) {
            for (const QStringList &command :
                 {QStringList{"evaluate", file}, QStringList{"check", file},
                  QStringList{"import", file, "-o", folder.filePath("x.palmer")},
                  QStringList{"export", file, "--as", "csv", "-o", folder.filePath("x.csv")},
                  QStringList{"report", file, "-o",
                              folder.filePath(file == folder.path() ? "reports" : "x.pdf")}}) {
                const CliResult result = runCli(command);
                QCOMPARE(result.code, 3);
                QCOMPARE(result.err.count('\n'), 1);
            }
        }
        QProcess endless;
        endless.setStandardInputFile("/dev/zero");
        endless.start(QStringLiteral(PALMER_CLI), {"evaluate", "-"});
        QVERIFY(endless.waitForFinished(patience)); // however busy the machine is
        QCOMPARE(endless.exitCode(), 3);
    }

    /// A link to itself, like a folder that may not be entered, says nothing about the file.
    void whatCannotBeReachedIsNotSaidToBeMissing() {
        const QTemporaryDir folder;
        const QString loop = folder.filePath("loop.palmer");
        QVERIFY(QFile::link(loop, loop));
        const CliResult result = runCli({"evaluate", loop});
        QCOMPARE(result.code, 3);
        QVERIFY2(result.err.contains("check its permissions"), result.err);
    }

    /// Damaged in every way, under every name, through every command that reads: never a table.
    void aDamagedTestFileIsNoTable() {
        const QTemporaryDir folder;
        const QByteArray file = contents(example);
        QByteArray wide;
        for (const char c : file.mid(file.indexOf('\n') + 1))
            wide += QByteArray{&c, 1} + QByteArray(1, '\0');
        QByteArray other = file;
        other.replace("palmer test report", "something else");
        QList<QByteArray> damaged{wide, "\xFF\xFE" + wide, "garbage\n" + file, "0;1\n100;2\n" + file, other};
        for (qsizetype cut = 1; cut < file.size(); cut += file.size() / 40)
            damaged << file.mid(cut) << file.first(cut);
        for (const char *name : {"x.palmer", "x.csv"}) {
            const QString path = folder.filePath(name);
            for (qsizetype i = 0; i < damaged.size(); ++i) {
                write(path, damaged[i]);
                const CliResult result = runCli({"evaluate", path});
                QVERIFY2(result.code == 3, qPrintable(QString::number(i) + result.out));
                QCOMPARE(result.err.count('\n'), 1);
                if (i >= 5)
                    continue;
                for (const QStringList &command :
                     {QStringList{"check", path}, QStringList{"import", path, "-o", folder.filePath("o")},
                      QStringList{"import", path, "--set", "format=table", "-o", folder.filePath("o")},
                      QStringList{"export", path, "--as", "csv", "-o", folder.filePath("o")},
                      QStringList{"report", path, "-o", folder.filePath("o")}})
                    QCOMPARE(runCli(command).code, 3);
                QVERIFY(!QFile::exists(folder.filePath("o")));
            }
        }
    }
};

QTEST_GUILESS_MAIN(FilesCommandTest)
#include "filescommandtest.moc"
