// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QDate>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <random>
#include <sys/resource.h>

using namespace palmer::testdata;

namespace {

std::vector<QJsonObject> objects(const QByteArray &lines) {
    std::vector<QJsonObject> result;
    for (const QByteArray &line : lines.split('\n')) {
        if (!line.isEmpty())
            result.push_back(QJsonDocument::fromJson(line).object());
    }
    return result;
}

QByteArray runPdfinfo(const QString &pdf) {
    QProcess process;
    process.start("pdfinfo", {pdf});
    return process.waitForFinished(patience) ? process.readAllStandardOutput() : QByteArray();
}

} // namespace

/// palmer-cli register, as its users call it, over files that the script of the benchmarks makes.
class RegisterCommandTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QProcess script;
        script.start("python3", {QStringLiteral(PALMER_SOURCE_DIR "/tests/benchmarks/registerfiles.py"),
                                 files(), "--files", "240", "--machines", "6", "--circles"});
        QVERIFY(script.waitForFinished(patience));
        QCOMPARE(script.exitCode(), 0);
        m_register = m_files.filePath("scanned.sqlite");
        QCOMPARE(reg({"scan", files()}).code, 0);
        QVERIFY(!QFile::exists(m_register + "-wal")); // all of it is in the one file
    }
    void init() {
        m_dir = std::make_unique<QTemporaryDir>();
        m_register = m_dir->filePath("register.sqlite");
    }

    void scanListTrend();
    void whatIsListed_data();
    void whatIsListed();
    void wrongUsage_data();
    void wrongUsage();
    void joinAndInterval();
    void whatWasJoinedIsSeparated();
    void whatIsSaidOfMachinesFindsAPlace();
    void theListIsTheTable();
    void pruningMostOfAFolderWantsForce();
    void speaksFrench();
    void aReportIsAPlaceOfItsTest();
    void killedItGoesOn();
    void whatVanishesIsSaidWhileWatching();
    void aFullDiskLosesNothing();
    void aFullDiskLeavesNoEmptyRegister();
    void theHistoryIsPrinted();
    void aHistoryProvesItself();
    void whatIsExceededComesFirst();
    void theNumberOfAHistory_data();
    void theNumberOfAHistory();
    void theTypeOfFiles();
    void eachPartHasItsHelp();
    void theTestOfAType();
    void theTypeOnPaper();
    void whatChangedSinceTheLastTest();
    void aPictureOfATrend_data();
    void aPictureOfATrend();
    void theUsersRegisterStandsInHisData();
    void nothingIsWrittenIntoFiles();

private:
    QString files() const { return m_files.filePath("files"); }
    CliResult reg(const QStringList &words) const {
        return runCli(QStringList{"register"} + words + QStringList{"--register", m_register});
    }
    /// A register of the files, scanned once for all functions; each has its own copy.
    void scan() const { QVERIFY(QFile::copy(m_files.filePath("scanned.sqlite"), m_register)); }

    QTemporaryDir m_files;
    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_register;
};

void RegisterCommandTest::scanListTrend() {
    const CliResult first = reg({"scan", files()});
    QCOMPARE(first.err, QByteArray());
    QCOMPARE(first.code, 0);
    QCOMPARE(first.out,
             QByteArray("Files: 240, of them read now: 240, unreadable: 0, not found: 0. Machines in the "
                        "register: 6, tests: 240.\n"));
    const auto again = objects(reg({"scan", files(), "--json"}).out);
    QCOMPARE(again.front()["read"].toInt(), 0);
    QCOMPARE(again.front()["tests"].toInt(), 240);

    const auto list = objects(reg({"list", "--json"}).out);
    QCOMPARE(list.size(), std::size_t{240});
    // The same numbers as the command evaluate gives for the file.
    const QJsonObject test = list[100];
    const auto evaluated = objects(runCli({"evaluate", "--json-lines", test["file"].toString()}).out).front();
    const QJsonObject there = evaluated["tests"].toArray().at(test["test"].toInt() - 1).toObject();
    for (const char *key :
         {"title", "kind", "edition", "axis", "plane", "date", "accordance", "inAccordance", "verdict",
          "limits", "role", "purpose", "correctionTo20", "decisionRule", "unmet"})
        QVERIFY2(test[key] == there[key], key);
    const QJsonArray parameters = test["parameters"].toArray();
    QCOMPARE(parameters.size(), there["parameters"].toArray().size());
    for (qsizetype i = 0; i < parameters.size(); ++i) {
        const QJsonObject mine = parameters[i].toObject();
        const QJsonObject its = there["parameters"].toArray()[i].toObject();
        for (const char *key :
             {"id", "value", "unit", "expandedUncertainty", "limit", "guardBand", "verdict"})
            QVERIFY2(mine[key] == its[key], key);
    }

    const auto trends =
        objects(reg({"trend", "--machine", "machine 001", "--axis", "X", "--parameter", "A", "--json"}).out);
    QCOMPARE(trends.size(), std::size_t{1});
    const QJsonObject trend = trends.front();
    QCOMPARE(trend["parameter"].toString(), QString("A"));
    QCOMPARE(trend["unit"].toString(), QString("mm"));
    QCOMPARE(trend["machine"].toObject()["serialNumber"].toString(), QString("000-001"));
    int points = 0;
    for (const auto &series : trend["series"].toArray())
        points += static_cast<int>(series.toObject()["points"].toArray().size());
    QCOMPARE(points, 10);
    QCOMPARE(objects(reg({"trend", "--machine", "machine 001", "--axis", "X", "--parameter", "A",
                          "--parameter", "E", "--json"})
                         .out)
                 .size(),
             std::size_t{2});
    const QByteArray table = reg({"trend", "--machine", "000-001", "--axis", "X", "-o", "-"}).out;
    QVERIFY(table.contains("Machine 001: trend of A, axis or plane X"));
    const QString csv = m_dir->filePath("trend.csv");
    QCOMPARE(reg({"trend", "--machine", "000-001", "--axis", "X", "--parameter", "A", "-o", csv}).code, 0);
    const CliResult unsaved = reg({"trend", "--machine", "000-001", "--axis", "X", "-o", "/nowhere/t.csv"});
    QVERIFY2(unsaved.code == 3 && unsaved.err.startsWith("palmer-cli: /nowhere/t.csv: "), unsaved.err);
    QCOMPARE(contents(csv).count('\n'), 11);
    QVERIFY(contents(csv).startsWith("machine,manufacturer,model,serialNumber,axis,")); // as the list
    const auto anew = objects(reg({"trend", "--machine", "000-001", "--axis", "X", "--parameter", "A",
                                   "--edition", "ISO 230-2:2006", "--json"})
                                  .out);
    QCOMPARE(anew.front()["series"].toArray().size(), 1);
}

void RegisterCommandTest::whatIsListed_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("count");
    QTest::newRow("all") << QStringList{} << 240;
    QTest::newRow("a machine by its name") << QStringList{"--machine", "machine 002"} << 40;
    QTest::newRow("by its serial number") << QStringList{"--machine", "000002"} << 40;
    QTest::newRow("by its maker") << QStringList{"--machine", "maker b"} << 80;
    QTest::newRow("none of that name") << QStringList{"--machine", "machine 999"} << 0;
    QTest::newRow("none of a mark") << QStringList{"--machine", "%"} << 0;
    QTest::newRow("an axis") << QStringList{"--axis", "x"} << 60;
    QTest::newRow("a plane") << QStringList{"--axis", "XY"} << 60;
    QTest::newRow("a kind") << QStringList{"--kind", "circular"} << 60;
    QTest::newRow("another kind") << QStringList{"--kind", "drift"} << 0;
    QTest::newRow("until the first day") << QStringList{"--until", "2018-11-20"} << 24;
    QTest::newRow("until the day before") << QStringList{"--until", "2018-11-19"} << 0;
    QTest::newRow("since the last day") << QStringList{"--since", "2026-11-18"} << 24;
    QTest::newRow("since the day after") << QStringList{"--since", "2026-11-19"} << 0;
    QTest::newRow("words") << QStringList{"--text", "aftercollision 001"} << 4;
    QTest::newRow("due without an interval, certificates later") << QStringList{"--due", "2026-12-01"} << 0;
    QTest::newRow("certificates, on the newest test of each machine")
        << QStringList{"--due", "2028-12-31"} << 24;
    QTest::newRow("the last periodic test of each axis and plane")
        << QStringList{"--due", "2027-11-18", "--interval", "12"} << 24;
    QTest::newRow("of one machine, by its number in the list")
        << QStringList{"--due", "2027-11-18", "--interval", "12", "--machine", "3"} << 4;
    QTest::newRow("the day before") << QStringList{"--due", "2027-11-17", "--interval", "12"} << 0;
}

void RegisterCommandTest::whatIsListed() {
    QFETCH(QStringList, options);
    QFETCH(int, count);
    scan();
    const CliResult json = reg(QStringList{"list", "--json"} + options);
    QCOMPARE(json.code, 0);
    QCOMPARE(json.out.count('\n'), count);
    const CliResult csv = reg(QStringList{"list", "--csv"} + options);
    QVERIFY(csv.out.startsWith("file,test,machine,"));
    QCOMPARE(csv.out.count('\n') > 1, count > 0);
    const CliResult text = reg(QStringList{"list"} + options);
    QCOMPARE(text.code, 0);
    QCOMPARE(text.out == "No test of the register fits.\n", count == 0);
    QCOMPARE(text.out.contains("\u00A0µm"), count > 0); // every value with its unit
}

void RegisterCommandTest::wrongUsage_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("nothing") << QStringList{} << QByteArray("needs a file");
    QTest::newRow("unknown part") << QStringList{"look"} << QByteArray("scan, list, trend");
    QTest::newRow("no folder") << QStringList{"scan"} << QByteArray("needs a folder");
    QTest::newRow("an option of another part")
        << QStringList{"scan", "/", "--csv"}
        << QByteArray("unknown option --csv of the command register scan");
    QTest::newRow("one machine to join") << QStringList{"join", "000-001"} << QByteArray("MACHINE MACHINE");
    QTest::newRow("a machine joined to itself")
        << QStringList{"join", "000-001", "1"} << QByteArray("one machine already");
    QTest::newRow("half a month") << QStringList{"interval", "1", "0.5"}
                                  << QByteArray(": MONTHS cannot be 0.5");
    QTest::newRow("an interval of a century and more")
        << QStringList{"interval", "1", "1201"} << QByteArray("MONTHS cannot be 1201");
    QTest::newRow("a decimal mark without CSV")
        << QStringList{"list", "--decimal-mark", "comma"} << QByteArray("--csv");
    QTest::newRow("a file too many") << QStringList{"list", "x"} << QByteArray("takes no file");
    QTest::newRow("no day") << QStringList{"list", "--since", "2026-02-30"} << QByteArray("--since");
    QTest::newRow("a short day") << QStringList{"list", "--until", "2026-2-3"} << QByteArray("--until");
    QTest::newRow("no kind") << QStringList{"list", "--kind", "round"} << QByteArray("--kind");
    QTest::newRow("no verdict") << QStringList{"list", "--verdict", "good"} << QByteArray("--verdict");
    QTest::newRow("no interval") << QStringList{"list", "--interval", "0.5"} << QByteArray("--interval");
    QTest::newRow("two forms") << QStringList{"list", "--csv", "--json"} << QByteArray("do not go together");
    QTest::newRow("trend of no machine")
        << QStringList{"trend", "--axis", "X"} << QByteArray("needs --machine");
    QTest::newRow("trend of no axis")
        << QStringList{"trend", "--machine", "001"} << QByteArray("needs --axis");
    QTest::newRow("unknown machine") << QStringList{"trend", "--machine", "nowhere", "--axis", "X"}
                                     << QByteArray("no machine of the register");
    QTest::newRow("several machines")
        << QStringList{"trend", "--machine", "maker", "--axis", "X"}
        << QByteArray("machines may be meant by “maker”: 1. Machine 001 · Maker A");
    QTest::newRow("unknown axis") << QStringList{"trend", "--machine", "000-001", "--axis", "W"}
                                  << QByteArray("no test of W");
    QTest::newRow("unknown parameter")
        << QStringList{"trend", "--machine", "000-001", "--axis", "X", "--parameter", "Q"}
        << QByteArray("they have: A, E, R, M, B");
    QTest::newRow("unknown edition") << QStringList{"trend", "--machine", "000-001", "--axis",
                                                    "X",     "--edition", "Q"}
                                     << QByteArray("edition");
    QTest::newRow("a number too long for its line")
        << QStringList{"report", "--machine", "000-001", "-o", "h.pdf", "--number", QString(41, 'n')}
        << QByteArray("at most 40 characters");
    QTest::newRow("a number of a list") << QStringList{"list", "--number", "7"}
                                        << QByteArray("unknown option --number of the command register list");
    QTest::newRow("a report without a file")
        << QStringList{"report", "--machine", "000-001"} << QByteArray("-o OUT.pdf");
    QTest::newRow("a report of another ending")
        << QStringList{"report", "--machine", "000-001", "-o", "h.png"} << QByteArray("pdf");
    QTest::newRow("type test of no type")
        << QStringList{"type", "--parameter", "A"} << QByteArray("needs --type");
    QTest::newRow("type test of no parameter")
        << QStringList{"type", "--type", "T1"} << QByteArray("needs --parameter");
    QTest::newRow("unknown type") << QStringList{"type", "--type", "T9", "--parameter", "A"}
                                  << QByteArray("no machine of the register is of the type “T9”");
    QTest::newRow("several makers of a type") << QStringList{"type", "--type", "cu 1000", "--parameter", "A"}
                                              << QByteArray("say “Maker A cu 1000”");
    QTest::newRow("a parameter that no test has")
        << QStringList{"type", "--type", "Maker A CU 1000", "--parameter", "Q"}
        << QByteArray("no test with Q");
    QTest::newRow("a signed parameter")
        << QStringList{"type", "--type", "Maker A CU 1000", "--parameter", "Bmean"}
        << QByteArray("has a sign");
    QTest::newRow("a certain type test")
        << QStringList{"type", "--type", "Maker A CU 1000", "--parameter", "A", "--confidence", "1"}
        << QByteArray("--confidence");
    QTest::newRow("an unknown distribution")
        << QStringList{"type", "--type", "Maker A CU 1000", "--parameter", "A", "--distribution", "flat"}
        << QByteArray("logNormal, normal");
    QTest::newRow("a picture of another ending")
        << QStringList{"trend", "--machine", "000-001", "--axis", "X", "-o", "t.doc"}
        << QByteArray("-o OUT.");
}

void RegisterCommandTest::wrongUsage() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, said);
    scan();
    const CliResult result = reg(words);
    QCOMPARE(result.code, 2);
    QVERIFY2(result.err.contains(said), result.err.constData());
    QCOMPARE(result.err.count('\n'), 1);
    QCOMPARE(result.out, QByteArray());
}

/// Two machines become one, and an interval is set, in a file beside theirs.
void RegisterCommandTest::joinAndInterval() {
    const QString folder = m_dir->filePath("some");
    QVERIFY(QDir().mkpath(folder));
    for (const char *machine : {"001", "002"})
        QVERIFY(QFile::copy(files() + QString("/machine %1/2018-11-20 X.palmer").arg(machine),
                            folder + QString("/%1.palmer").arg(machine)));
    QCOMPARE(reg({"scan", folder}).code, 0);
    QVERIFY(reg({"list"}).out.startsWith("1. Machine 001 · Maker A · CU 1000 · 000-001\n"));
    for (const QStringList &words :
         {QStringList{"join", "1", "Machine 002"}, QStringList{"interval", "1.", "24"}}) {
        const CliResult result = reg(words);
        QCOMPARE(result.code, 0);
        QCOMPARE(result.out + result.err, QByteArray());
    }
    for (const char *rebuild : {"", "--rebuild"}) {
        QCOMPARE(reg(QStringList{"scan", folder, rebuild}.filter(QRegularExpression("."))).code, 0);
        QByteArray due; // of one; the certificates of both have expired by then
        for (const QJsonObject &test :
             objects(reg({"list", "--json", "--machine", "1", "--due", "2020-11-20"}).out))
            due +=
                test["due"].toString("-").toUtf8() + ' ' + test["certificateDue"].toString().toUtf8() + ' ';
        QCOMPARE(due.split(' ').size(), 5);
        QCOMPARE(due.count("2020-11-20"), 1);
        QCOMPARE(due.count("2020-01-19"), 2);
        QCOMPARE(objects(reg({"list", "--json", "--machine", "000-001"}).out).size(), std::size_t{2});
        QCOMPARE(reg({"list", "--text", "002"}).out.count("1. Machine 001"), 1);
    }
    const QJsonObject kept = QJsonDocument::fromJson(contents(folder + "/palmer-machines.json")).object();
    QCOMPARE(kept["format"].toString(), QString("palmer machines"));
    QCOMPARE(kept["machines"].toArray().size(), 1);
    QVERIFY(
        reg({"list"}).out.startsWith("1. Machine 001 · Maker A · CU 1000 · 000-001 · joined with 000-002\n"));
    QProcess check;
    check.start("python3", {"-c",
                            "import json, sys, jsonschema; jsonschema.validate(json.load(open(sys.argv[1])), "
                            "json.load(open(sys.argv[2])))",
                            folder + "/palmer-machines.json",
                            PALMER_SOURCE_DIR "/resources/schema/palmer-machines-1.schema.json"});
    QVERIFY(check.waitForFinished(patience));
    QVERIFY2(check.exitCode() == 0, check.readAllStandardError());
    QCOMPARE(reg({"interval", "1", "0"}).code, 0);
    QCOMPARE(reg({"list", "--due", "2099-01-01", "--json"}).out.count("\"due\": \"20"), 0);
    // Several that say something at once: nothing of it is lost.
    QCOMPARE(reg({"scan", files()}).code, 0);
    std::vector<std::unique_ptr<QProcess>> others;
    for (int i = 1; i <= 4; ++i) {
        others.push_back(std::make_unique<QProcess>());
        others.back()->start(PALMER_CLI,
                             {"register", "interval", QString("%1.").arg(i), "12", "--register", m_register});
    }
    for (const auto &other : others)
        QVERIFY(other->waitForFinished(patience) && other->exitCode() == 0);
    QCOMPARE(contents(files() + "/palmer-machines.json").count("\"interval\": 12"), 4);
    QVERIFY(QFile::remove(files() + "/palmer-machines.json"));
}

/// What was joined is separated again, in the file too, by the name or number of its own.
void RegisterCommandTest::whatWasJoinedIsSeparated() {
    const QString folder = m_dir->filePath("parted");
    QVERIFY(QDir().mkpath(folder));
    for (const char *machine : {"001", "002"})
        QVERIFY(QFile::copy(files() + QString("/machine %1/2018-11-20 X.palmer").arg(machine),
                            folder + QString("/%1.palmer").arg(machine)));
    const auto machines = [&] { return reg({"list"}).out.count(" · Maker "); };
    QCOMPARE(reg({"scan", folder}).code, 0);
    const QByteArray before = reg({"list"}).out;
    for (const char *name : {"machine 002", "000-002"}) {
        QCOMPARE(reg({"join", "000-001", "000-002"}).code, 0);
        QCOMPARE(machines(), 1);
        const CliResult none = reg({"separate", "000-001"}); // the others were joined with it
        QCOMPARE(none.code, 2);
        QCOMPARE(none.err.count('\n'), 1);
        QCOMPARE(machines(), 1);
        const CliResult result = reg({"separate", name});
        QVERIFY2(result.code == 0 && (result.out + result.err).isEmpty(), result.err);
        QCOMPARE(reg({"list"}).out, before);
        QCOMPARE(reg({"scan", folder, "--rebuild"}).code, 0);
        QCOMPARE(reg({"list"}).out, before);
    }
    // A file that is no list any more stays as it is.
    QCOMPARE(reg({"join", "000-001", "000-002"}).code, 0);
    const QByteArray damaged = R"({"format": "palmer machines", "machines": [{"joined": "x"}]})";
    write(folder + "/palmer-machines.json", damaged);
    const CliResult refused = reg({"separate", "000-002"});
    QCOMPARE(refused.code, 3);
    QVERIFY2(refused.err.contains("palmer-machines.json"), refused.err);
    QCOMPARE(contents(folder + "/palmer-machines.json"), damaged);
    QCOMPARE(machines(), 1);
}

/// Where the folder of the files cannot be written, it is said where else that is kept.
void RegisterCommandTest::whatIsSaidOfMachinesFindsAPlace() {
    const QString folder = m_dir->filePath("locked");
    QVERIFY(QDir().mkpath(folder + "/palmer-machines.json")); // a folder of that name: nobody can write it
    QVERIFY(QFile::copy(files() + "/machine 001/2018-11-20 X.palmer", folder + "/a.palmer"));
    const std::map<QString, QString> home{{"XDG_DATA_HOME", m_dir->filePath("data")}};
    const auto call = [&](const QStringList &words) {
        return runCli(QStringList{"register"} + words + QStringList{"--register", m_register}, {}, home);
    };
    (void)call({"scan", folder});
    const CliResult result = call({"interval", "1", "12"});
    QCOMPARE(result.code, 0);
    QCOMPARE(result.err, "palmer-cli: " + folder.toUtf8() + ": the folder cannot be written; kept in " +
                             m_dir->filePath("data/palmer/palmer-machines.json").toUtf8() + '\n');
    (void)call({"scan", folder, "--rebuild"});
    QVERIFY(call({"list", "--json"}).out.contains("\"due\": \"2019-11-20\""));
    // One that was damaged by hand is left as it is, and said; also that of the user.
    QVERIFY(QDir().rmdir(folder + "/palmer-machines.json"));
    write(folder + "/palmer-machines.json", "{");
    const CliResult damaged = call({"interval", "1", "6"});
    QCOMPARE(damaged.code, 0);
    QCOMPARE(damaged.err.count('\n'), 1);
    QVERIFY2(damaged.err.contains("locked/palmer-machines.json: ") && damaged.err.contains("; kept in ") &&
                 !damaged.err.contains("cannot be written"),
             damaged.err);
    QCOMPARE(contents(folder + "/palmer-machines.json"), QByteArray("{"));
    QVERIFY(call({"list", "--json"}).out.contains("\"due\": \"2019-05-20\""));
    write(m_dir->filePath("data/palmer/palmer-machines.json"), "[]");
    const CliResult nowhere = call({"interval", "1", "12"});
    QCOMPARE(nowhere.code, 3);
    QCOMPARE(nowhere.err.count('\n'), 1);
    QVERIFY2(nowhere.err.contains("data/palmer/palmer-machines.json: "), nowhere.err);
    QVERIFY(call({"list", "--json"}).out.contains("\"due\": \"2019-05-20\""));
}

/// What the table of evaluated files says, the list says in the same columns and words; in spreadsheets as
/// well.
void RegisterCommandTest::theListIsTheTable() {
    scan();
    const QString file = files() + "/machine 001/2018-11-20 X.palmer";
    const QList<QByteArray> list = reg({"list", "--csv", "--text", file}).out.split('\n');
    const auto tableOf = [](const QStringList &arguments) { // the register has no limits without a result
        QList<QByteArray> rows = runCli(arguments).out.split('\n');
        rows.removeIf([](const QByteArray &row) { return row.contains("notEvaluable"); });
        return rows;
    };
    const QList<QByteArray> table = tableOf({"evaluate", "--table", "csv", file});
    QCOMPARE(list.size(), table.size());
    QVERIFY(
        table.front().startsWith("file,test,machine,manufacturer,model,serialNumber,reportNumber,axis,date,"
                                 "edition,purpose,role,zone,parameter,value,U,limit,unit,limits,accordance"));
    for (qsizetype i = 0; i < list.size(); ++i)
        QVERIFY2(list[i].startsWith(table[i]), list[i] + '\n' + table[i]);
    QVERIFY(list[1].contains(",R-000000,X,2018-11-20,"));
    const QByteArray comma = reg({"list", "--csv", "--text", file, "--decimal-mark", "comma"}).out;
    QVERIFY(comma.startsWith("\xEF\xBB\xBF"
                             "file;test;machine;"));
    const QList<QByteArray> withComma =
        tableOf({"evaluate", "--table", "csv", "--decimal-mark", "comma", file});
    for (qsizetype i = 0; i < withComma.size(); ++i)
        QVERIFY2(comma.split('\n').value(i).startsWith(withComma[i]), withComma[i]);
    const QList<QByteArray> cells = comma.split('\n')[1].split(';');
    const QList<QByteArray> points = list[1].split(',');
    QCOMPARE(cells.size(), points.size());
    for (qsizetype i = 0; i < cells.size(); ++i)
        QCOMPARE(QByteArray(cells[i]).replace(',', '.'), points[i]);
    QVERIFY(cells[14].startsWith("0,0"));
    QByteArray zoned = contents(file);
    zoned.replace("\"kind\": \"positioning\"",
                  "\"kind\": \"positioning\", \"zone\": {\"from\": 0, \"to\": 500}");
    const QString folder = m_dir->filePath("zoned");
    QVERIFY(QDir().mkpath(folder));
    write(folder + "/a.palmer", zoned);
    QCOMPARE(reg({"scan", folder}).code, 0);
    QVERIFY(reg({"list", "--text", folder}).out.contains("0\u00A0…\u00A0500\u00A0mm"));
}

/// A drive that is not connected takes nothing away.
void RegisterCommandTest::pruningMostOfAFolderWantsForce() {
    const QString folder = m_dir->filePath("share/below");
    QVERIFY(QDir().mkpath(folder));
    for (const char *axis : {"X", "Y", "Z"}) {
        QVERIFY(QFile::copy(files() + QString("/machine 001/2018-11-20 %1.palmer").arg(axis),
                            folder + QString("/%1.palmer").arg(axis)));
        QVERIFY(QFile::copy(files() + QString("/machine 002/2018-11-20 %1.palmer").arg(axis),
                            m_dir->filePath(QString("share/%1.palmer").arg(axis))));
    }
    const QString share = m_dir->filePath("share");
    QCOMPARE(reg({"scan", share}).code, 0);
    QVERIFY(QFile::remove(folder + "/X.palmer")); // a third
    QVERIFY(objects(reg({"scan", share, "--prune", "--json"}).out).front()["pruned"].toInt() == 1);
    for (const char *axis : {"Y", "Z"}) // all of a folder that is still there, and two fifths of the share
        QVERIFY(QFile::remove(folder + QString("/%1.palmer").arg(axis)));
    const CliResult refused = reg({"scan", share, "--prune"});
    QCOMPARE(refused.code, 2);
    QCOMPARE(refused.err.count('\n'), 1);
    QVERIFY2(refused.err.contains("share/below: more than half"), refused.err);
    QCOMPARE(reg({"list", "--json"}).out.count('\n'), 5);
    QVERIFY(QDir(folder).removeRecursively()); // the folder, too
    QCOMPARE(reg({"scan", share, "--prune"}).code, 2);
    QCOMPARE(reg({"scan", share, "--prune", "--force"}).code, 0);
    QCOMPARE(reg({"list", "--json"}).out.count('\n'), 3);
    QVERIFY(QDir().mkpath(folder)); // moved, nothing is lost
    for (const char *axis : {"X", "Y", "Z"})
        QVERIFY(QFile::rename(m_dir->filePath(QString("share/%1.palmer").arg(axis)),
                              folder + QString("/%1.palmer").arg(axis)));
    QCOMPARE(reg({"scan", share, "--prune"}).code, 0);
    QCOMPARE(reg({"list", "--json"}).out.count('\n'), 3);
    QCOMPARE(reg({"list", "--files"}).out, QByteArray("All files of the register can be read.\n"));
}

void RegisterCommandTest::speaksFrench() {
    const QString broken = m_dir->filePath("broken");
    QDir().mkpath(broken);
    write(broken + "/x.palmer", "{");
    const CliResult result = reg({"scan", broken, "--language", "fr"});
    QCOMPARE(result.code, 3);
    QVERIFY2(result.out.contains("illisibles"), result.out.constData());
    QCOMPARE(result.err.count('\n'), 1);
    QVERIFY(result.err.contains("x.palmer"));
    const CliResult list = reg({"list", "--files", "--language", "fr"});
    QVERIFY(list.out.startsWith(broken.toUtf8() + "/x.palmer: "));
    const CliResult help = runCli({"register", "--help", "--language", "fr"});
    QCOMPARE(help.code, 0);
    QVERIFY(help.out.contains("registre"));
}

void RegisterCommandTest::aReportIsAPlaceOfItsTest() {
    const QString folder = m_dir->filePath("one");
    QDir().mkpath(folder);
    const QString test =
        objects((scan(), reg({"list", "--json", "--axis", "X"})).out).front()["file"].toString();
    QVERIFY(QFile::copy(test, folder + "/a.palmer"));
    QCOMPARE(runCli({"report", folder + "/a.palmer", "--language", "fr", "-o", folder + "/a.pdf"}).code & ~1,
             0);
    QVERIFY(QFile::copy(folder + "/a.pdf", folder + "/b.pdf"));
    m_register = m_dir->filePath("other.sqlite");
    QCOMPARE(reg({"scan", folder}).code, 0);
    const auto list = objects(reg({"list", "--json"}).out);
    QCOMPARE(list.size(), std::size_t{1});
    QCOMPARE(list.front()["places"].toArray().size(), 3);
}

/// Ended at any time, the register is whole, and the next scan completes it.
void RegisterCommandTest::killedItGoesOn() {
    scan();
    const QByteArray whole = reg({"list", "--json"}).out;
    const QString first = m_register;
    m_register = m_dir->filePath("killed.sqlite");
    std::mt19937 random(3);
    constexpr int times = 50;
    for (int i = 0; i < times; ++i) {
        if (i % 10 == 0) { // from the beginning again
            for (const char *ending : {"", "-wal", "-shm"})
                QFile::remove(m_register + ending);
        }
        QProcess process;
        process.start(PALMER_CLI, {"register", "scan", files(), "--register", m_register});
        process.waitForStarted();
        QTest::qSleep(static_cast<int>(random() % 400));
        ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
        process.waitForFinished();
        if (QFile::exists(m_register)) {
            const CliResult list = reg({"list", "--json"});
            QVERIFY2(list.code == 0 || list.err.contains("there is no register yet"), list.err);
        }
    }
    QCOMPARE(reg({"scan", files()}).code, 0);
    QCOMPARE(reg({"list", "--json"}).out, whole);
}

void RegisterCommandTest::whatVanishesIsSaidWhileWatching() {
    const QString folder = m_dir->filePath("watched");
    QVERIFY(QDir().mkpath(folder));
    for (const char *name : {"/a.palmer", "/b.palmer"})
        QVERIFY(QFile::copy(EXAMPLES "rotary-axis.palmer", folder + name));
    QProcess watching;
    watching.start(PALMER_CLI, {"register", "scan", folder, "--watch", "--register", m_register});
    const auto said = [&watching](const char *words) {
        QByteArray all;
        while (!all.contains(words) && watching.waitForReadyRead(patience))
            all += watching.readAllStandardOutput();
        return all.contains(words);
    };
    QVERIFY(said("Files: 2, of them read now: 2"));
    QVERIFY(QFile::remove(folder + "/b.palmer"));
    QVERIFY(said("Files: 1, of them read now: 0, unreadable: 0, not found: 1."));
    watching.kill();
    QVERIFY(watching.waitForFinished(patience));
}

void RegisterCommandTest::aFullDiskLosesNothing() {
    scan();
    const QByteArray before = reg({"list", "--json"}).out;
    const QString folder = m_dir->filePath("more");
    QDir().mkpath(folder);
    for (int i = 0; i < 40; ++i) {
        QByteArray copy = contents(files() + "/machine 001/2018-11-20 X.palmer");
        copy.replace("000-001", "100-" + QByteArray::number(i));
        write(folder + '/' + QString::number(i) + ".palmer", copy);
    }
    QProcess process;
    const auto limit = static_cast<rlim_t>(QFileInfo(m_register).size());
    process.setChildProcessModifier([limit] {
        const rlimit most{limit, limit};
        ::setrlimit(RLIMIT_FSIZE, &most);
    });
    process.start(PALMER_CLI, {"register", "scan", folder, "--register", m_register});
    QVERIFY(process.waitForFinished(patience));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    if (process.exitCode() != 0) { // what fits into the log may be written
        QCOMPARE(process.exitCode(), 3);
        QCOMPARE(process.readAllStandardError().count('\n'), 1);
    }
    QVERIFY(reg({"list", "--json"}).out.size() >= before.size());
    QCOMPARE(reg({"scan", folder}).code, 0);
    QCOMPARE(reg({"list", "--json"}).out.count('\n'), 280);
}

/// A register that cannot be made leaves no file, whether the disk is full at once or only later.
void RegisterCommandTest::aFullDiskLeavesNoEmptyRegister() {
    for (const rlim_t limit : {rlim_t{0}, rlim_t{5000}, rlim_t{20'000}}) {
        const QString folder = m_dir->filePath("full");
        QVERIFY(QDir().mkpath(folder));
        QProcess process;
        process.setChildProcessModifier([limit] {
            const rlimit most{limit, limit};
            ::setrlimit(RLIMIT_FSIZE, &most);
        });
        process.start(PALMER_CLI, {"register", "scan", files(), "--register", folder + "/new.sqlite"});
        QVERIFY(process.waitForFinished(patience));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 3);
        QCOMPARE(process.readAllStandardError().count('\n'), 1);
        for (const QFileInfo &left : QDir(folder).entryInfoList(QDir::Files))
            QVERIFY2(left.size() > 0, qPrintable(left.fileName()));
        QVERIFY(limit > 5000 || QDir(folder).entryList(QDir::Files).isEmpty());
        QVERIFY(QDir(folder).removeRecursively());
    }
}

void RegisterCommandTest::theHistoryIsPrinted() {
    scan();
    const QString pdf = m_dir->filePath("history.pdf");
    QCOMPARE(reg({"report", "--machine", "000-001", "--language", "fr,en", "-o", pdf}).code, 0);
    struct Expected {
        const char *language;
        std::vector<QByteArray> words;
    };
    for (const Expected &one :
         {Expected{"fr",
                   {"Historique : Machine 001", "À surveiller d’abord", "Campagnes", "pas avant", "X 10"}},
          Expected{"en", {"History of Machine 001", "To watch first", "Campaigns", "not before", "X 10"}}}) {
        QProcess text;
        text.start("pdftotext", {m_dir->filePath("history.") + one.language + ".pdf", "-"});
        QVERIFY(text.waitForFinished(patience));
        const QByteArray words = text.readAllStandardOutput().replace("\u00A0", " ");
        for (const QByteArray &word : one.words)
            QVERIFY2(words.contains(word), word + "\n" + words);
    }
    // The same register gives the same bytes.
    const QByteArray first = contents(m_dir->filePath("history.fr.pdf"));
    QCOMPARE(reg({"report", "--machine", "000-001", "--language", "fr", "-o", pdf}).code, 0);
    QCOMPARE(contents(pdf), first);
}

/// It carries the values it shows and is composed again from them.
void RegisterCommandTest::aHistoryProvesItself() {
    scan();
    const QString pdf = m_dir->filePath("history.pdf");
    const QString data = m_dir->filePath("history.json");
    QCOMPARE(reg({"report", "--machine", "000-001", "--language", "fr", "-o", pdf}).code, 0);
    const CliResult verified = runCli({"verify", pdf, "--language", "en"});
    QVERIFY2(verified.code == 0 && verified.out.contains("The trend follows from the attached values"),
             verified.out + verified.err);
    QCOMPARE(runCli({"verify", pdf, "--extract", data}).code, 0);
    const QJsonObject history = QJsonDocument::fromJson(contents(data)).object();
    QCOMPARE(history["format"].toString(), QString("palmer history"));
    QVERIFY(history["tests"].toArray().size() > 5);
    QVERIFY2(!contents(data).contains(m_dir->path().toUtf8()), "no folder of this machine goes out");
    const CliResult opened = runCli({"evaluate", pdf});
    QVERIFY2(opened.code == 3 && opened.err.contains("history of a machine"), opened.err);
}

/// Above every trend stands the quantity that exceeds its limit now, with value, U and limit.
void RegisterCommandTest::whatIsExceededComesFirst() {
    QFile example(QStringLiteral(PALMER_SOURCE_DIR "/resources/examples/rotary-axis.palmer"));
    QVERIFY(example.open(QIODevice::ReadOnly));
    QJsonObject file = QJsonDocument::fromJson(example.readAll()).object();
    QJsonArray tests = file["tests"].toArray();
    QJsonObject test = tests[0].toObject();
    test["limits"] = QJsonObject{{"A", QJsonObject{{"value", 0.0001}}}};
    tests[0] = test;
    file["tests"] = tests;
    const QString folder = m_dir->filePath("exceeded");
    QVERIFY(QDir().mkpath(folder));
    write(folder + "/one.palmer", QJsonDocument(file).toJson());
    QCOMPARE(reg({"scan", folder}).code, 0);
    const QString pdf = m_dir->filePath("history.pdf");
    QCOMPARE(reg({"report", "--machine", "000-002", "--language", "en", "-o", pdf}).code, 0);
    QProcess text;
    text.start("pdftotext", {pdf, "-"});
    QVERIFY(text.waitForFinished(patience));
    const QByteArray words = text.readAllStandardOutput().replace("\u00A0", " ");
    for (const char *word : {"Exceeded at the last test", "A of C: 8.1", "0.36″", "End of the history"})
        QVERIFY2(words.contains(word), words);
}

void RegisterCommandTest::theNumberOfAHistory_data() {
    QTest::addColumn<QString>("machine");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QStringList>("printed"); ///< somewhere
    QTest::addColumn<QStringList>("absent");
    const QString year = QString::number(QDate::currentDate().year());
    QTest::newRow("proposed: year and serial number")
        << "000-001" << QStringList{}
        << QStringList{"History No. HI-" + year + "-000-001", "History HI-" + year} << QStringList{};
    QTest::newRow("given") << "000-001" << QStringList{"--number", "  Q 17  / b "}
                           << QStringList{"History No. Q 17 / b", "History Q 17 / b"} << QStringList{"HI-"};
    QTest::newRow("none") << "000-001" << QStringList{"--number", ""} << QStringList{"History of Machine 001"}
                          << QStringList{"No. ", "HI-"};
    QTest::newRow("as long as it may be") << "000-001" << QStringList{"--number", QString(40, '7')}
                                          << QStringList{QString(40, '7')} << QStringList{};
}

void RegisterCommandTest::theNumberOfAHistory() {
    QFETCH(QString, machine);
    QFETCH(QStringList, options);
    QFETCH(QStringList, printed);
    QFETCH(QStringList, absent);
    scan();
    const QString pdf = m_dir->filePath("history.pdf");
    QCOMPARE(reg(QStringList{"report", "--machine", machine, "--language", "en", "-o", pdf} + options).code,
             0);
    QProcess text;
    text.start("pdftotext", {"-layout", pdf, "-"});
    QVERIFY(text.waitForFinished(patience));
    const QString words = QString::fromUtf8(text.readAllStandardOutput()).replace(QChar::Nbsp, ' ');
    const auto joined = [](QString all) { return all.remove(QRegularExpression("\\s")); }; // lines may break
    for (const QString &word : printed)
        QVERIFY2(joined(words).contains(joined(word)), qPrintable(word + "\n" + words));
    for (const QString &word : absent)
        QVERIFY2(!words.contains(word), qPrintable(word + "\n" + words));
    // It is the title of the document, too.
    if (!options.isEmpty() && !options.last().trimmed().isEmpty())
        QVERIFY(runPdfinfo(pdf).contains(options.last().simplified().toUtf8()));
}

void RegisterCommandTest::theTypeOnPaper() {
    QProcess script;
    script.start("python3", {QStringLiteral(PALMER_SOURCE_DIR "/tests/benchmarks/registerfiles.py"),
                             m_dir->filePath("types"), "--files", "54", "--machines", "9"});
    QVERIFY(script.waitForFinished(patience));
    QCOMPARE(reg({"scan", m_dir->filePath("types")}).code, 0);
    const QStringList words{"type", "--type", "Maker A CU 1000", "--parameter", "A", "--axis", "X"};
    const QString pdf = m_dir->filePath("type.pdf");
    QCOMPARE(reg(words + QStringList{"-o", pdf}).code, 0);
    QVERIFY(runPdfinfo(pdf).contains("Type test of Maker A CU 1000"));
    const QString svg = m_dir->filePath("type.svg");
    QCOMPARE(reg(words + QStringList{"-o", svg}).code, 0);
    QVERIFY(contents(svg).startsWith("<?xml"));
    QCOMPARE(reg({"type", "--type", "Maker A CU 1000", "--parameter", "A", "-o", svg}).code, 2); // three axes
    const QString examples = QStringLiteral(PALMER_SOURCE_DIR "/resources/examples/");
    const CliResult unnamed = runCli({"register", "type", examples + "teaching-01-centre.palmer",
                                      examples + "teaching-02-radius.palmer", "--parameter", "G"});
    QCOMPARE(unnamed.code, 2);
    QVERIFY2(unnamed.err.contains("do not state the model"), unnamed.err);
}

void RegisterCommandTest::whatChangedSinceTheLastTest() {
    const QString folder = m_dir->filePath("changes");
    QVERIFY(QDir().mkdir(folder) &&
            QFile::copy(PALMER_SOURCE_DIR "/resources/examples/x-axis-as-found-as-left.palmer",
                        folder + "/x.palmer"));
    QCOMPARE(reg({"scan", folder}).code, 0);
    const auto plain = objects(reg({"list", "--json"}).out);
    QVERIFY(plain.at(1)["sinceLast"].isNull());
    const auto list = objects(reg({"list", "--json", "--since-last"}).out);
    QCOMPARE(list.size(), std::size_t(2));
    QVERIFY(list[0]["sinceLast"].isNull()); // the first one
    QCOMPARE(list[1]["sinceLast"]["word"].toString(), "better");
    QCOMPARE(list[1]["sinceLast"]["date"].toString(), "2026-11-20");
    QVERIFY(reg({"list", "--since-last", "--language", "fr"}).out.contains("changé, mieux"));
    // CSV and trend say it of each parameter, as the comparison itself does.
    const QJsonArray parameters = list[1]["sinceLast"]["parameters"].toArray();
    const QJsonObject a = parameters.at(0).toObject();
    QCOMPARE(a["id"].toString(), "A");
    const auto rows = [](const QByteArray &csv) {
        std::vector<QMap<QString, QString>> all;
        const QList<QByteArray> lines = csv.trimmed().split('\n');
        const QList<QByteArray> head = lines.front().split(',');
        for (qsizetype i = 1; i < lines.size(); ++i) {
            QMap<QString, QString> row;
            for (qsizetype k = 0; k < head.size(); ++k)
                row[QString::fromUtf8(head[k])] = QString::fromUtf8(lines[i].split(',').value(k));
            all.push_back(row);
        }
        return all;
    };
    const auto isOfA = [&](const QMap<QString, QString> &row) {
        return row["date"] == "2026-11-23" && row["parameter"] == "A";
    };
    const QString out = m_dir->filePath("trend.csv");
    QCOMPARE(reg({"trend", "--machine", "000-017", "--axis", "X", "--since-last", "-o", out}).code, 0);
    for (const QByteArray &csv : {reg({"list", "--csv", "--since-last"}).out, contents(out)}) {
        const auto all = rows(csv);
        const auto row = std::ranges::find_if(all, isOfA);
        QVERIFY2(row != all.end(), csv.constData());
        QCOMPARE((*row)["lastDate"], "2026-11-20");
        QCOMPARE((*row)["sinceLast"], "better");
        QCOMPARE((*row)["difference"].toDouble(), a["difference"].toDouble());
        QCOMPARE((*row)["differenceU"].toDouble(), a["expandedUncertainty"].toDouble());
    }
    QVERIFY(reg({"list", "--csv", "--since-last", "--decimal-mark", "comma"}).out.contains(";better;-0,00"));
    const auto trend = objects(
        reg({"trend", "--machine", "000-017", "--axis", "X", "--parameter", "A", "--since-last", "--json"})
            .out);
    const QJsonArray series = trend.front()["series"].toArray(); // the compensation differs
    const auto since = [&](int of) { return series.at(of)["points"].toArray().at(0)["sinceLast"]; };
    QVERIFY(since(1).isNull());
    QCOMPARE(since(0)["word"].toString(), "better");
    QCOMPARE(since(0)["difference"], a["difference"]);
    QVERIFY(reg({"trend", "--machine", "000-017", "--axis", "X", "--parameter", "A", "--since-last",
                 "--language", "en"})
                .out.contains("changed, better"));
    QCOMPARE(reg({"trend", "--machine", "000-017", "--axis", "X", "--since-last", "--edition", "2014"}).code,
             2);
}

void RegisterCommandTest::theTypeOfFiles() {
    const QString folder = PALMER_SOURCE_DIR "/resources/typetest";
    const auto type = [&](const QStringList &words) {
        return runCli(QStringList{"register", "type", "--parameter", "A"} + words);
    };
    const CliResult json = type({folder, "--json"});
    QCOMPARE(json.err, QByteArray());
    QCOMPARE(json.code, 0);
    const QJsonObject found = objects(json.out).front();
    QCOMPARE(found["machines"].toArray().size(), 8);
    QVERIFY(!found["statistics"]["normality"]["values"].isNull());
    // The same as from a register of these files.
    QCOMPARE(reg({"scan", folder}).code, 0);
    QCOMPARE(reg({"type", "--type", "VC 500", "--parameter", "A", "--json"}).out, json.out);
    QCOMPARE(objects(type({folder + "/machine-101.palmer", folder + "/machine-102.palmer",
                           folder + "/machine-103.palmer", "--json"})
                         .out)
                 .front()["machines"]
                 .toArray()
                 .size(),
             3);
    QCOMPARE(type({folder, "--type", "none"}).code, 2);
    QCOMPARE(type({folder, PALMER_SOURCE_DIR "/resources/examples/rotary-axis.palmer"}).code,
             2); // another type
    QCOMPARE(type({folder, "--register", m_dir->filePath("r.sqlite")}).code, 2);
    const CliResult missing = type({folder, m_dir->filePath("missing.palmer")});
    QCOMPARE(missing.code, 3);
    QVERIFY(missing.err.contains("missing.palmer") && missing.out.contains("Machine 101"));
}

/// Each part stands in the help, whose help is there.
void RegisterCommandTest::eachPartHasItsHelp() {
    const QString words =
        QString::fromUtf8(runCli({"register", "--help"}, {}, {{"COLUMNS", "1000"}}).out).section('\n', 0, 0);
    const QStringList parts = words.section(' ', -2, -2).split('|');
    QVERIFY(parts.contains("interval") && parts.contains("scan"));
    for (const QString &part : parts) {
        const CliResult help = runCli({"register", part, "--help"});
        QCOMPARE(help.code, 0);
        QVERIFY2(help.out.contains(("\n  palmer-cli register " + part).toUtf8()), qPrintable(part));
    }
}

void RegisterCommandTest::theTestOfAType() {
    QProcess script; // three machines of each maker
    script.start("python3", {QStringLiteral(PALMER_SOURCE_DIR "/tests/benchmarks/registerfiles.py"),
                             m_dir->filePath("types"), "--files", "54", "--machines", "9"});
    QVERIFY(script.waitForFinished(patience));
    QCOMPARE(reg({"scan", m_dir->filePath("types")}).code, 0);
    const QStringList words{"type", "--type", " maker a  CU 1000", "--parameter", "A"};
    const CliResult json = reg(words + QStringList{"--json"});
    QCOMPARE(json.err, QByteArray());
    QCOMPARE(json.code, 0);
    const auto axes = objects(json.out);
    QCOMPARE(axes.size(), std::size_t{3});
    for (const QJsonObject &axis : axes) {
        const QJsonArray machines = axis["machines"].toArray();
        QCOMPARE(machines.size(), 3);
        double sum = 0;
        for (const auto &entry : machines) {
            const QJsonObject machine = entry.toObject();
            sum += machine["value"].toDouble();
            // The value is that of the command evaluate, the test the newest of its machine and axis.
            const auto file = objects(runCli({"evaluate", "--json-lines", machine["file"].toString()}).out);
            const QJsonObject its =
                file.front()["tests"].toArray().at(machine["test"].toInt() - 1).toObject();
            QCOMPARE(its["parameters"].toArray().at(0)["value"].toDouble(), machine["value"].toDouble());
            QCOMPARE(its["date"], machine["date"]);
            const auto newest = objects(reg({"list", "--json", "--axis", axis["axis"].toString(), "--machine",
                                             machine["machine"]["name"].toString()})
                                            .out);
            QCOMPARE(newest.back()["date"], machine["date"]);
        }
        const QJsonObject statistics = axis["statistics"].toObject();
        QVERIFY(std::abs(statistics["mean"].toDouble() - sum / 3) < 1e-15);
        QVERIFY(std::abs(statistics["factor"].toDouble() - 7.6559) < 1e-4);
        QCOMPARE(statistics["limit"], statistics["logNormalLimit"]);
        QVERIFY(statistics["normality"]["values"].isNull());
    }
    const auto normal =
        objects(reg(words + QStringList{"--json", "--axis", "x", "--distribution", "normal", "--content",
                                        "0.9", "--confidence", "0.9", "--edition", "2006"})
                    .out);
    QCOMPARE(normal.size(), std::size_t{1});
    QCOMPARE(normal.front()["edition"].toString(), QString("ISO 230-2:2006"));
    QCOMPARE(normal.front()["statistics"]["limit"], normal.front()["statistics"]["normalLimit"]);
    QVERIFY(normal.front()["statistics"]["factor"].toDouble() < 4.3); // 4.258

    write(m_dir->filePath("types.jsonl"), json.out);
    QProcess validator;
    validator.start("python3", {PALMER_SOURCE_DIR "/tests/core/document/validate.py",
                                PALMER_SOURCE_DIR "/resources/schema/palmer-type-1.schema.json",
                                m_dir->filePath("types.jsonl")});
    QVERIFY(validator.waitForFinished(patience));
    QCOMPARE(validator.readAllStandardOutput(), QByteArray("1\n1\n1\n"));

    const QByteArray text = reg(words + QStringList{"--language", "en"}).out;
    for (const char *said : {"Interpretation", "Tolerance limit, log-normal", "Machine 001", "Machine 007"})
        QVERIFY2(text.contains(said), said);
    const QByteArray french = reg(words + QStringList{"--language", "fr"}).out;
    QVERIFY2(french.contains("Limite de tolérance"), french.constData());
}

void RegisterCommandTest::aPictureOfATrend_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QByteArray>("begins");
    QTest::newRow("svg") << "svg" << QByteArray("<?xml");
    QTest::newRow("png") << "png" << QByteArray("\x89PNG");
    QTest::newRow("pdf") << "pdf" << QByteArray("%PDF");
}

void RegisterCommandTest::aPictureOfATrend() {
    QFETCH(QString, ending);
    QFETCH(QByteArray, begins);
    scan();
    const QString file = m_dir->filePath("trend.") + ending;
    QCOMPARE(reg({"trend", "--machine", "000-001", "--axis", "X", "--parameter", "A", "-o", file}).code, 0);
    QVERIFY(contents(file).startsWith(begins));
    const CliResult several = reg({"trend", "--machine", "000-001", "--axis", "X", "-o", file});
    QCOMPARE(several.code, 2);
    QVERIFY(several.err.contains("one parameter"));
}

void RegisterCommandTest::theUsersRegisterStandsInHisData() {
    const std::map<QString, QString> home{{"XDG_DATA_HOME", m_dir->filePath("data")}};
    QCOMPARE(runCli({"register", "scan", files()}, {}, home).code, 0);
    QVERIFY(QFile::exists(m_dir->filePath("data/palmer/register.sqlite")));
    QCOMPARE(runCli({"register", "list", "--json", "--axis", "X"}, {}, home).out.count('\n'), 60);
    for (const char *part : {"list", "trend", "report"}) {
        const CliResult none = runCli({"register", part, "--machine", "1", "--axis", "X", "-o", "x.pdf"}, {},
                                      {{"XDG_DATA_HOME", m_dir->filePath("nothing")}});
        QCOMPARE(none.code, part == QByteArray("trend") ? 3 : 2); // list takes no -o, report no --axis
    }
    const CliResult none = runCli({"register", "list"}, {}, {{"XDG_DATA_HOME", m_dir->filePath("nothing")}});
    QCOMPARE(none.code, 3);
    QVERIFY(none.err.contains("no register yet"));
    QVERIFY(!QFile::exists(m_dir->filePath("nothing")));
    // What is no register is left as it is.
    const QString letter = m_dir->filePath("letter.txt");
    write(letter, "dear reader\n");
    const CliResult refused = runCli({"register", "scan", files(), "--register", letter});
    QCOMPARE(refused.code, 3);
    QVERIFY(refused.err.contains("no register"));
    QCOMPARE(contents(letter), QByteArray("dear reader\n"));
    // What cannot be opened may well be one.
    const QString own = m_dir->filePath("own.db");
    QCOMPARE(runCli({"register", "scan", files(), "--register", own}).code, 0);
    QVERIFY(QDir().mkdir(own + "-wal"));
    const CliResult unopened = runCli({"register", "list", "--register", own});
    QCOMPARE(unopened.code, 3);
    QVERIFY2(unopened.err.contains("cannot be opened"), unopened.err);
}

void RegisterCommandTest::nothingIsWrittenIntoFiles() {
    const QString file = files() + "/machine 001/2018-11-20 X.palmer";
    const QByteArray before = contents(file);
    const QDateTime time = QFileInfo(file).lastModified();
    const qsizetype entries = QDir(files() + "/machine 001").entryList(QDir::Files | QDir::Hidden).size();
    scan();
    (void)reg({"trend", "--machine", "000-001", "--axis", "X", "--edition", "ISO 230-2:2006"});
    QCOMPARE(contents(file), before);
    QCOMPARE(QFileInfo(file).lastModified(), time);
    QCOMPARE(QDir(files() + "/machine 001").entryList(QDir::Files | QDir::Hidden).size(), entries);
}

QTEST_GUILESS_MAIN(RegisterCommandTest)
#include "registercommandtest.moc"
