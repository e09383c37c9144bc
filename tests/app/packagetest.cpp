// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

namespace {

const QString metainfoFile = PALMER_BINARY_DIR "/resources/io.github.palmer_metrology.Palmer.metainfo.xml";

QString textOf(const QString &name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(name));
    return QString::fromUtf8(file.readAll());
}

QString inSource(const QString &name) {
    return textOf(PALMER_SOURCE_DIR "/" + name);
}

} // namespace

// What packages are made of agrees with the sources.
class PackageTest : public QObject {
    Q_OBJECT

private slots:
    void versionStandsInOnePlace() {
        static const QRegularExpression newest("\n## ([^ ]+) - ([^ \n]+)\n");
        const auto match = newest.match(inSource("CHANGELOG.md"));
        QCOMPARE(match.captured(1), QString(PALMER_VERSION));
        QCOMPARE(match.captured(2), QString(PALMER_RELEASED));
        QVERIFY(inSource("debian/changelog").startsWith("palmer (" PALMER_VERSION "-"));
        QVERIFY(inSource("python/pyproject.toml").contains("\nversion = \"" PALMER_VERSION "\"\n"));
        QVERIFY(textOf(metainfoFile)
                    .contains("<release version=\"" PALMER_VERSION "\" date=\"" PALMER_RELEASED "\"/>"));
        for (const char *file :
             {"debian/rules", "debian/control", "resources/linux/palmer.mime.xml", "README.md"})
            QVERIFY2(!inSource(file).contains(PALMER_VERSION), file);
    }

    void stateTheirLicences() {
        QVERIFY(inSource("LICENSE").contains("GNU GENERAL PUBLIC LICENSE"));
        const QString copyright = inSource("debian/copyright");
        for (const char *licence : {"GPL-3.0-or-later", "OFL-1.1", "CC0-1.0"})
            QVERIFY2(copyright.contains(QString("\nLicense: ") + licence + '\n'), licence);
    }

    void desktopKnowsTheProgram() {
        const QString id = "io.github.palmer_metrology.Palmer";
        const QString desktop = inSource("resources/linux/" + id + ".desktop");
        const QString metainfo = textOf(metainfoFile);
        QVERIFY(metainfo.contains("<id>" + id + "</id>"));
        QVERIFY(metainfo.contains(">" + id + ".desktop<"));
        QVERIFY(inSource("app/palmer.cpp").contains("setDesktopFileName(QStringLiteral(\"" + id + "\"))"));
        static const QRegularExpression type("MimeType=([^;]+);");
        const QString mime = type.match(desktop).captured(1);
        QVERIFY(!mime.isEmpty());
        QVERIFY(metainfo.contains("<mediatype>" + mime + "</mediatype>"));
        QVERIFY(inSource("resources/linux/palmer.mime.xml").contains("type=\"" + mime + "\""));
        for (const char *key : {"GenericName", "Comment", "Keywords"})
            QVERIFY2(desktop.contains(QString('\n') + key + "[fr]="), key);
    }

    void appStreamAccepts() {
        const QString program = QStandardPaths::findExecutable("appstreamcli");
        if (program.isEmpty())
            QSKIP("appstreamcli is not installed");
        QProcess process;
        process.start(program, {"validate", "--pedantic", metainfoFile});
        QVERIFY(process.waitForFinished(patience));
        const QByteArray said = process.readAllStandardOutput() + process.readAllStandardError();
        QVERIFY2(process.exitCode() == 0, said);
    }

    // Each shell takes the file that asks palmer-cli.
    void shellsTakeTheCompletions_data() {
        QTest::addColumn<QString>("shell");
        for (const char *shell : {"bash", "zsh", "fish"})
            QTest::newRow(shell) << shell;
    }
    void shellsTakeTheCompletions() {
        QFETCH(const QString, shell);
        const QString file = PALMER_SOURCE_DIR "/resources/linux/completions/palmer-cli." + shell;
        QVERIFY(textOf(file).contains("palmer-cli --complete "));
        const QString program = QStandardPaths::findExecutable(shell);
        if (program.isEmpty())
            QSKIP("the shell is not installed");
        QProcess process;
        process.start(program, {"-n", file});
        QVERIFY(process.waitForFinished(patience));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError());
    }
};

QTEST_GUILESS_MAIN(PackageTest)
#include "packagetest.moc"
