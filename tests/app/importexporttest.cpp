// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer::testdata;

namespace {

struct Result {
    int code = -1;
    QString out;
    QString err;
};

Result run(const QStringList &arguments, const QByteArray &input = {}, const QString &configuration = {}) {
    std::map<QString, QString> environment;
    if (!configuration.isEmpty())
        environment["XDG_CONFIG_HOME"] = configuration;
    const auto result = runCli(arguments, input, environment);
    return {result.code, result.out, result.err};
}

QJsonObject document(const QString &name) {
    return QJsonDocument::fromJson(contents(name)).object();
}

} // namespace

class ImportExportTest : public QObject {
    Q_OBJECT

private slots:
    void importsFilesIntoOneDocument();
    void takesChoicesAndProfiles();
    void refusesUntilQuestionsAreAnswered();
    void saysWhatItTookAndWhatAnswers();
    void quotesInTheLanguage();
    void refusesInOneLineAndWritesNothing();
    void readsMeasurementFilesWhereverFilesStand();
    void exportsEveryForm_data();
    void exportsEveryForm();
    void namesWhatACertificateLacks();
    void asksForWhatATableOwes();
    void asksForASignThatWasAssumed();
    void inventsNoDirection();
    void writesTheProgramOfTheTestItself();
    void sensorsWithoutANameComeBackFromCsv();
    void comparesWithTheTableOfAControl();
    void writesThePointsOfAFigure();
    void refusesHugeFilesAtOnce();

private:
    [[nodiscard]] QString at(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

void ImportExportTest::importsFilesIntoOneDocument() {
    // The temperatures come first and still find their test.
    const Result result = run({"import", DATA "tables/temperatures.csv", DATA "rtl/typical.rtl",
                               DATA "rtx/typical.rtx", "-o", at("a.palmer"), "--keep-original", "--accept",
                               "--set", "correctionTo20=applied by the instrument"});
    QVERIFY2(result.code == 0, qPrintable(result.err));
    QVERIFY(result.err.contains("typical.rtl: Understood: targets: 3; runs ↑: 2; runs ↓: 2."));
    QVERIFY(result.out.isEmpty());
    const QJsonObject file = document(at("a.palmer"));
    const QJsonArray tests = file["tests"].toArray();
    QCOMPARE(tests.size(), 2);
    QCOMPARE(tests[0]["kind"].toString(), "positioning");
    QCOMPARE(tests[0]["conditions"]["correctionTo20"].toString(), "applied by the instrument");
    QCOMPARE(tests[0]["conditions"]["sensors"].toArray().size(), 6);
    QCOMPARE(tests[0]["imports"].toArray().size(), 2);
    QCOMPARE(QByteArray::fromBase64(tests[0]["imports"][0]["data"].toString().toLatin1()),
             contents(DATA "rtl/typical.rtl"));
    QCOMPARE(tests[1]["kind"].toString(), "drift");
    QCOMPARE(file["machine"]["name"].toString(), "Mill 5");
    // What was written is a test file.
    QCOMPARE(run({"evaluate", at("a.palmer")}).code, 0);
}

void ImportExportTest::takesChoicesAndProfiles() {
    const QByteArray table = "0\t1\n100\t2\n";
    const Result chosen = run({"import", "-", "-o", at("b.palmer"), "--set", "unit=nm", "--set", "axis=Z",
                               "--set=directions=negative", "--accept"},
                              table);
    QVERIFY2(chosen.code == 0, qPrintable(chosen.err));
    const QJsonValue test = document(at("b.palmer"))["tests"][0];
    QCOMPARE(test["axis"]["name"].toString(), "Z");
    QCOMPARE(test["runs"][0]["approach"].toString(), "negative");
    QCOMPARE(test["runs"][0]["deviations"][1].toDouble(), 2e-6);
    const QString configuration = m_folder.path();
    QVERIFY(QDir(configuration).mkpath("palmer"));
    write(configuration + "/palmer/import-profiles.json",
          R"({"version": 1, "profiles": {"laser 2": {"unit": "um", "axis": "Y"}}})");
    const Result profile =
        run({"import", "-", "-o", at("c.palmer"), "--profile", "laser 2", "--set", "axis=W", "--accept"},
            table, configuration);
    QVERIFY2(profile.code == 0, qPrintable(profile.err));
    QCOMPARE(document(at("c.palmer"))["tests"][0]["axis"]["name"].toString(), "W");
    QCOMPARE(document(at("c.palmer"))["tests"][0]["runs"][0]["deviations"][1].toDouble(), 0.002);
    for (const QStringList &wrong :
         {QStringList{"--set", "unit=furlong"}, QStringList{"--set", "unit"},
          QStringList{"--set", "colour=blue"}, QStringList{"--profile", "unknown"}})
        QCOMPARE(run(QStringList{"import", "-", "-o", at("d.palmer")} + wrong, table, configuration).code, 2);
    QCOMPARE(run({"import", "-"}, table).code, 2);
}

void ImportExportTest::refusesUntilQuestionsAreAnswered() {
    const QByteArray table = "P (mm);1↑;1↓\n0;1;2\n100;3;4\n";
    const QStringList import{"import", "-", "-o", at("q.palmer")};
    const Result open = run(import, table);
    QCOMPARE(open.code, 3);
    QVERIFY(!QFile::exists(at("q.palmer")));
    QVERIFY(open.err.contains("--set unit=um"));
    QVERIFY(open.err.contains("--set content=deviations"));
    QVERIFY(open.err.contains("2 questions are open"));
    const QStringList unit{"--set", "unit=um"};
    const Result one = run(import + unit, table);
    QCOMPARE(one.code, 3);
    QVERIFY2(one.err.contains("1 question is open"), qPrintable(one.err));
    QCOMPARE(run(import + unit + QStringList{"--set", "content=deviations"}, table).code, 0);
    QVERIFY(QFile::remove(at("q.palmer")));
    QCOMPARE(run(import + QStringList{"--accept"}, table).code, 0);
    QVERIFY(QFile::remove(at("q.palmer")));
    // A doubt is not taken with the rest: it wants an answer of its own.
    const QByteArray large = "P (mm);1↑ (mm);1↓ (mm)\n0;1;2\n100;3;4\n";
    const Result doubtful = run(import + QStringList{"--accept"}, large);
    QCOMPARE(doubtful.code, 3);
    QVERIFY2(doubtful.err.contains("--set large=keep"), qPrintable(doubtful.err));
    QCOMPARE(run(import + QStringList{"--accept", "--set", "large=keep"}, large).code, 0);
    QVERIFY(QFile::remove(at("q.palmer")));
    // Lines and tables are chosen; what is no line is refused.
    const QByteArray two = "P (mm);1↑ (µm);1↓ (µm)\n0;1;2\n100;3;4\n\nNo.;Feed;Power\n1;500;3\n2;600;4\n";
    QCOMPARE(run(import + QStringList{"--accept"}, two).code, 3);
    for (const char *choice : {"lines=1-3", "table=1", "table=keep"}) {
        QCOMPARE(run(import + QStringList{"--set", choice}, two).code, 0);
        QVERIFY(QFile::remove(at("q.palmer")));
    }
    for (const char *choice : {"lines=3-1", "lines=x", "table=3"})
        QVERIFY(run(import + QStringList{"--accept", "--set", choice}, two).code > 1);
    // Never half a table: what was not read is no proposal.
    const QByteArray broken = "P (mm);1↑ (µm);1↓ (µm)\n0;1;2\n100;3,,5;4\n";
    QCOMPARE(run(import + QStringList{"--accept"}, broken).code, 3);
    QVERIFY(!QFile::exists(at("q.palmer")));
    QCOMPARE(run(import + QStringList{"--accept", "--set", "unread=leave"}, broken).code, 0);
    // Every command that reads foreign files asks.
    for (const QStringList &command :
         {QStringList{"evaluate", "-"}, QStringList{"check", "-"},
          QStringList{"report", "-", "-o", at("q.pdf")}, QStringList{"figure", "-", "-o", at("q.svg")},
          QStringList{"export", "-", "--as", "csv", "-o", "-"}}) {
        QCOMPARE(run(command, table).code, 3);
        QVERIFY(run(command + QStringList{"--accept"}, table).code < 2);
    }
}

void ImportExportTest::saysWhatItTookAndWhatAnswers() {
    const QByteArray table =
        "target (mm),dir,run,deviation (um)\n0,1,1,1\n100,1,1,2\n0,0,1,2\n100,0,1,3\n"; // both ascend
    const QStringList import{"import", "-", "-o", at("e.palmer"), "--json"};
    const Result result = run(import, table);
    const QJsonValue file = QJsonDocument::fromJson(result.out.toUtf8())["files"][0];
    QCOMPARE(file["choices"]["edition"]["value"].toString(), "ISO 230-2:2014");
    QCOMPARE(file["choices"]["edition"]["origin"].toString(), "guessed");
    QVERIFY2(result.err.contains("Edition: nothing in the file says it; ISO 230-2:2014 is taken."),
             qPrintable(result.err));
    QVERIFY(
        run(import + QStringList{"--language", "fr"}, table).err.contains("l’ISO 230-2:2014 est retenue"));
    // The same answers in JSON and on the terminal.
    QVERIFY(!file["questions"].toArray().isEmpty());
    for (const QJsonValue &question : file["questions"].toArray()) {
        QStringList answers;
        for (const QJsonValue &answer : question["answers"].toArray())
            answers << answer.toString();
        QVERIFY(answers.size() > 1);
        const QString line =
            QString("Answers for --set %1=…: %2.").arg(question["key"].toString(), answers.join(", "));
        QVERIFY2(result.err.contains(line), qPrintable(line));
    }
    const Result chosen = run(import + QStringList{"--set", "edition=ISO 230-2:2006"}, table);
    QCOMPARE(
        QJsonDocument::fromJson(chosen.out.toUtf8())["files"][0]["choices"]["edition"]["origin"].toString(),
        "chosen");
    QVERIFY(!chosen.err.contains("Edition: nothing"));
}

void ImportExportTest::quotesInTheLanguage() {
    const Result refused = run({"import", "-", "-o", at("f.palmer"), "--language", "fr"},
                               "Position (mm);Position (mm)\n0;1\n100;2\n");
    QVERIFY2(refused.err.contains(QString("1 «\u00a0Position (mm)\u00a0»")), qPrintable(refused.err));
    QVERIFY(!refused.err.contains("“"));
    const Result schema = run({"schema", "--language", "fr"});
    QVERIFY(schema.out.contains("«\u00a0palmer results\u00a0»") && !schema.out.contains("“"));
}

void ImportExportTest::refusesInOneLineAndWritesNothing() {
    const Result noTemplate = run({"import", DATA "rtl/typical.rtl", "--accept", "--template",
                                   at("nowhere.palmer-template"), "-o", at("none")});
    QCOMPARE(noTemplate.code, 3);
    QCOMPARE(noTemplate.err.count('\n'), 1);
    QVERIFY(noTemplate.err.contains("nowhere.palmer-template") && !QFile::exists(at("none")));
    for (const QString name : {"empty.csv", "binary.csv", "cut-off.rtl", "entities.b5r", "bomb.xlsx",
                               "repeats.ods", "ballbar.b5r64", "document.palmer"}) {
        const Result result = run({"import", DATA "refused/" + name, "-o", at("none.palmer")});
        QCOMPARE(result.code, 3);
        QCOMPARE(result.err.count('\n'), 1);
        QVERIFY(result.err.startsWith("palmer-cli: "));
        QVERIFY(!QFile::exists(at("none.palmer")));
    }
    // One bad file of several: nothing is written half.
    QCOMPARE(run({"import", DATA "rtl/typical.rtl", DATA "refused/empty.csv", "-o", at("none.palmer")}).code,
             3);
    QVERIFY(!QFile::exists(at("none.palmer")));
}

void ImportExportTest::readsMeasurementFilesWhereverFilesStand() {
    const Result file =
        run({"evaluate", "--json", DATA "tables/typical.csv", "--accept", "--set", "unread=leave"});
    QVERIFY2(file.code == 0, qPrintable(file.err));
    const Result piped = run({"evaluate", "--json", "-", "--accept", "--set", "unread=leave"},
                             contents(DATA "tables/typical.csv"));
    const QJsonValue a = QJsonDocument::fromJson(file.out.toUtf8())["tests"];
    QCOMPARE(a, QJsonDocument::fromJson(piped.out.toUtf8())["tests"]);
    QVERIFY(a[0]["parameters"].toArray().size() > 5);
    QVERIFY(file.err.contains("typical.csv: 7:7: “-4,,7” is not a number."));
    QCOMPARE(run({"check", DATA "workbooks/typical.xlsx", "--accept", "--set", "unread=leave"}).code,
             0); // of an edition whose text was not read nothing is unmet
    QCOMPARE(run({"evaluate", DATA "b5r/typical-absolute.b5r", "--accept"}).code, 0);
}

void ImportExportTest::exportsEveryForm_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("contained");
    QTest::newRow("CSV") << QStringList{"--as", "csv"} << "2,100,0.0002,";
    QTest::newRow("CSV with comma") << QStringList{"--as", "csv", "--decimal-mark", "comma"}
                                    << "2;100;0,0002;";
    QTest::newRow("JSON") << QStringList{"--as", "json"} << R"("approach": "positive")";
    QStringList stated{"--as", "dcc"};
    for (const char *statement :
         {"report.number=R-1", "report.place=Hall 2", "report.performedFrom=2026-11-20",
          "report.laboratory.name=Laboratory", "report.laboratory.country=FR",
          "report.customer.name=Customer", "report.customer.address=Street 1",
          "report.authorisedBy.name=B. Durand", "machine.name=M1", "machine.manufacturer=Maker",
          "machine.serialNumber=123"})
        stated << "--set" << statement;
    QTest::newRow("digital calibration certificate")
        << stated << "<dcc:uniqueIdentifier>R-1</dcc:uniqueIdentifier>";
    QTest::newRow("LinuxCNC") << QStringList{"--as", "linuxcnc", "--per-direction"} << "0 -0.0025 0.0017\n";
    QTest::newRow("Weihong") << QStringList{"--as", "weihong", "--per-direction"}
                             << "unit = mm\n[X]\n0, 0.0025, -0.0017\n";
    QTest::newRow("Siemens") << QStringList{"--as", "siemens", "--interval", "50", "--reference", "0"}
                             << "$AA_ENC_COMP_STEP[0,X]=50\n";
    QTest::newRow("compensation as CSV")
        << QStringList{"--as", "compensation-csv", "--incremental", "--deviations"}
        << "form=incremental sign=deviation";
}

void ImportExportTest::exportsEveryForm() {
    QFETCH(QStringList, options);
    QFETCH(QString, contained);
    const Result result = run(QStringList{"export", DATA "rtl/typical.rtl", "--accept", "-o", "-"} + options);
    QVERIFY2(result.code == 0, qPrintable(result.err));
    QVERIFY2(result.out.contains(contained), qPrintable(result.out));
    const bool predicts = !options.contains("csv") && !options.contains("json") && !options.contains("dcc");
    QCOMPARE(result.err.contains("predicted with the compensation applied:"), predicts);
    QVERIFY(!predicts || result.err.contains("palmer-cli: E: "));
    const Result saved =
        run(QStringList{"export", DATA "rtl/typical.rtl", "--accept", "-o", at("out")} + options);
    QCOMPARE(QString::fromUtf8(contents(at("out"))), result.out);
    QVERIFY(saved.out.isEmpty());
}

void ImportExportTest::namesWhatACertificateLacks() {
    const QString file = at("certificate.xml");
    const Result result = run({"export", DATA "rtl/typical.rtl", "--accept", "--as", "dcc", "-o", file,
                               "--set", "report.number=R-1", "--language", "fr"});
    QCOMPARE(result.code, 3);
    QCOMPARE(result.err.count("doit aussi indiquer"), 1);
    QVERIFY2(result.err.contains("un certificat d’étalonnage numérique doit aussi indiquer") &&
                 result.err.contains("pays du laboratoire") && !result.err.contains("numéro du rapport"),
             qPrintable(result.err));
    QVERIFY(!QFile::exists(file));
    QCOMPARE(run({"export", DATA "rtl/typical.rtl", "--accept", "--as", "dcc", "-o", at("c.csv")}).code, 2);
    QCOMPARE(run({"report", DATA "rtl/typical.rtl", "--accept", "--with-dcc", "--edition", "ISO 230-2:1997",
                  "-o", at("c.pdf")})
                 .code,
             2); // a view certifies nothing
}

void ImportExportTest::asksForWhatATableOwes() {
    const auto wanted = [this](const QStringList &options) {
        return run(
            QStringList{"export", DATA "rtl/typical.rtl", "--accept", "--language", "en", "-o", at("none")} +
            options);
    };
    const Result owed = wanted({"--as", "siemens"});
    QCOMPARE(owed.code, 2);
    QVERIFY(owed.err.contains("--reference"));
    for (const QString word : {"-1", "2", "5", "0.5", "x"})
        QCOMPARE(wanted({"--as", "siemens", "--reference", "0", "--encoder", word}).code, 2);
    QCOMPARE(wanted({"--as", "linuxcnc", "--interval", "0.01"}).code, 3); // more points than it loads
    QVERIFY(!QFile::exists(at("none")));
    const Result outside = run({"export", DATA "rtl/typical.rtl", "--accept", "--language", "en", "--as",
                                "siemens", "--reference", "-7", "--from", "-10", "-o", "-"});
    QVERIFY(outside.err.contains("Nothing was measured outside") &&
            outside.err.contains("The reference point"));
}

/// A table of the wrong sign doubles the deviations: who says nothing of it gets none, also from a test file.
void ImportExportTest::asksForASignThatWasAssumed() {
    QFile silent(at("silent.csv"));
    QVERIFY(silent.open(QIODevice::WriteOnly));
    silent.write("Position (mm);↑ (µm);↓ (µm)\n0;1;2\n100;3;4\n200;5;6\n");
    silent.close();
    const QString kept = at("silent.palmer");
    QCOMPARE(run({"import", silent.fileName(), "--accept", "-o", kept}).code, 0);
    for (const QString &file : {silent.fileName(), kept}) {
        QStringList words{"export", file, "--language", "en", "--as", "linuxcnc", "-o", at("none")};
        if (file != kept)
            words << "--accept";
        const Result asked = run(words);
        QCOMPARE(asked.code, 2);
        QVERIFY2(asked.err.contains("“silent.csv” does not say the sign") &&
                     asked.err.contains("--confirm-sign"),
                 qPrintable(asked.err));
        QVERIFY(!QFile::exists(at("none")));
        QCOMPARE(run(words + QStringList{"--confirm-sign", "--force"}).code, 0);
        QVERIFY(QFile::remove(at("none")));
    }
    for (const QString word :
         {"actualMinusTarget", "targetMinusActual", "keep"}) { // an answer at the import is enough
        const Result told = run({"export", silent.fileName(), "--accept", "--set", "sign=" + word, "--as",
                                 "linuxcnc", "-o", "-"});
        QVERIFY2(told.code == 0, qPrintable(told.err));
        QVERIFY2(told.out.startsWith(word == "targetMinusActual" ? "0 -0.0015" : "0 0.0015"),
                 qPrintable(told.out));
        QVERIFY(!told.err.contains("Sign: "));
    }
    QVERIFY(contents(kept).contains("\"signAssumed\": true"));
}

void ImportExportTest::inventsNoDirection() {
    const QString file = at("up.palmer");
    QFile up(file);
    QVERIFY(up.open(QIODevice::WriteOnly));
    up.write(R"({"format": "palmer test report", "version": 1, "tests": [{"kind": "positioning",
        "edition": "ISO 230-2:2006", "axis": {"name": "X", "motion": "linear"}, "targets": [0, 10, 20],
        "runs": [{"approach": "positive", "deviations": [0.001, 0.002, 0.003]}]}]})");
    up.close();
    for (const QString form : {"compensation-csv", "linuxcnc", "weihong"}) {
        const QStringList wanted{"export", file, "--as", form, "--language", "en", "-o", "-"};
        const Result combined = run(wanted);
        QVERIFY2(combined.err.contains("Only the positive direction was measured"), qPrintable(combined.err));
        const Result refused = run(wanted + QStringList{"--per-direction"});
        QCOMPARE(refused.code, 3);
        QVERIFY(refused.out.isEmpty());
        QCOMPARE(refused.err.count('\n'), 1);
    }
}

/// The plan belongs to the test: what moves the machine goes to the targets that the file has.
void ImportExportTest::writesTheProgramOfTheTestItself() {
    const QString file = at("own.palmer");
    QFile own(file);
    QVERIFY(own.open(QIODevice::WriteOnly));
    own.write(R"({"format": "palmer test report", "version": 1, "machine": {"controller": "SINUMERIK 840D"},
        "tests": [{"kind": "positioning", "edition": "ISO 230-2:2006",
        "axis": {"name": "X", "motion": "linear", "travel": 100}, "targets": [0.25, 50.1234, 99.5],
        "runs": [{"approach": "positive", "deviations": [null, null, null]},
                 {"approach": "negative", "deviations": [null, null, null]}]},
        {"kind": "circular", "edition": "ISO 230-4:2005", "plane": {"first": "X", "second": "Y"}, "nominalRadius": 50, "arcs": []}]})");
    own.close();
    const QStringList wanted{"export", file, "--as", "program", "--language", "en", "-o", "-"};
    const Result ofControl = run(wanted);
    QVERIFY2(ofControl.code == 0, qPrintable(ofControl.err));
    QVERIFY2(ofControl.out.contains("G710") && ofControl.out.contains("X50.1234"), qPrintable(ofControl.out));
    QVERIFY2(ofControl.err.contains("more than the travel of the axis"), qPrintable(ofControl.err));
    const Result asked = run(wanted + QStringList{"--dialect", "heidenhain"});
    QVERIFY2(asked.code == 0 && asked.out.contains("L X+50.1234"), qPrintable(asked.err + asked.out));
    QCOMPARE(run(wanted + QStringList{"--dialect", "other"}).code, 2);
    QCOMPARE(run({"export", file, "--as", "csv", "--dialect", "iso", "-o", "-"}).code, 2);
    const Result circle = run(wanted + QStringList{"--test", "2"});
    QVERIFY2(circle.code == 2 && circle.err.contains("no targets"), qPrintable(circle.err));
    const Result unknown = run(wanted + QStringList{"--set", "machine.controller=Other"});
    QVERIFY2(unknown.code == 2 && unknown.err.contains("--dialect iso|siemens"), qPrintable(unknown.err));
    QCOMPARE(run({"export", file, "--as", "program", "-o", at("p.pdf")}).code, 2);
}

void ImportExportTest::sensorsWithoutANameComeBackFromCsv() {
    const QByteArray file = R"({"format": "palmer test report", "version": 3, "tests": [{"kind": "drift",
        "axis": {"name": "X"}, "times": [0, 10, 20],
        "channels": [{"name": "X", "values": [0, 0.001, 0.002]}, {"name": "", "values": [0, null, 0.003]}],
        "temperatures": [{"measures": "", "resolution": 0.1, "values": [20, 20.1, 20.2]}]}]})";
    const CliResult csv = runCli({"export", "-", "--as", "csv", "-o", at("unnamed.csv")}, file);
    QVERIFY2(csv.code == 0, csv.err);
    const CliResult back = runCli({"import", at("unnamed.csv"), "--accept", "-o", "-"});
    QVERIFY2(back.code == 0, back.err);
    const QJsonObject test = QJsonDocument::fromJson(back.out).object()["tests"][0].toObject();
    QCOMPARE(test["channels"][1]["values"][2].toDouble(), 0.003);
    QCOMPARE(test["temperatures"][0]["values"][1].toDouble(), 20.1);
}

void ImportExportTest::comparesWithTheTableOfAControl() {
    QCOMPARE(
        run({"export", DATA "rtl/typical.rtl", "--accept", "--as", "linuxcnc", "-o", at("old.comp")}).code,
        0);
    const QStringList form{"export",   DATA "rtl/typical.rtl", "--accept", "--language", "en",       "--as",
                           "linuxcnc", "--per-direction",      "-o",       "-",          "--compare"};
    const Result compared = run(QStringList(form) << at("old.comp"));
    QVERIFY2(compared.code == 0, qPrintable(compared.err));
    QVERIFY(compared.err.contains("compared with a table of LinuxCNC: "));
    QVERIFY(compared.err.contains("largest difference, written − compared: "));
    QVERIFY(compared.err.contains("predicted with the compared table applied instead:"));
    const Result none = run(QStringList(form) << DATA "rtl/typical.rtl");
    QCOMPARE(none.code, 3);
    QVERIFY(none.out.isEmpty() && none.err.contains("typical.rtl"));
    // A table of a control is no measurement, wherever one may stand.
    for (const char *command : {"import", "evaluate"}) {
        const Result refused = run({command, at("old.comp"), "--language", "en", "-o", at("none")});
        QVERIFY(refused.code == 3 || refused.code == 2);
        QVERIFY(!QFile::exists(at("none")));
    }
    QVERIFY(
        run({"evaluate", at("old.comp"), "--language", "en"}).err.contains("this is a compensation table"));
}

void ImportExportTest::writesThePointsOfAFigure() {
    const auto points = [this](const QString &file) {
        const Result result = run({"figure", DATA + file, "--accept", "-o", at("points.csv")});
        return result.code == 0 ? QString::fromUtf8(contents(at("points.csv"))) : result.err;
    };
    QVERIFY(points("rtl/typical.rtl").contains("\nx̄↑,100,0.45\n"));
    // Title, head, and all points of both paths.
    QCOMPARE(points("b5r/typical-absolute.b5r").count('\n'), 2 + 18);
}

void ImportExportTest::refusesHugeFilesAtOnce() {
    QFile huge(at("huge.csv"));
    QVERIFY(huge.open(QIODevice::WriteOnly));
    if (!huge.resize(qint64(2) << 30))
        QSKIP("no sparse files here");
    huge.close();
    const Result result = run({"import", at("huge.csv"), "-o", at("none.palmer")});
    QCOMPARE(result.code, 3);
    QCOMPARE(result.err.count('\n'), 1);
    QVERIFY(huge.remove());
}

QTEST_GUILESS_MAIN(ImportExportTest)
#include "importexporttest.moc"
