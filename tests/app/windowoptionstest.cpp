// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include <QProcess>
#include <QProcessEnvironment>
#include <QTest>

/// `palmer` as it is started on a machine without a screen.
class WindowOptionsTest : public QObject {
    Q_OBJECT

private slots:
    void needsNoDisplay_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("locale");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("out"); // begins so
        QTest::addColumn<QString>("err");
        const QString english = "C.UTF-8";
        const QString french = "fr_FR.UTF-8";
        QTest::newRow("help") << QStringList{"--help"} << english << 0 << "palmer opens the window"
                              << "";
        QTest::newRow("help, short") << QStringList{"-h"} << english << 0 << "palmer opens the window"
                                     << "";
        QTest::newRow("help in French") << QStringList{"--help"} << french << 0 << "palmer ouvre la fenêtre"
                                        << "";
        QTest::newRow("version") << QStringList{"--version"} << english << 0 << "Palmer "
                                 << "";
        QTest::newRow("help behind a file")
            << QStringList{"x.palmer", "--help"} << english << 0 << "palmer opens the window"
            << "";
        QTest::newRow("help behind an option of Qt")
            << QStringList{"-style", "fusion", "--help"} << english << 0 << "palmer opens the window"
            << "";
        QTest::newRow("unknown option") << QStringList{"--jason"} << english << 2 << ""
                                        << "palmer: unknown option --jason";
        QTest::newRow("unknown short option") << QStringList{"-x", "--help"} << english << 2 << ""
                                              << "palmer: unknown option -x";
        QTest::newRow("unknown option in French") << QStringList{"--jason"} << french << 2 << ""
                                                  << "palmer: option inconnue --jason";
        QTest::newRow("no display") << QStringList{} << english << 3 << ""
                                    << "palmer: no display is there";
        QTest::newRow("no display for a file") << QStringList{"x.palmer"} << english << 3 << ""
                                               << "palmer: no display is there";
        QTest::newRow("a file whose name is an option") << QStringList{"--", "--help"} << english << 3 << ""
                                                        << "palmer: no display is there";
    }

    void needsNoDisplay() {
        QFETCH(QStringList, words);
        QFETCH(QString, locale);
        QFETCH(int, code);
        QFETCH(QString, out);
        QFETCH(QString, err);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char *name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"})
            environment.remove(name);
        environment.insert("LC_ALL", locale);
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(PALMER, words);
        QVERIFY(process.waitForFinished(patience));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        const QString printed = QString::fromUtf8(process.readAllStandardOutput());
        const QString said = QString::fromUtf8(process.readAllStandardError());
        QCOMPARE(process.exitCode(), code);
        QVERIFY2(out.isEmpty() ? printed.isEmpty() : printed.startsWith(out), qPrintable(printed));
        QVERIFY2(err.isEmpty() ? said.isEmpty() : said.startsWith(err) && said.count('\n') == 1,
                 qPrintable(said));
    }
};

QTEST_APPLESS_MAIN(WindowOptionsTest)
#include "windowoptionstest.moc"
