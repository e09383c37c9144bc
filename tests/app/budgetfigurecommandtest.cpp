// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer::testdata;

namespace {

palmer::testdata::CliResult run(const QStringList &arguments) {
    return runCli(arguments);
}

} // namespace

/// The bars of a budget and the curve of a drift test on the command line.
class BudgetFigureCommandTest : public QObject {
    Q_OBJECT

private slots:
    void drawsTheBars_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QByteArrayList>("texts");
        QTest::newRow("in English") << "en"
                                    << QByteArrayList{"Coefficient of expansion of the machine", "9.18", "89",
                                                      "Improve first", "k = 2"};
        QTest::newRow("in French") << "fr"
                                   << QByteArrayList{"Coefficient de dilatation de la machine", "9,18", "89",
                                                     "améliorer"};
    }

    void drawsTheBars() {
        QFETCH(QString, language);
        QFETCH(QByteArrayList, texts);
        const QString out = m_folder.filePath("budget.svg");
        const palmer::testdata::CliResult result = run({"figure", DOCUMENTS "budget-2006.palmer", "--figure",
                                                        "budget", "--language", language, "-o", out});
        QCOMPARE(result.err, QByteArray());
        QCOMPARE(result.code, 0);
        const QByteArray svg = contents(out);
        for (const QByteArray &text : texts)
            QVERIFY2(svg.contains(text), text.constData());
    }

    void everyKindOfFile() {
        for (const char *ending : {"png", "pdf"}) {
            const QString out = m_folder.filePath(QString("budget.") + ending);
            QCOMPARE(run({"figure", DOCUMENTS "budget-2006.palmer", "--figure", "budget", "-o", out}).code,
                     0);
            QVERIFY(contents(out).size() > 1000);
        }
    }

    void noBudgetIsWrongUsage() {
        const QString out = m_folder.filePath("none.svg");
        const palmer::testdata::CliResult result =
            run({"figure", EXAMPLES "iso230-2-1988-example.palmer", "--figure", "budget", "-o", out});
        QCOMPARE(result.code, 2);
        QVERIFY2(result.err.contains("no figure budget"), result.err.constData());
        QVERIFY(!QFile::exists(out));
    }

    void aDriftTestHasItsCurve() {
        const QString file = m_folder.filePath("drift.palmer");
        QFile data(file);
        QVERIFY(data.open(QIODevice::WriteOnly));
        data.write(R"({"format": "palmer test report", "version": 1, "tests": [{"kind": "drift", "id": "d1",
            "axis": {"name": "X", "motion": "linear"}, "times": [0, 60, 120], "deviations": [0, 0.0032, 0.001]}]})");
        data.close();
        const QString out = m_folder.filePath("drift.svg");
        const palmer::testdata::CliResult result = run({"figure", file, "--language", "en", "-o", out});
        QCOMPARE(result.err, QByteArray());
        QCOMPARE(result.code, 0);
        QVERIFY(contents(out).contains("Deviation at rest"));
        QCOMPARE(run({"figure", file, "--figure", "budget", "-o", out}).code, 2);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_APPLESS_MAIN(BudgetFigureCommandTest)
#include "budgetfigurecommandtest.moc"
