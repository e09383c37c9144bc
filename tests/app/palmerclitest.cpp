// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <unistd.h>
#include <utility>

using namespace palmer::testdata;

namespace {

struct Result {
    int code = -1;
    QString out;
    QString err;
};

Result run(const QStringList &arguments, const QByteArray &input = {}, const QString &locale = "C") {
    const auto result = runCli(arguments, input, {{"LC_ALL", locale}});
    return {result.code, result.out, result.err};
}

QString example(const QString &name) {
    return EXAMPLES + name + ".palmer";
}

/// A small test with A = 4 µm, and what is put beside it.
QByteArray smallTest(const QByteArray &more) {
    return R"({"format": "palmer test report", "version": 1, "tests": [{"kind": "positioning", "id": "x",
        "edition": "ISO 230-2:2006", "targets": [0, 100], "runs": [
        {"approach": "positive", "deviations": [0, 0.004]}, {"approach": "negative", "deviations": [0, 0.004]},
        {"approach": "positive", "deviations": [0, 0.004]}, {"approach": "negative", "deviations": [0, 0.004]}])" +
           more + "}]}";
}

} // namespace

class PalmerCliTest : public QObject {
    Q_OBJECT

private slots:
    void endsWithItsCode_data();
    void endsWithItsCode();
    void refusesDamagedFilesInOneLine_data();
    void refusesDamagedFilesInOneLine();
    void takesEditionsByTheirYear_data();
    void takesEditionsByTheirYear();
    void readsNumbersOfOptionsAlike();
    void namesTheOptionAsItIsTyped();
    void worksOnEachFile();
    void writesJson();
    void readsStandardInput();
    void evaluatesUnderAnotherEdition();
    void namesTheEditionsItKnows();
    void speaksBothLanguages();
    void givesTheUncertainty_data();
    void givesTheUncertainty();
    void simulatesAlikeOnAnyNumberOfThreads();
    void saysWhenItCannotWrite();
    void readsAndWritesNoOtherFileForAClosedStream();
    void listsOnlyWhatItDoes();
    void agreesWithTheReferenceData();
    void takesAFolderOfReferenceData();
    void contouringFeed_data();
    void contouringFeed();
};

void PalmerCliTest::endsWithItsCode_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<int>("code");
    const QStringList evaluate{"evaluate", "-"};
    QTest::newRow("no limit, no verdict") << evaluate << smallTest("") << 0;
    QTest::newRow("a limit that is kept")
        << evaluate << smallTest(R"(, "limits": {"A": {"value": 0.004}})") << 0;
    QTest::newRow("a limit that is not kept")
        << evaluate << smallTest(R"(, "limits": {"A": {"value": 0.003}})") << 1;
    QTest::newRow("not proven")
        << evaluate
        << smallTest(R"(, "limits": {"A": {"value": 0.1}}, "decisionRule": {"rule": "ISO 14253-1"})") << 1;
    QTest::newRow("not proven, where rejection has to be")
        << evaluate
        << smallTest(R"(, "limits": {"A": {"value": 0.003}}, "decisionRule": {"rule": "rejection proven"})")
        << 0;
    QTest::newRow("under another edition there is no verdict")
        << QStringList{"evaluate", "--edition", "ISO 230-2:1988", "-"}
        << smallTest(R"(, "limits": {"A": {"value": 0.003}})") << 0;
    QTest::newRow("an edition of a kind no test has")
        << QStringList{"evaluate", "--edition=ISO 230-4:2005", "-"} << smallTest("") << 2;
    QTest::newRow("a requirement is not met") << QStringList{"check", "-"} << smallTest("") << 1;
    QTest::newRow("help") << QStringList{"--help"} << QByteArray() << 0;
    QTest::newRow("help of a command") << QStringList{"evaluate", "--help"} << QByteArray() << 0;
    QTest::newRow("help, short") << QStringList{"-h"} << QByteArray() << 0;
    QTest::newRow("help of a command, short") << QStringList{"evaluate", "-h"} << QByteArray() << 0;
    QTest::newRow("help as a command") << QStringList{"help"} << QByteArray() << 0;
    QTest::newRow("help as a command, of another") << QStringList{"help", "report"} << QByteArray() << 0;
    QTest::newRow("help of no command") << QStringList{"help", "measure"} << QByteArray() << 2;
    QTest::newRow("version") << QStringList{"--version"} << QByteArray() << 0;
    for (const char *command : {"evaluate", "check"}) {
        QTest::addRow("%s: no test in the file", command)
            << QStringList{command, "-"}
            << QByteArray(R"({"format": "palmer test report", "version": 1, "tests": []})") << 3;
    }
    QTest::newRow("no command") << QStringList{} << QByteArray() << 2;
    QTest::newRow("unknown command") << QStringList{"measure"} << QByteArray() << 2;
    QTest::newRow("no file") << QStringList{"evaluate"} << QByteArray() << 2;
    QTest::newRow("a file too many") << QStringList{"feed", "x"} << QByteArray() << 2;
    QTest::newRow("unknown option") << QStringList{"evaluate", "--jason", "-"} << smallTest("") << 2;
    QTest::newRow("option of another command") << QStringList{"check", "--cycle", "-"} << smallTest("") << 2;
    QTest::newRow("option without its value")
        << QStringList{"evaluate", "-", "--edition"} << smallTest("") << 2;
    QTest::newRow("switch with a value") << QStringList{"evaluate", "--json=yes", "-"} << smallTest("") << 2;
    QTest::newRow("unknown language")
        << QStringList{"evaluate", "--language", "de", "-"} << smallTest("") << 2;
    const QByteArray budget =
        smallTest(R"(, "limits": {"A": {"value": 0.006}}, "decisionRule": {"rule": "ISO 14253-1"},
        "conditions": {"correctionTo20": "applied by the instrument"},
        "uncertainty": {"method": "direct", "expanded": {"A": 0.1}, "device": {"fixed": 1.0, "perMetre": 0.0},
        "misalignmentRange": 0.0, "temperatureRange": {"machine": 0.0, "instrument": 0.0},
        "expansionRange": {"machine": 0.0, "instrument": 0.0}, "environmentalVariation": 0.0})");
    QTest::newRow("the stated uncertainty proves it") << QStringList{"evaluate", "-"} << budget << 0;
    QTest::newRow("the budget proves it too")
        << QStringList{"evaluate", "--uncertainty", "budget", "-"} << budget << 0;
    QTest::newRow("the budget of a larger uncertainty does not")
        << QStringList{"evaluate", "--uncertainty=budget", "-"} << QByteArray(budget).replace("1.0", "2.1")
        << 1;
    QTest::newRow("nor does the simulation")
        << QStringList{"evaluate", "--uncertainty=monteCarlo", "--trials", "220000", "-"}
        << QByteArray(budget).replace("1.0", "2.2") << 1;
    // U of 2.1 µm leaves it open; three trials nearly always give an interval far too short.
    const QByteArray open = QByteArray(budget).replace("1.0", "2.1");
    for (const char *trials : {"1", "3", "219999"})
        QTest::addRow("%s trials do not decide", trials)
            << QStringList{"evaluate", "--uncertainty=monteCarlo", "--trials", trials, "-"} << open << 1;
    QTest::newRow("nor do three of the file")
        << QStringList{"evaluate", "-"}
        << QByteArray(open).replace("\"direct\"", "\"monteCarlo\", \"trials\": 3") << 1;
    QTest::newRow("the actual targets, chosen in the file")
        << QStringList{"evaluate", "-"} << QByteArray(open).replace("\"direct\"", "\"budgetActual\"") << 1;
    QTest::newRow("too many trials") << QStringList{"evaluate", "--trials", "1000000001", "-"}
                                     << smallTest("") << 2;
    QTest::newRow("too many trials in the file")
        << QStringList{"evaluate", "-"}
        << QByteArray(open).replace("\"direct\"", "\"budget\", \"trials\": 1000000001") << 3;
    QTest::newRow("unknown method of uncertainty")
        << QStringList{"evaluate", "--uncertainty", "guess", "-"} << smallTest("") << 2;
    QTest::newRow("trials with a power of ten")
        << QStringList{"evaluate", "--uncertainty=monteCarlo", "--trials", "1e3", "-"} << budget << 0;
    QTest::newRow("trials of no simulation")
        << QStringList{"evaluate", "--trials", "1e3", "-"} << smallTest("") << 2;
    QTest::newRow("trials that are not whole")
        << QStringList{"evaluate", "--trials", "1.5e0", "-"} << smallTest("") << 2;
    QTest::newRow("a comma of thousands")
        << QStringList{"evaluate", "--trials", "1,000", "-"} << smallTest("") << 2;
    QTest::newRow("too large a power")
        << QStringList{"evaluate", "--trials", "1e99", "-"} << smallTest("") << 2;
    QTest::newRow("no trials") << QStringList{"evaluate", "--trials", "0", "-"} << smallTest("") << 2;
    QTest::newRow("a seed that is no number")
        << QStringList{"evaluate", "--seed", "x", "-"} << smallTest("") << 2;
    QTest::newRow("no such file") << QStringList{"evaluate", "/nowhere/x.palmer"} << QByteArray() << 3;
    QTest::newRow("a folder without files")
        << QStringList{"evaluate", "/proc/self/fdinfo"} << QByteArray() << 3;
}

void PalmerCliTest::endsWithItsCode() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, input);
    QFETCH(int, code);
    const Result result = run(arguments, input);
    QVERIFY2(result.code == code, qPrintable(QString::number(result.code) + ' ' + result.err));
    QCOMPARE(result.err.count('\n'), code >= 2 ? 1 : 0);
    QCOMPARE(result.out.isEmpty(), code >= 2);
    QVERIFY(code < 2 || result.err.startsWith("palmer-cli: "));
}

void PalmerCliTest::refusesDamagedFilesInOneLine_data() {
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<QString>("start");
    QTest::newRow("nothing") << QByteArray() << "palmer-cli: -: ";
    QTest::newRow("not JSON") << QByteArray("hello\nworld") << "palmer-cli: -: there is no table of numbers";
    QTest::newRow("cut off") << smallTest("").chopped(3) << "palmer-cli: -: ";
    QTest::newRow("unknown key") << smallTest(R"(, "feeed": 1)") << "palmer-cli: -: tests[0]";
    QTest::newRow("wrong type") << smallTest(R"(, "title": 3)") << "palmer-cli: -: tests[0].title: ";
    QTest::newRow("nesting") << QByteArray(100'000, '[') << "palmer-cli: -: ";
}

void PalmerCliTest::refusesDamagedFilesInOneLine() {
    QFETCH(QByteArray, input);
    QFETCH(QString, start);
    const Result result = run({"evaluate", "-"}, input);
    QCOMPARE(result.code, 3);
    QVERIFY(result.out.isEmpty());
    QVERIFY2(result.err.startsWith(start) && result.err.count('\n') == 1, qPrintable(result.err));
}

/// As much of a designation as leaves no choice, and no more is guessed.
void PalmerCliTest::takesEditionsByTheirYear_data() {
    QTest::addColumn<QString>("asked");
    QTest::addColumn<QString>("edition"); // empty: refused
    QTest::newRow("whole") << "ISO 230-2:2006"
                           << "ISO 230-2:2006";
    QTest::newRow("year") << "2006"
                          << "ISO 230-2:2006";
    QTest::newRow("lower case") << "iso 230-2:1988"
                                << "ISO 230-2:1988";
    QTest::newRow("without blank") << "iso230-2:1997"
                                   << "ISO 230-2:1997";
    QTest::newRow("without organisation") << "230-2:2014"
                                          << "ISO 230-2:2014";
    QTest::newRow("by its number") << "3441"
                                   << "VDI/DGQ 3441:1977";
    QTest::newRow("by its organisation") << "vdi"
                                         << "VDI/DGQ 3441:1977";
    QTest::newRow("several of that year") << "2016"
                                          << "";
    QTest::newRow("several of that standard") << "ISO 230-2"
                                              << "";
    QTest::newRow("a piece of a year") << "006"
                                       << "";
    QTest::newRow("one more digit") << "20061"
                                    << "";
    QTest::newRow("nothing") << ""
                             << "";
    QTest::newRow("a mark") << "-"
                            << "";
    QTest::newRow("unknown") << "ISO 230-3:2020"
                             << "";
}

void PalmerCliTest::takesEditionsByTheirYear() {
    QFETCH(QString, asked);
    QFETCH(QString, edition);
    const Result result = run({"evaluate", "--json", "--edition", asked, "-"}, smallTest(""));
    if (edition.isEmpty()) {
        QCOMPARE(result.code, 2);
        QCOMPARE(result.err.count('\n'), 1);
        return;
    }
    QCOMPARE(result.code, 0);
    const QJsonObject test = QJsonDocument::fromJson(result.out.toUtf8())["tests"][0].toObject();
    QCOMPARE(test["edition"].toString(), edition);
}

void PalmerCliTest::readsNumbersOfOptionsAlike() {
    const auto code = [](const QString &number) {
        const int plan = run({"targets", "--travel", number, "-o", "-"}).code;
        const int table = run({"export", example("iso230-2-1988-example"), "--as", "compensation-csv",
                               "--interval", number, "-o", "-"})
                              .code;
        return plan == table ? plan : -1;
    };
    for (const QString number : {"100", "1e2", "1.25E+2", "125,5", "125.5", "1,5e2"})
        QVERIFY2(code(number) == 0, qPrintable(number));
    for (const QString number :
         {"1,000", "12,345", "1,000,000", "1e", "e3", "1e400", "inf", "nan", "", "x", "10x"})
        QVERIFY2(code(number) == 2, qPrintable(number));
    QCOMPARE(run({"targets", "--travel", "1e3", "-o", "-"}).out,
             run({"targets", "--travel", "1000", "-o", "-"}).out);
}

void PalmerCliTest::namesTheOptionAsItIsTyped() {
    QVERIFY(run({"report", "x", "-o"}).err.contains("the option -o needs a value"));
    QVERIFY(run({"evaluate", "x", "--edition"}).err.contains("the option --edition needs a value"));
    QVERIFY(run({"evaluate", "--json=1", "x"}).err.contains("the option --json takes no value"));
}

void PalmerCliTest::worksOnEachFile() {
    const Result result =
        run({"evaluate", "--json", "/nowhere", example("rotary-axis"), example("one-direction")});
    QCOMPARE(result.code, 3);
    QVERIFY(result.err.startsWith("palmer-cli: /nowhere: "));
    QCOMPARE(result.err.count('\n'), 1);
    const QStringList lines = result.out.split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2);
    for (const QString &line : lines)
        QVERIFY(QJsonDocument::fromJson(line.toUtf8()).isObject());
    QCOMPARE(QJsonDocument::fromJson(lines[1].toUtf8())["file"].toString(), example("one-direction"));
}

void PalmerCliTest::writesJson() {
    const Result result = run({"evaluate", "--json", example("iso230-2-1988-example")}, {}, "fr_FR.UTF-8");
    QCOMPARE(result.code, 0);
    const QJsonObject accuracy =
        QJsonDocument::fromJson(result.out.toUtf8())["tests"][0]["parameters"][0].toObject();
    QCOMPARE(accuracy["id"].toString(), "A");
    QCOMPARE(accuracy["name"].toString(), "accuracy of an axis");        // English unless asked for otherwise
    QVERIFY(std::abs(accuracy["value"].toDouble() - 0.01803) <= 1.5e-5); // mm, as printed in the standard
}

void PalmerCliTest::readsStandardInput() {
    const QString name = example("rotary-axis");
    QCOMPARE(run({"evaluate", "-"}, contents(name)).out, run({"evaluate", name}).out);
}

void PalmerCliTest::evaluatesUnderAnotherEdition() {
    const Result result =
        run({"evaluate", "--json", "--edition", "ISO 230-2:2006", example("iso230-2-1988-example")});
    const auto test = QJsonDocument::fromJson(result.out.toUtf8())["tests"][0];
    QCOMPARE(test["edition"].toString(), "ISO 230-2:2006");
    QVERIFY(std::abs(test["parameters"][0]["value"].toDouble() - 0.01623207) <=
            1e-8); // mm, recomputed elsewhere
}

void PalmerCliTest::namesTheEditionsItKnows() {
    const Result result = run({"evaluate", "--edition", "ISO 230-2:2025", example("rotary-axis")});
    QCOMPARE(result.code, 2);
    QVERIFY(result.err.contains("ISO 230-2:2025") && result.err.contains("ISO 230-2:2014, ") &&
            result.err.contains("ISO 230-4:2005"));
}

void PalmerCliTest::speaksBothLanguages() {
    const QString name = example("rotary-axis");
    const QString english = run({"evaluate", name}, {}, "C").out;
    const QString french = run({"evaluate", "--language", "fr", name}, {}, "C").out;
    QVERIFY(english.contains("8.1") && !english.contains("8,1"));
    QVERIFY(french.contains("8,1") && !french.contains("8.1"));
    QVERIFY(french.simplified().contains("20 novembre 2026"));
    QCOMPARE(run({"evaluate", name}, {}, "fr_CA").out, french);
    QCOMPARE(run({"--language=en", "evaluate", name}, {}, "fr_FR.UTF-8").out, english);
}

void PalmerCliTest::givesTheUncertainty_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("method");
    QTest::addColumn<bool>("simulated");
    QTest::newRow("as the file says") << QStringList{} << "budget" << false;
    QTest::newRow("by the budget") << QStringList{"--uncertainty", "budget"} << "budget" << false;
    QTest::newRow("by Monte Carlo") << QStringList{"--uncertainty", "monteCarlo", "--trials",
                                                   "220000",        "--seed",     "7"}
                                    << "monteCarlo" << true;
}

void PalmerCliTest::givesTheUncertainty() {
    QFETCH(QStringList, options);
    QFETCH(QString, method);
    QFETCH(bool, simulated);
    const Result result =
        run(QStringList{"evaluate", "--json"} + options + QStringList{example("rotary-axis")});
    const QJsonObject test = QJsonDocument::fromJson(result.out.toUtf8())["tests"][0].toObject();
    QCOMPARE(test["uncertainty"]["method"].toString(), method);
    const QJsonArray contributions = test["uncertainty"]["contributions"].toArray();
    QCOMPARE(contributions.size(), 2);
    QCOMPARE(contributions[0]["id"].toString(), "device");
    QVERIFY(contributions[0]["value"].toDouble() > 0);
    for (const QJsonValue &parameter : test["parameters"].toArray()) {
        QVERIFY(parameter["expandedUncertainty"].toDouble() > 0);
        const QJsonValue monteCarlo = parameter["monteCarlo"];
        QCOMPARE(monteCarlo.isNull(), !simulated);
        if (!simulated)
            continue;
        QCOMPARE(monteCarlo.toObject().keys(),
                 QStringList({"high", "low", "seed", "shift", "tolerance", "trials", "u"}));
        QCOMPARE(monteCarlo["trials"].toInt(), 220000);
        const double u = monteCarlo["u"].toDouble();
        const double tolerance = std::pow(10, std::floor(std::log10(u)) - 1) / 2;
        QVERIFY(std::abs(monteCarlo["tolerance"].toDouble() - tolerance) < 1e-9 * tolerance);
        QCOMPARE(monteCarlo["seed"].toInt(), 7);
        QVERIFY(monteCarlo["u"].toDouble() > 0);
        const double half = (monteCarlo["high"].toDouble() - monteCarlo["low"].toDouble()) / 2;
        if (std::abs(monteCarlo["shift"].toDouble()) <= half / 3)
            QCOMPARE(parameter["expandedUncertainty"].toDouble(), half);
    }
}

void PalmerCliTest::simulatesAlikeOnAnyNumberOfThreads() {
    const auto with = [](const QString &threads, const QString &seed) {
        return run({"evaluate", "--json", "--uncertainty", "monteCarlo", "--trials", "12345", "--seed", seed,
                    "--threads", threads, example("rotary-axis")})
            .out;
    };
    const QString one = with("1", "3");
    QVERIFY(one.contains("12345"));
    QCOMPARE(with("2", "3"), one);
    QCOMPARE(with("8", "3"), one);
    QVERIFY(with("1", "4") != one);
}

void PalmerCliTest::saysWhenItCannotWrite() {
    QProcess process;
    process.setStandardOutputFile("/dev/full");
    process.start(PALMER_CLI, {"evaluate", example("rotary-axis")});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 3);
    QCOMPARE(process.readAllStandardError().count('\n'), 1);
}

void PalmerCliTest::readsAndWritesNoOtherFileForAClosedStream() {
    const auto without = [](int stream, const QStringList &arguments) {
        QProcess process;
        process.setChildProcessModifier([stream] { ::close(stream); });
        process.start(PALMER_CLI, arguments);
        if (!process.waitForFinished())
            qFatal("palmer-cli did not end by itself");
        return std::pair(process.exitCode(), process.readAllStandardError());
    };
    // Its number was that of what Qt opens first, which "cannot be read for the moment".
    QCOMPARE(without(STDIN_FILENO, {"evaluate", "-"}),
             std::pair(3, QByteArray("palmer-cli: -: the file cannot be read (Bad file descriptor)\n")));
    const auto [code, error] = without(STDOUT_FILENO, {"evaluate", example("rotary-axis")});
    QCOMPARE(code, 3);
    QVERIFY2(error.endsWith("standard output cannot be written\n"), error);
    QTemporaryDir folder;
    const QString report = folder.filePath("r.pdf");
    QCOMPARE(
        without(STDERR_FILENO, {"report", example("rotary-axis"), "--language", "en", "-o", report}).first,
        0);
    QCOMPARE(run({"verify", report}).code, 0);
}

void PalmerCliTest::listsOnlyWhatItDoes() {
    const QString help = run({"--help"}).out;
    for (const char *command : {"evaluate", "check", "feed", "selftest"}) {
        QVERIFY(help.contains(QString("  ") + command));
        QCOMPARE(run({command, "--help"}).code, 0);
    }
}

void PalmerCliTest::agreesWithTheReferenceData() {
    const QTemporaryDir folder;
    const QString pdf = folder.filePath("validation.pdf");
    const Result result = run({"selftest", "--report", pdf, "--language", "fr"});
    QVERIFY2(result.code == 0, qPrintable(result.out));
    QProcess text;
    text.start("pdftotext", {"-layout", pdf, "-"});
    QVERIFY(text.waitForFinished());
    const QString printed = QString::fromUtf8(text.readAllStandardOutput());
    for (const char *words : {"NIST StRD", "Axes rotatifs", "Tables de compensation",
                              "seconde implémentation", "certifié", "Verdicts", "concorde"}) {
        QVERIFY2(result.out.contains(words), words);
        QVERIFY2(printed.contains(words), words);
    }
    for (const char *words : {"Validation de Palmer " PALMER_VERSION, "Processeur", "Compilateur", "SHA-256"})
        QVERIFY2(printed.contains(words), qPrintable(printed.left(1000)));
    QVERIFY(!result.out.contains("NE CONCORDE PAS"));
    const Result unsaved = run({"selftest", "--report", "/nowhere/v.pdf"});
    QVERIFY2(unsaved.code == 3 && unsaved.err.startsWith("palmer-cli: /nowhere/v.pdf: "),
             qPrintable(unsaved.err));
}

void PalmerCliTest::takesAFolderOfReferenceData() {
    const QTemporaryDir folder;
    const auto write = [&](const char *name, const QByteArray &bytes) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    };
    Result result = run({"selftest", folder.path()});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.err.contains("no reference data"), qPrintable(result.err));
    QFile published(PALMER_SOURCE_DIR "/resources/reference/constructed.json");
    QVERIFY(published.open(QIODevice::ReadOnly));
    const QByteArray good = published.readAll();
    write("good.json", good);
    result = run({"selftest", folder.path(), "--json"});
    QCOMPARE(result.code, 0);
    const QJsonObject json = QJsonDocument::fromJson(result.out.toUtf8()).object();
    QCOMPARE(json["format"].toString(), QString("palmer validation"));
    QCOMPARE(json["sets"].toArray().size(), 1);
    QCOMPARE(json["sets"][0]["agrees"].toBool(), true);
    // One wrong digit is found, and named with its place.
    write("wrong.json", QByteArray(good).replace(R"("parameter": "M", "value": 0.0075)",
                                                 R"("parameter": "M", "value": 0.0175)"));
    result = run({"selftest", folder.path(), "--language", "en"});
    QCOMPARE(result.code, 1);
    QVERIFY2(result.out.contains("test 1 M ISO 230-2:1997: 17.5"), qPrintable(result.out));
    // An unreadable file stops no other.
    write("broken.json", "{");
    result = run({"selftest", folder.path(), "--json"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.err.contains("broken.json"), qPrintable(result.err));
    QCOMPARE(QJsonDocument::fromJson(result.out.toUtf8()).object()["sets"].toArray().size(), 2);
}

void PalmerCliTest::contouringFeed_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("out");
    QTest::addColumn<QString>("error");
    const auto row = [](const char *name, const QString &arguments, const char *out, const char *error) {
        QTest::newRow(name) << arguments.split(u' ') << QString(out) << QString(error);
    };
    row("the example of annex C", "--specified-diameter 100 --specified-feed 500 --diameter 125",
        "559\u00A0mm/min\n", "");
    row("below 100 three digits", "--specified-diameter=125 --specified-feed=50 --diameter=100",
        "44.7\u00A0mm/min\n", "");
    row("in French", "--language fr --specified-diameter 200 --specified-feed 5e3 --diameter 50",
        "2\u202F500\u00A0mm/min\n", "");
    row("an option is missing", "--specified-diameter 100 --diameter 125", "",
        "the command feed needs the option --specified-feed MM/MIN");
    row("no number", "--specified-diameter 100 --specified-feed fast --diameter 125", "",
        "--specified-feed cannot be fast; expected a number");
    row("zero", "--specified-diameter 0 --specified-feed 500 --diameter 125", "",
        "--specified-diameter cannot be 0; expected a number greater than 0");
    row("negative", "--specified-diameter 100 --specified-feed 500 --diameter -125", "",
        "--diameter cannot be -125; expected a number greater than 0");
    row("not finite", "--specified-diameter 100 --specified-feed 500 --diameter inf", "",
        "--diameter cannot be inf; expected a number");
    row("beyond all numbers", "--specified-diameter 1e-300 --specified-feed 1e300 --diameter 1e300", "",
        "there is no feed for numbers this large or small");
}

void PalmerCliTest::contouringFeed() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, error);
    const Result result = run(QStringList{"feed"} + arguments);
    QTEST(result.out, "out");
    QCOMPARE(result.err, error.isEmpty() ? QString() : "palmer-cli: " + error + '\n');
    QCOMPARE(result.code, error.isEmpty() ? 0 : 2);
}

QTEST_GUILESS_MAIN(PalmerCliTest)
#include "palmerclitest.moc"
