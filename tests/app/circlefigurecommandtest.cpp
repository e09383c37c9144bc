// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace palmer::testdata;

namespace {

palmer::testdata::CliResult run(const QStringList &arguments) {
    return runCli(arguments);
}

QByteArray arc(const char *sense) {
    QByteArray angles;
    QByteArray deviations;
    for (int i = 0; i < 120; ++i) {
        const double angle = 3.0 * (QByteArray(sense) == "clockwise" ? 120 - i : i);
        angles += (i ? "," : "") + QByteArray::number(angle);
        deviations += (i ? "," : "") + QByteArray::number(0.004 * std::cos(angle / 28.6), 'f', 9);
    }
    return QByteArray(R"({"sense": ")") + sense + R"(", "angles": [)" + angles +
           R"(], "radialDeviations": [)" + deviations + "]}";
}

QByteArray file(const QByteArray &arcs) {
    return R"({"format": "palmer test report", "version": 1, "tests": [{"kind": "circular",
        "edition": "ISO 230-4:2005", "plane": {"first": "Z", "second": "X"}, "nominalRadius": 100, "arcs": [)" +
           arcs + "]}]}";
}

} // namespace

/// The figures of circular tests on the command line.
class CircleFigureCommandTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        write("both.palmer", file(arc("counterclockwise") + "," + arc("clockwise")));
        write("one.palmer", file(arc("clockwise")));
    }

    void drawsTheFigureAskedFor_data() {
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArrayList>("with");
        QTest::addColumn<QByteArrayList>("without");
        QTest::newRow("that of the test")
            << QStringList{} << QByteArrayList{"ZX", "XZ", "minimum zone, G(b)"} << QByteArrayList{};
        QTest::newRow("combined") << QStringList{"--figure", "circle"} << QByteArrayList{"ZX", "XZ"}
                                  << QByteArrayList{};
        QTest::newRow("counterclockwise") << QStringList{"--figure", "counterclockwise"}
                                          << QByteArrayList{"anticlockwise, ZX"} << QByteArrayList{"XZ"};
        QTest::newRow("diagnosis") << QStringList{"--figure", "diagnosis"}
                                   << QByteArrayList{"measured, anticlockwise ZX", "measured, clockwise XZ",
                                                     "synthetic: ", "stroke-dasharray"}
                                   << QByteArrayList{"minimum zone"};
        QTest::newRow("diagnosis in French") << QStringList{"--figure", "diagnosis", "--language", "fr"}
                                             << QByteArrayList{"mesuré, sens horaire XZ", "synthétique"}
                                             << QByteArrayList{"measured", "synthetic"};
        QTest::newRow("clockwise in French")
            << QStringList{"--figure", "clockwise", "--language", "fr"}
            << QByteArrayList{"sens horaire, XZ", "zone minimale, G", "point de départ"}
            << QByteArrayList{"ZX", "minimum"};
    }

    void drawsTheFigureAskedFor() {
        QFETCH(const QStringList, more);
        QFETCH(const QByteArrayList, with);
        QFETCH(const QByteArrayList, without);
        const QString out = m_folder.filePath("figure.svg");
        const palmer::testdata::CliResult result =
            run(QStringList{"figure", m_folder.filePath("both.palmer"), "-o", out} + more);
        QCOMPARE(result.err, QByteArray());
        QCOMPARE(result.code, 0);
        const QByteArray svg = contents(out);
        for (const QByteArray &text : with)
            QVERIFY2(svg.contains(text), text);
        for (const QByteArray &text : without)
            QVERIFY2(!svg.contains(text), text);
    }

    void writesEveryFormat() {
        for (const auto &[name, begins] :
             {std::pair("f.pdf", QByteArray("%PDF-")), std::pair("f.png", QByteArray("\x89PNG")),
              std::pair("f.svg", QByteArray("<?xml"))}) {
            const palmer::testdata::CliResult result =
                run({"figure", m_folder.filePath("both.palmer"), "-o", m_folder.filePath(name)});
            QCOMPARE(result.code, 0);
            QVERIFY(contents(m_folder.filePath(name)).startsWith(begins));
        }
    }

    void theDiagnosisIsWrittenInEveryFormat() {
        for (const auto &[name, begins] :
             {std::pair("d.pdf", QByteArray("%PDF-")), std::pair("d.png", QByteArray("\x89PNG")),
              std::pair("d.csv", QByteArray("# Measured and synthetic path"))}) {
            const palmer::testdata::CliResult result =
                run({"figure", m_folder.filePath("both.palmer"), "--figure", "diagnosis", "-o",
                     m_folder.filePath(name)});
            QCOMPARE(result.err, QByteArray());
            QCOMPARE(result.code, 0);
            QVERIFY(contents(m_folder.filePath(name)).startsWith(begins));
        }
    }

    void aPositioningTestHasNoDiagnosis() {
        const palmer::testdata::CliResult result =
            run({"figure", EXAMPLES "iso230-2-1988-example.palmer", "--figure", "diagnosis", "-o",
                 m_folder.filePath("x.svg")});
        QCOMPARE(result.code, 2);
        QVERIFY2(result.err.contains("the test 1 has no figure diagnosis"), result.err);
    }

    void saysWhichFigureATestDoesNotHave_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("figure");
        QTest::newRow("a sense that was not measured") << "one.palmer"
                                                       << "counterclockwise";
        QTest::newRow("that of a positioning test") << "both.palmer"
                                                    << "deviation";
    }

    void saysWhichFigureATestDoesNotHave() {
        QFETCH(const QString, file);
        QFETCH(const QString, figure);
        const palmer::testdata::CliResult result =
            run({"figure", m_folder.filePath(file), "--figure", figure, "-o", m_folder.filePath("x.svg")});
        QCOMPARE(result.code, 2);
        QVERIFY2(result.err.contains(figure.toUtf8()), result.err);
        QVERIFY(!QFile::exists(m_folder.filePath("x.svg")));
    }

    void aCircleIsNoFigureOfAPositioningTest() {
        const palmer::testdata::CliResult result =
            run({"figure", EXAMPLES "iso230-2-1988-example.palmer", "--figure", "circle", "-o",
                 m_folder.filePath("x.svg")});
        QCOMPARE(result.code, 2);
        QVERIFY2(result.err.contains("circle"), result.err);
    }

private:
    void write(const QString &name, const QByteArray &bytes) {
        QFile out(m_folder.filePath(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(bytes);
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(CircleFigureCommandTest)

#include "circlefigurecommandtest.moc"
