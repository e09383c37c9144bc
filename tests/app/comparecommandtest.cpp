// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

using palmer::testdata::runCli;

namespace {

const QString both = EXAMPLES "x-axis-as-found-as-left.palmer";

QJsonObject jsonOf(QStringList words) {
    return QJsonDocument::fromJson(runCli(QStringList{"compare", both, both, "--json"} + words).out).object();
}

QJsonObject parameter(const QJsonObject &comparison, const char *id) {
    for (const QJsonValue &value : comparison["parameters"].toArray()) {
        if (value["id"] == QLatin1StringView(id))
            return value.toObject();
    }
    return {};
}

} // namespace

class CompareCommandTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatHasChanged();
    void aFileStatesWhatItCompares();
    void theEarlierTestIsTheFirst();
    void notStatedIsNotAlike();
    void theWordsAreExplained();
    void whatDiffersIsSaid();
    void circlesAreComparedBySourcesAndPaths();
    void printsItInBothLanguages();
    void itsJsonIsThatOfItsSchema();
    void findsTheLikeInTheOtherFile();
    void refusesWhatCannotBeMeant();
};

void CompareCommandTest::saysWhatHasChanged() {
    const QJsonObject comparison = jsonOf({"--test", "1,2"});
    QCOMPARE(comparison["cycles"].toInt(), 5);
    QCOMPARE(comparison["commonTargets"].toInt(), 11);
    QVERIFY(comparison["simulated"].toBool() && comparison["refusal"].isNull());
    QCOMPARE(comparison["shared"].toArray().size(), 5); // all but the misalignment
    QCOMPARE(parameter(comparison, "E")["word"].toString(), "better");
    QCOMPARE(runCli({"compare", both, both, "--test", "1,2"}).code, 1);
    QCOMPARE(runCli({"compare", both, both, "--test", "1"}).code, 0); // with itself
    const QJsonObject laboratories = jsonOf({"--test", "1,2", "--laboratories"});
    QCOMPARE(laboratories["refusal"].toString(), "sharedInstrument");
    const QJsonObject agreed = jsonOf({"--test", "1", "--tolerance", "20"});
    QCOMPARE(agreed["tolerance"].toDouble(), 0.02);
    QCOMPARE(parameter(agreed, "B")["word"].toString(), "unchangedWithin");
    // What is not proven, or not judged for want of targets, is no success.
    QCOMPARE(runCli({"compare", both, both, "--test", "1", "--tolerance", "0.1"}).code, 1);
    const QTemporaryDir folder;
    const QString few = folder.filePath("few.palmer");
    QCOMPARE(runCli({"synthesize", "positioning", "--targets", "4", "--noise", "1", "-o", few}).code, 0);
    QCOMPARE(runCli({"compare", few, few, "--test", "1"}).code, 1);
}

void CompareCommandTest::aFileStatesWhatItCompares() {
    const QJsonObject stated = QJsonDocument::fromJson(runCli({"compare", both, "--json"}).out).object();
    QCOMPARE(stated, jsonOf({"--test", "1,2"}));
    // The results of the file say it, too, key by key, and so does the terminal.
    const QJsonArray tests =
        QJsonDocument::fromJson(runCli({"evaluate", both, "--json"}).out).object()["tests"].toArray();
    QVERIFY(!tests[0].toObject().contains("comparison"));
    const QJsonObject comparison = tests[1].toObject()["comparison"].toObject();
    QCOMPARE(comparison["test"].toString(), "found");
    QCOMPARE(comparison["word"].toString(), "better");
    QVERIFY(comparison["isBefore"].toBool());
    // format, version, program, both sides, axis and plane less; test and isBefore more
    QCOMPARE(comparison.size(), stated.size() - 7 + 2);
    for (const QString &key : comparison.keys()) {
        if (key != "test" && key != "isBefore")
            QCOMPARE(comparison[key], stated[key]);
    }
    const QByteArray terminal = runCli({"evaluate", both, "--language", "en"}).out;
    for (const char *words : {"Comparison of two tests", "CHANGED, BETTER", "Parts of U (µm), each alone"})
        QVERIFY2(terminal.contains(words), words);
    // A terminal shows no figure, nor the numbers of its axes.
    for (const QByteArray &shown : {terminal, runCli({"compare", both, "--language", "en"}).out})
        QVERIFY(!shown.contains("Difference of the mean deviations") && !shown.contains("before (µm)"));
}

/// Whichever of the two states the other: in the report, in the results and here.
void CompareCommandTest::theEarlierTestIsTheFirst() {
    const QTemporaryDir folder;
    QFile file(both);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
    QJsonArray tests = document["tests"].toArray();
    QJsonObject found = tests[0].toObject();
    QJsonObject left = tests[1].toObject();
    QJsonObject stated = left.take("comparedWith").toObject();
    stated["test"] = left["id"];
    found["comparedWith"] = stated;
    document["tests"] = QJsonArray{found, left};
    QFile other(folder.filePath("other.palmer"));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(QJsonDocument(document).toJson());
    other.close();
    const QJsonObject comparison =
        QJsonDocument::fromJson(runCli({"compare", other.fileName(), "--json"}).out).object();
    QCOMPARE(comparison["before"]["id"].toString(), "found");
    QCOMPARE(parameter(comparison, "E")["word"].toString(), "better");
    const char *const reversed = "the second test was made before the first";
    for (const auto &[pair, isReversed] : {std::pair{"1,2", false}, std::pair{"2,1", true}}) {
        const QByteArray text =
            runCli({"compare", both, both, "--test", pair, "--language", "en"}).out.simplified();
        QCOMPARE(text.contains(reversed), isReversed);
    }
}

void CompareCommandTest::notStatedIsNotAlike() {
    const QTemporaryDir folder;
    QFile made(folder.filePath("made.palmer"));
    QCOMPARE(runCli({"synthesize", "positioning", "--noise", "1", "-o", made.fileName()}).code, 0);
    QVERIFY(made.open(QIODevice::ReadOnly));
    QFile other(folder.filePath("other.palmer"));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(made.readAll().replace("Made by computation", "Made by hand"));
    other.close();
    const QByteArray text =
        runCli({"compare", made.fileName(), other.fileName(), "--language", "en"}).out.simplified();
    QVERIFY2(text.contains("Alike: ") && text.contains("Target positions, Runs"), text);
    for (const char *name : {"Correction to 20", "Cycle"})
        QVERIFY2(!text.contains(name), text);
}

void CompareCommandTest::theWordsAreExplained() {
    const auto said = [](const QStringList &words) {
        return QString::fromUtf8(runCli(QStringList{"compare", both, both, "--language", "en"} + words).out)
            .simplified();
    };
    QVERIFY(said({"--test", "1,2"}).contains("“Changed” where the difference exceeds its U"));
    const QString agreed = said({"--test", "1,2", "--tolerance", "5"});
    QVERIFY(agreed.contains("Unchanged within t where difference and U together are at most t"));
    QVERIFY(!agreed.contains("“Changed”"));
    const QTemporaryDir folder; // another laboratory: another instrument
    QFile file(both);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QFile other(folder.filePath("other.palmer"));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(file.readAll().replace(R"("serialNumber": "00000")", R"("serialNumber": "00001")"));
    other.close();
    const QString laboratories = QString::fromUtf8(runCli({"compare", both, other.fileName(), "--test", "1,1",
                                                           "--laboratories", "--language", "en"})
                                                       .out)
                                     .simplified();
    QVERIFY2(laboratories.contains("E_n (ISO/IEC 17043): difference over its U"), qPrintable(laboratories));
    QVERIFY(!laboratories.contains("“Changed”"));
}

/// A statement that differs is not called alike, and the page says above the result what it compares.
void CompareCommandTest::whatDiffersIsSaid() {
    const QTemporaryDir folder;
    QFile file(both);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    int made = 0;
    const auto said = [&](const char *from, const char *to) {
        QByteArray changed = bytes;
        const qsizetype at = changed.lastIndexOf(from); // in the second test
        if (at < 0)
            return QString();
        changed.replace(at, qstrlen(from), to);
        QFile other(folder.filePath(QString::number(++made) + ".palmer"));
        if (!other.open(QIODevice::WriteOnly))
            return QString();
        other.write(changed);
        other.close();
        return QString::fromUtf8(
                   runCli({"compare", both, other.fileName(), "--test", "1,2", "--language", "en"}).out)
            .simplified();
    };
    struct Change {
        const char *from, *to, *words;
    };
    for (const auto &[from, to, words] :
         {Change{"601.11", "604.11", "11, not in the other test: 604.11 mm"},
          Change{R"("machine": 11.5)", R"("machine": 12.5)", "α machine 11.5 µm/(m·°C) 12.5 µm/(m·°C)"},
          Change{R"("environmentalVariation": 1.0)", R"("environmentalVariation": 2.0)",
                 "Uncertainty budget"},
          Change{R"("travel": 1600.0)", R"("travel": 1700.0)", "Axis travel 1 600 mm 1 700 mm"},
          Change{R"("position": "table")", R"("position": "column")", "Machine, column"}}) {
        const QString text = QString(said(from, to)).replace(QChar(0x202f), ' ').replace(QChar(0xa0), ' ');
        const QString above = text.left(text.indexOf("Alike:"));
        QVERIFY2(above.contains(words), qPrintable(QString(from) + '\n' + text));
    }
    const QString text = said("601.11", "604.11");
    for (const char *words : {"Positioning test of the X axis · ISO 230-2:2006",
                              "10 common targets; the first 5 cycles of each test"})
        QVERIFY2(text.contains(words), words);
}

void CompareCommandTest::circlesAreComparedBySourcesAndPaths() {
    const QString circles = EXAMPLES "iso230-4-full-circles-xy.palmer";
    const QJsonObject same =
        QJsonDocument::fromJson(runCli({"compare", circles, circles, "--test", "1", "--json"}).out).object();
    QCOMPARE(same["conditions"].toArray().size(), 0);
    QVERIFY(same["sources"].toArray().size() > 5);
    QCOMPARE(same["paths"].toArray().size(), 2);
    for (const auto &source : same["sources"].toArray())
        QCOMPARE(source.toObject()["difference"].toDouble(), 0.0);
    // A backlash 2 µm larger, of which both circles know more than that.
    const QTemporaryDir folder;
    for (const char *backlash : {"4", "6"})
        QCOMPARE(runCli({"synthesize", "circular", "--source", QString("backlash:X=%1").arg(backlash),
                         "--noise", "0.1", "-o", folder.filePath(QString("%1.palmer").arg(backlash))})
                     .code,
                 0);
    const QJsonObject worse =
        QJsonDocument::fromJson(
            runCli({"compare", folder.filePath("4.palmer"), folder.filePath("6.palmer"), "--json"}).out)
            .object();
    const auto found = worse["sources"].toArray();
    const auto backlash =
        std::ranges::find_if(found, [](const auto &source) { return source.toObject()["id"] == "backlash"; });
    QVERIFY(backlash != found.end());
    const double u = backlash->toObject()["expandedUncertainty"].toDouble();
    QVERIFY(u > 0 && u < 0.2);
    QVERIFY(std::abs(backlash->toObject()["difference"].toDouble() - 2) < 2 * u);
    // Words found for axes are not said of circles.
    QFile file(circles);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonObject root = QJsonDocument::fromJson(file.readAll()).object();
    QJsonArray tests = root["tests"].toArray();
    QJsonObject first = tests[0].toObject();
    QJsonObject uncertainty = first["uncertainty"].toObject();
    uncertainty["repeatability"] = 0.2;
    first["uncertainty"] = uncertainty;
    tests[0] = first;
    root["tests"] = tests;
    const QString stated = folder.filePath("stated.palmer");
    QFile changed(stated);
    QVERIFY(changed.open(QIODevice::WriteOnly));
    changed.write(QJsonDocument(root).toJson());
    changed.close();
    const QByteArray said = runCli({"compare", stated, stated, "--test", "1"}).out.simplified();
    QVERIFY2(said.contains("of both U, each with its repeatability"), said);
    QVERIFY(said.contains("always between these two sessions") && !said.contains("A, E, M, R"));
    QVERIFY(runCli({"compare", both, both, "--test", "1,2"}).out.simplified().contains("A, E, M, R"));
}

void CompareCommandTest::printsItInBothLanguages() {
    const QByteArray english =
        runCli({"compare", both, both, "--test", "1,2", "--language", "en"}).out.simplified();
    for (const char *words :
         {"Comparison of two tests", "Differences of the conditions", "changed, better",
          "table of 3 February 2025", "Shared by both tests: α of the machine, the instrument"})
        QVERIFY2(english.contains(words), words);
    const QByteArray french = runCli({"compare", both, both, "--test", "1,2", "--language", "fr"}).out;
    for (const char *words : {"Comparaison de deux essais", "Conditions qui diffèrent"})
        QVERIFY2(french.contains(words), words);
}

void CompareCommandTest::itsJsonIsThatOfItsSchema() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("c.jsonl"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    int lines = 0;
    for (const QStringList &words :
         {QStringList{"--test", "1,2"}, {"--test", "1"}, {"--test", "1,2", "--laboratories"}}) {
        QJsonObject comparison = jsonOf(words);
        file.write(QJsonDocument(comparison).toJson(QJsonDocument::Compact) + '\n');
        ++lines;
        comparison["unknown"] = 1; // of a later version: no reader breaks
        if (lines == 3)
            file.write(QJsonDocument(comparison).toJson(QJsonDocument::Compact) + '\n');
    }
    file.close();
    QProcess validator;
    validator.start("/usr/bin/python3",
                    {QStringLiteral(PALMER_SOURCE_DIR "/tests/core/document/validate.py"),
                     QStringLiteral(PALMER_SOURCE_DIR "/resources/schema/palmer-comparison-1.schema.json"),
                     file.fileName()});
    QVERIFY(validator.waitForFinished(patience));
    QCOMPARE(validator.readAllStandardOutput().simplified(), QByteArray("1 1 1 1"));
}

void CompareCommandTest::findsTheLikeInTheOtherFile() {
    const QString other = EXAMPLES "iso230-2-1988-example.palmer"; // X, both directions, other instruments
    const QJsonObject comparison =
        QJsonDocument::fromJson(runCli({"compare", other, both, "--json"}).out).object();
    QCOMPARE(comparison["before"]["edition"].toString(), "ISO 230-2:1988");
    QCOMPARE(comparison["edition"].toString(), "ISO 230-2:2006"); // that of the second
    QCOMPARE(comparison["noWord"].toString(), "noUncertainty");
}

void CompareCommandTest::refusesWhatCannotBeMeant() {
    QCOMPARE(runCli({"compare"}).code, 2);
    QCOMPARE(runCli({"compare", EXAMPLES "rotary-axis.palmer"}).code, 2); // states no other test
    QCOMPARE(runCli({"compare", both, both, both}).code, 2);
    const auto missing = runCli({"compare", both, both, "--test", "1,3"});
    QVERIFY2(missing.code == 2 && missing.err.contains("there is no test 3; the file has 2"), missing.err);
    QCOMPARE(runCli({"compare", both, both, "--test", "1,2,1"}).code, 2);
    QCOMPARE(runCli({"compare", both, both, "--test", "x"}).code, 2);
    QCOMPARE(runCli({"compare", both, both, "--test", "1,2", "--tolerance", "-1"}).code, 2);
    QCOMPARE(runCli({"compare", both, both, "--test", "1,2", "--tolerance", "0"}).code, 2);
    QCOMPARE(runCli({"compare", both, "/nowhere.palmer"}).code, 3);
    QCOMPARE(runCli({"compare", both, EXAMPLES "rotary-axis.palmer"}).code, 2); // no X axis
}

QTEST_GUILESS_MAIN(CompareCommandTest)
#include "comparecommandtest.moc"
