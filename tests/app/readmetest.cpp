// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/fewtrials.h"
#include "app/runcli.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace {

/// Links to the resources, but copies of the examples: their budgets are simulated with few trials.
bool laysResources(const QString &folder) {
    const QDir all(QStringLiteral(PALMER_SOURCE_DIR "/resources"));
    if (!QDir().mkpath(folder + "/examples"))
        return false;
    for (const QString &part : all.entryList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
        if (part != "examples" && !QFile::link(all.filePath(part), folder + '/' + part))
            return false;
    }
    int changed = 0;
    for (const QString &name : QDir(all.filePath("examples")).entryList(QDir::Files)) {
        QFile example(all.filePath("examples/" + name));
        QFile copy(folder + "/examples/" + name);
        if (!example.open(QIODevice::ReadOnly) || !copy.open(QIODevice::WriteOnly))
            return false;
        const QByteArray bytes = example.readAll();
        const QByteArray few = palmer::testdata::withFewTrials(bytes);
        changed += few == bytes ? 0 : 1;
        if (copy.write(few) != few.size())
            return false;
    }
    return changed >= 5;
}

} // namespace

/// What README and doc/ say to type works as it stands there, in their order.
class ReadmeTest : public QObject {
    Q_OBJECT

private slots:
    void everyCommandDoesWhatItSays();
};

void ReadmeTest::everyCommandDoesWhatItSays() {
    QByteArray text;
    for (const char *page :
         {"README.md", "doc/files.md", "doc/register.md", "doc/verification.md", "doc/scope.md"}) {
        QFile file(QStringLiteral(PALMER_SOURCE_DIR "/") + page);
        QVERIFY2(file.open(QIODevice::ReadOnly), page);
        const QByteArray bytes = file.readAll();
        QVERIFY(page != QByteArray("README.md") || bytes.count('\n') <= 150);
        text += bytes;
    }
    QTemporaryDir folder;
    for (const char *part : {"tests", "doc"})
        QVERIFY(QFile::link(QStringLiteral(PALMER_SOURCE_DIR "/") + part, folder.filePath(part)));
    QVERIFY(laysResources(folder.filePath("resources")));
    int commands = 0;
    const QString begin = "    build/release/bin/palmer-cli ";
    for (const QString &line : QString::fromUtf8(text).split('\n')) {
        if (!line.startsWith(begin))
            continue;
        ++commands;
        QProcess process;
        process.setWorkingDirectory(folder.path());
        process.start(QStringLiteral(PALMER_CLI), QProcess::splitCommand(line.mid(begin.size())));
        QVERIFY(process.waitForFinished(patience));
        const QByteArray errors = process.readAllStandardError();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit, qPrintable(line));
        // 1: a verdict other than "conforms", an unmet requirement.
        QVERIFY2(process.exitCode() <= 1, qPrintable(line + '\n' + QString::fromUtf8(errors)));
    }
    QVERIFY(commands > 15);
    for (const char *written : {"report.fr.pdf", "report.en.pdf", "deviation.svg", "x-axis.pdf",
                                "laser.palmer", "reports/rotary-axis.pdf", "figures/rotary-axis.svg",
                                "history.pdf", "certificate.xml", "certificate.pdf"})
        QVERIFY2(QFile::exists(folder.filePath(written)), written);
}

QTEST_GUILESS_MAIN(ReadmeTest)
#include "readmetest.moc"
