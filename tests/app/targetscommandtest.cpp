// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace {

palmer::testdata::CliResult run(const QStringList &arguments) {
    return palmer::testdata::runCli(arguments);
}

} // namespace

/// palmer-cli targets
class TargetsCommandTest : public QObject {
    Q_OBJECT

private slots:
    void printsThePlan() {
        const palmer::testdata::CliResult result = run(
            {"targets", "--travel", "1000", "--period", "10", "--seed", "7", "--language", "en", "-o", "-"});
        QCOMPARE(result.code, 0);
        QVERIFY(result.out.contains(
            "264.486")); // 1 + 244.5 + 18.986: the beginning, an interval, and up to 2 · 10
        const palmer::testdata::CliResult french =
            run({"targets", "--travel", "1000", "--language", "fr", "-o", "-"});
        QVERIFY(french.out.contains(QByteArray("Axe")));
    }

    void theRunsAreThoseAskedFor_data() {
        QTest::addColumn<QStringList>("asked");
        QTest::addColumn<QList<int>>("runs");
        QTest::newRow("as the standard asks") << QStringList{"--travel", "500"} << QList{5};
        QTest::newRow("fewer") << QStringList{"--travel", "500", "--runs", "3"} << QList{3};
        QTest::newRow("long axis") << QStringList{"--travel", "3000"} << QList{1, 5};
        QTest::newRow("long axis, more") << QStringList{"--travel", "3000", "--runs", "7"} << QList{7, 7};
    }
    void theRunsAreThoseAskedFor() {
        QFETCH(QStringList, asked);
        QFETCH(QList<int>, runs);
        const QByteArray json = run(QStringList{"targets", "--json"} + asked).out;
        QList<int> planned;
        for (const QJsonValue &one : QJsonDocument::fromJson(json).object()["measurements"].toArray())
            planned << one["runs"].toInt();
        QCOMPARE(planned, runs);
    }

    void writesThePartProgram() {
        for (const char *dialect : {"iso", "siemens", "heidenhain", "linuxcnc", "haas"}) {
            const palmer::testdata::CliResult result =
                run({"targets", "--axis", "Y", "--travel", "500", "--feed", "2000", "--dwell", "3,5",
                     "--cycle", "step", "--program", dialect, "-o", "-"});
            QCOMPARE(result.code, 0);
            QVERIFY(result.out.contains("M30"));
            QVERIFY(result.out.contains("3.5"));
        }
    }

    void writesATestFileToFillIn() {
        QTemporaryDir folder;
        const QString file = folder.filePath("plan.palmer");
        QCOMPARE(run({"targets", "--axis", "C", "--rotary", "--travel", "360", "-o", file}).code, 0);
        const palmer::testdata::CliResult checked = run({"evaluate", "--json", file});
        QCOMPARE(checked.code, 0);
        QVERIFY(checked.out.contains("\"ISO 230-2:2014\""));
        QVERIFY(checked.out.contains("\"deg\""));
    }

    /// Quarter turns of more than a turn, five times each way: what `check` asks of the same edition.
    void plansRotaryAxesAfter1988_data() {
        QTest::addColumn<QString>("travel");
        QTest::newRow("a turn") << "360";
        QTest::newRow("two turns") << "720";
    }
    void plansRotaryAxesAfter1988() {
        QFETCH(QString, travel);
        const QStringList asked{"targets",   "--axis",         "C",          "--rotary", "--travel", travel,
                                "--edition", "ISO 230-2:1988", "--language", "en",       "-o"};
        const palmer::testdata::CliResult plan = run(asked + QStringList{"-"});
        QCOMPARE(plan.code, 0);
        QVERIFY2(plan.out.contains("all multiples of 90°"), plan.out.constData());
        for (const char *untrue : {"Nominal interval", "Random part", "2006"})
            QVERIFY2(!plan.out.contains(untrue), plan.out.constData());
        QTemporaryDir folder;
        const QString file = folder.filePath("plan.palmer");
        QCOMPARE(run(asked + QStringList{file}).code, 0);
        const palmer::testdata::CliResult checked = run({"check", "--language", "en", file});
        for (const char *unmet : {"missing: 0°", "5 each way are required", "Fewer than three further"})
            QVERIFY2(!checked.out.contains(unmet), checked.out.constData());
    }

    /// Plans for a test of a file as the window does; options override what the test states.
    void plansForATest() {
        const QStringList asked{"targets", EXAMPLES "long-axis-with-zone.palmer", "--language", "en", "-o",
                                "-"};
        const palmer::testdata::CliResult zone = run(asked);
        QCOMPARE(zone.code, 0);
        for (const char *line :
             {"2\u202f000\u00a0mm to 4\u202f000\u00a0mm", "10\u202f000\u00a0mm/min", "2302"})
            QVERIFY2(zone.out.contains(line), line);
        const palmer::testdata::CliResult whole =
            run(asked + QStringList{"--range", "0:6000", "--seed", "7"});
        QCOMPARE(whole.code, 0);
        QVERIFY(whole.out.contains("Full test of a zone"));
        QVERIFY(whole.out.contains("2\u202f000\u00a0mm to 4\u202f000\u00a0mm") &&
                !whole.out.contains("2302"));
    }

    void writesAPdf() {
        QTemporaryDir folder;
        QCOMPARE(run({"targets", "--travel", "1000", "-o", folder.filePath("plan.pdf")}).code, 0);
        QFile pdf(folder.filePath("plan.pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        QVERIFY(pdf.readAll().startsWith("%PDF-"));
    }

    void refusesWhatMakesNoPlan_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no travel") << QStringList{"-o", "-"};
        QTest::newRow("no file to write") << QStringList{"--travel", "1000"};
        QTest::newRow("a travel that is no number") << QStringList{"--travel", "far", "-o", "-"};
        QTest::newRow("a negative travel") << QStringList{"--travel", "-1", "-o", "-"};
        QTest::newRow("too many targets") << QStringList{"--travel", "1e9", "-o", "-"};
        QTest::newRow("targets that cannot be told apart")
            << QStringList{"--travel", "2", "--decimals", "0", "-o", "-"};
        QTest::newRow("an unknown dialect") << QStringList{"--travel", "9", "--program", "basic", "-o", "-"};
        QTest::newRow("an unknown cycle") << QStringList{"--travel", "9", "--cycle", "round", "-o", "-"};
        QTest::newRow("an edition for circles")
            << QStringList{"--travel", "9", "--edition", "ISO 230-4:2005", "-o", "-"};
        QTest::newRow("an axis no control knows")
            << QStringList{"--travel", "9", "--axis", "X axis", "--program", "iso", "-o", "-"};
        QTest::newRow("an axis with a number where the dialect has none")
            << QStringList{"--travel", "9", "--axis", "X1", "--program", "haas", "-o", "-"};
        QTest::newRow("two files") << QStringList{"x.palmer", "y.palmer", "-o", "-"};
        QTest::newRow("a circular test")
            << QStringList{EXAMPLES "iso230-4-full-circles-xy.palmer", "-o", "-"};
        QTest::newRow("a test there is not")
            << QStringList{EXAMPLES "one-direction.palmer", "--test", "3", "-o", "-"};
        for (const char *zone : {"2000:4000", "-100:1900", "1999:3001"})
            QTest::newRow(qPrintable(QString("a zone beyond the axis ") + zone))
                << QStringList{"--travel", "3000", QString("--zone=") + zone, "-o", "-"};
        for (const char *output : {"-", "/dev/stdout"})
            QTest::newRow(qPrintable(QString("two programs into one: ") + output))
                << QStringList{"--travel", "3000", "--program", "iso", "-o", output};
        QTest::newRow("a zone of a short axis") << QStringList{"--travel", "9", "--zone", "1:2", "-o", "-"};
    }
    void refusesWhatMakesNoPlan() {
        QFETCH(QStringList, arguments);
        const palmer::testdata::CliResult result = run(QStringList{"targets"} + arguments);
        QCOMPARE(result.code, 2);
        QVERIFY(result.out.isEmpty());
        QCOMPARE(result.err.count('\n'), 1);
    }

    void saysWhenItCannotWrite() {
        const palmer::testdata::CliResult result =
            run({"targets", "--travel", "1000", "-o", "/nowhere/plan.txt"});
        QCOMPARE(result.code, 3);
        QCOMPARE(result.err.count('\n'), 1);
    }
};

QTEST_GUILESS_MAIN(TargetsCommandTest)
#include "targetscommandtest.moc"
