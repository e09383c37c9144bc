// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/fewtrials.h"
#include "app/runcli.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

namespace {

using namespace palmer::testdata;

const QString examples = QStringLiteral(EXAMPLES);

QJsonObject object(const QByteArray &json) {
    return QJsonDocument::fromJson(json).object();
}

QList<QByteArray> lines(const QByteArray &text) {
    QList<QByteArray> result = text.split('\n');
    result.removeLast();
    return result;
}

} // namespace

/// Many files, folders, tables of all, and fields put in by the call: what laboratories script.
class BatchCommandTest : public QObject {
    Q_OBJECT

private slots:
    void init();

    void severalFilesSayWhatEachSays_data();
    void severalFilesSayWhatEachSays();
    void aBadFileStopsNoOther();
    void aFolderIsSearchedBelow();
    void anEmptyFolderIsSaid();
    void jsonLinesAreOneALine();
    void theTableHasARowPerParameter();
    void theTableForTheEyeIsAligned();
    void findingsAsJson();
    void reportsGoIntoAFolder();
    void reportsNeverShareAFile();
    void reportsNextToTheirTestFileAreNoInput();
    void outputsAreNamedByTheirContent();
    void linksAreFollowedOnce();
    void pipesAreRead();
    void aFailedFileIsAnObject();
    void figuresGoIntoAFolder();

    void fieldsAreSetByTheirPath_data();
    void fieldsAreSetByTheirPath();
    void unknownFieldsAreRefused_data();
    void unknownFieldsAreRefused();
    void aTableBecomesASignedOffReport();
    void templatesAreApplied();
    void aFieldIsSetOnce();
    void anAliasIsTheEditionItself();
    void anotherEditionIsAViewInTheReport();

    void everyParameterIsExplained_data();
    void everyParameterIsExplained();
    void explainNamesWhatThereIs();
    void typicalValuesAreOfferedAsOptions_data();
    void typicalValuesAreOfferedAsOptions();

private:
    [[nodiscard]] QString at(const QString &name) const { return m_folder->filePath(name); }
    void lay(const QString &name, const QString &example) const {
        write(at(name), palmer::testdata::withFewTrials(contents(examples + example)));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void BatchCommandTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    lay("in/a.palmer", "iso230-2-1988-example.palmer");
    lay("in/b.palmer", "rotary-axis.palmer");
    lay("in/below/c.palmer", "iso230-4-full-circles-xy.palmer");
    write(at("in/notes.txt"), "no test file");
}

void BatchCommandTest::severalFilesSayWhatEachSays_data() {
    QTest::addColumn<QStringList>("command");
    for (const char *jobs : {"1", "2", "5"}) {
        QTest::addRow("evaluate, %s at a time", jobs) << QStringList{"evaluate", "--jobs", jobs};
        QTest::addRow("check, %s at a time", jobs)
            << QStringList{"check", "--jobs", jobs, "--language", "fr"};
    }
}

void BatchCommandTest::severalFilesSayWhatEachSays() {
    QFETCH(QStringList, command);
    const QStringList files{at("in/b.palmer"), at("in/below/c.palmer"), at("in/a.palmer")};
    QByteArray expected;
    int worst = 0;
    for (const QString &file : files) {
        const CliResult one = runCli(command + QStringList{file});
        expected += (expected.isEmpty() ? QByteArray() : QByteArray("\n")) + file.toUtf8() + "\n\n" + one.out;
        worst = std::max(worst, one.code);
    }
    const CliResult all = runCli(command + files);
    QCOMPARE(all.out, expected);
    QCOMPARE(all.err, QByteArray());
    QCOMPARE(all.code, worst);
}

void BatchCommandTest::aBadFileStopsNoOther() {
    write(at("in/bad.palmer"), R"({"format": "palmer test report", "version": 1, "tests": [)");
    const CliResult all = runCli({"evaluate", at("in/a.palmer"), at("in/bad.palmer"), at("none.palmer"),
                                  at("in/b.palmer"), "--json", "--jobs", "2"});
    QCOMPARE(all.code, 3);
    const QList<QByteArray> results = lines(all.out);
    QCOMPARE(results.size(), 2);
    QCOMPARE(object(results[0])["file"].toString(), at("in/a.palmer"));
    QCOMPARE(object(results[1])["file"].toString(), at("in/b.palmer"));
    const QList<QByteArray> errors = lines(all.err);
    QCOMPARE(errors.size(), 2);
    QVERIFY2(errors[0].startsWith("palmer-cli: " + at("in/bad.palmer").toUtf8() + ": 1:"), all.err);
    QVERIFY2(errors[1].startsWith("palmer-cli: " + at("none.palmer").toUtf8() + ": "), all.err);
}

void BatchCommandTest::aFolderIsSearchedBelow() {
    const CliResult reports = runCli({"report", at("in/b.palmer"), "-o", at("in/r.pdf"), "--language", "en"});
    QCOMPARE(reports.code, 0);
    // A PDF of somebody else is passed over, a damaged one is not.
    write(at("in/foreign.pdf"),
          contents(at("in/r.pdf")).replace("Palmer", "Qalmer").replace("palmer", "qalmer"));
    const CliResult all = runCli({"evaluate", at("in"), "--json"});
    QStringList files;
    for (const QByteArray &line : lines(all.out))
        files << QDir(at("in")).relativeFilePath(object(line)["file"].toString());
    QCOMPARE(files.mid(0, 2), QStringList({"a.palmer", "b.palmer"}));
    QVERIFY(files.contains("below/c.palmer"));
    QVERIFY(files.contains("r.pdf"));
    QVERIFY(!files.contains("notes.txt"));
}

void BatchCommandTest::anEmptyFolderIsSaid() {
    QDir().mkpath(at("empty"));
    const CliResult all = runCli({"evaluate", at("empty"), at("in/b.palmer"), "--language", "en"});
    QCOMPARE(all.code, 3);
    QCOMPARE(all.err,
             "palmer-cli: " + at("empty").toUtf8() + ": there is no test file or report in the folder\n");
    QVERIFY(!all.out.isEmpty());
}

void BatchCommandTest::jsonLinesAreOneALine() {
    for (const char *command : {"evaluate", "check"}) {
        const CliResult one = runCli({command, at("in/b.palmer"), "--json-lines"});
        QCOMPARE(one.out.count('\n'), 1);
        const CliResult pretty = runCli({command, at("in/b.palmer"), "--json"});
        QVERIFY(pretty.out.count('\n') > 1);
        QCOMPARE(object(one.out), object(pretty.out));
        const CliResult folder = runCli({command, at("in/below"), "--json"}); // one file, a line all the same
        QCOMPARE(folder.out.count('\n'), 1);
    }
}

void BatchCommandTest::theTableHasARowPerParameter() {
    const CliResult table = runCli({"evaluate", at("in"), "--table", "csv", "--language", "fr"});
    QCOMPARE(table.code, 0);
    const QList<QByteArray> rows = lines(table.out);
    QCOMPARE(
        rows[0],
        QByteArray("file,test,machine,manufacturer,model,serialNumber,reportNumber,axis,date,edition,purpose,"
                   "role,zone,parameter,value,U,limit,unit,limits,accordance"));
    qsizetype next = 1;
    for (const char *file : {"in/a.palmer", "in/b.palmer", "in/below/c.palmer"}) {
        const QJsonObject results = object(runCli({"evaluate", at(file), "--json"}).out);
        const QJsonObject test = results["tests"].toArray()[0].toObject();
        for (const QJsonValue &value : test["parameters"].toArray()) {
            const QJsonObject parameter = value.toObject();
            const QList<QByteArray> cells = rows.at(next++).split(',');
            QCOMPARE(cells.size(), 20);
            QCOMPARE(QString::fromUtf8(cells[0]), at(file));
            QCOMPARE(cells[1], QByteArray("1"));
            QCOMPARE(QString::fromUtf8(cells[2]), results["machine"].toObject()["name"].toString());
            const QJsonObject machine = results["machine"].toObject();
            QCOMPARE(QString::fromUtf8(cells[3]), machine["manufacturer"].toString());
            QCOMPARE(QString::fromUtf8(cells[4]), machine["model"].toString());
            QCOMPARE(QString::fromUtf8(cells[5]), machine["serialNumber"].toString());
            QCOMPARE(QString::fromUtf8(cells[6]), results["reportNumber"].toString());
            QCOMPARE(QString::fromUtf8(cells[7]), test["axis"].toString() + test["plane"].toString());
            QCOMPARE(QString::fromUtf8(cells[8]), test["date"].toString());
            QCOMPARE(QString::fromUtf8(cells[9]), test["edition"].toString());
            QCOMPARE(QString::fromUtf8(cells[13]), parameter["id"].toString());
            QCOMPARE(cells[14].toDouble(), parameter["value"].toDouble()); // all digits: equal
            QCOMPARE(cells[15].isEmpty(), parameter["expandedUncertainty"].isNull());
            QCOMPARE(cells[15].toDouble(), parameter["expandedUncertainty"].toDouble());
            QCOMPARE(cells[16].isEmpty(), parameter["limit"].isNull());
            QCOMPARE(cells[16].toDouble(), parameter["limit"].toDouble());
            QCOMPARE(QString::fromUtf8(cells[17]), parameter["unit"].toString());
            QCOMPARE(cells[18] == "noneAgreed", parameter["verdict"].isNull());
            QCOMPARE(QString::fromUtf8(cells[19]), test["accordance"].toString());
        }
    }
    QCOMPARE(next, rows.size());
    QCOMPARE(runCli({"evaluate", at("in"), "--table", "html"}).code, 2);
    QCOMPARE(runCli({"evaluate", at("in"), "--table", "csv", "--json"}).code, 2);
}

void BatchCommandTest::theTableForTheEyeIsAligned() {
    const CliResult table = runCli({"evaluate", at("in"), "--table", "text", "--language", "en"});
    const QStringList rows = QString::fromUtf8(table.out).split('\n', Qt::SkipEmptyParts);
    QVERIFY(rows.size() > 20);
    const qsizetype axis = rows[0].indexOf("Axis");
    QVERIFY(axis > 0);
    for (const QString &row : rows.mid(1)) {
        QVERIFY(!row.endsWith(' '));
        QVERIFY2(row[axis] != ' ' && row[axis - 1] == ' ', qPrintable(row));
    }
    QVERIFY(rows[1].contains("18.0"));
}

void BatchCommandTest::findingsAsJson() {
    const CliResult one = runCli({"check", at("in/a.palmer"), "--json"});
    QCOMPARE(one.code, 1);
    const QJsonObject findings = object(one.out);
    QCOMPARE(findings["format"].toString(), QString("palmer findings"));
    const QJsonObject test = findings["tests"].toArray()[0].toObject();
    const QJsonObject evaluated = object(runCli({"evaluate", at("in/a.palmer"), "--json"}).out);
    const QJsonObject whole = evaluated["tests"].toArray()[0].toObject();
    QCOMPARE(test["findings"], whole["findings"]);
    QVERIFY(!test["findings"].toArray().isEmpty());
    QCOMPARE(test["accordance"], whole["accordance"]);
    QVERIFY(!test.contains("parameters"));
}

void BatchCommandTest::reportsGoIntoAFolder() {
    const CliResult all =
        runCli({"report", at("in"), at("in/b.palmer"), "-o", at("out"), "--language", "fr,en"});
    QCOMPARE(all.code, 2); // b.palmer twice
    QVERIFY(!QFileInfo::exists(at("out")));
    write(at("in/bad.palmer"), "{");
    const CliResult some = runCli({"report", at("in"), "-o", at("out"), "--language", "fr,en"});
    QCOMPARE(some.code, 3); // the damaged one is said, the others are written
    for (const char *file : {"out/a.fr.pdf", "out/a.en.pdf", "out/b.fr.pdf", "out/below/c.en.pdf"})
        QVERIFY2(QFileInfo::exists(at(file)), file);
    QVERIFY(!QFileInfo::exists(at("out/bad.fr.pdf")));
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("alone.pdf"), "--language", "en"}).code, 0);
    QCOMPARE(contents(at("alone.pdf")), contents(at("out/b.en.pdf"))); // byte for byte as alone
}

void BatchCommandTest::reportsNeverShareAFile() {
    lay("other/a.palmer", "one-direction.palmer");
    const CliResult both =
        runCli({"report", at("in/a.palmer"), at("other/a.palmer"), "-o", at("out"), "--language", "en"});
    QCOMPARE(both.code, 2);
    QVERIFY(both.err.contains("in/a.palmer") && both.err.contains("other/a.palmer"));
    // PDFs in the folder that is written to are no input, and are not written over by their own content.
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("same/r.pdf"), "--language", "en"}).code, 3);
    QDir().mkpath(at("same"));
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("same/r.pdf"), "--language", "en"}).code, 0);
    const QByteArray before = contents(at("same/r.pdf"));
    QCOMPARE(runCli({"report", at("same"), "-o", at("same"), "--language", "fr"}).code, 3); // nothing to read
    QCOMPARE(contents(at("same/r.pdf")), before);
    write(at("file"), "x");
    QCOMPARE(runCli({"report", at("in"), "-o", at("file"), "--language", "fr"}).code, 2);
    // The name of one PDF for several: no folder of that name.
    QCOMPARE(runCli({"report", at("in"), "-o", at("all.pdf"), "--language", "fr"}).code, 2);
    QVERIFY(!QFileInfo::exists(at("all.pdf")));
}

void BatchCommandTest::reportsNextToTheirTestFileAreNoInput() {
    const QStringList call{"report", at("in"), "-o", at("in"), "--language", "en"};
    QVERIFY(runCli(call).code <= 1);
    const CliResult again = runCli(call); // into the same folder
    QVERIFY(again.code <= 1);
    QVERIFY2(again.err.isEmpty(), again.err);
    const auto rows = [this] { return lines(runCli({"evaluate", at("in"), "--json-lines"}).out).size(); };
    QCOMPARE(rows(), 3);
    QVERIFY(QFile::rename(at("in/b.pdf"), at("in/b.fr.pdf")));
    QCOMPARE(rows(), 3);
    QVERIFY(QFile::copy(at("in/b.fr.pdf"), at("in/alone.pdf")));
    QCOMPARE(rows(), 4);
    QVERIFY(QFile::remove(at("in/b.palmer")) && QFile::copy(at("in/a.palmer"), at("in/b.palmer")));
    const CliResult other = runCli({"check", at("in"), "--json-lines"});
    QCOMPARE(other.err.count('\n'), 1);
    QVERIFY2(other.err.contains("b.fr.pdf: this report was made from another state"), other.err);
    QCOMPARE(lines(runCli({"verify", at("in"), "--json-lines"}).out).size(),
             4); // of which PDFs are the input
}

void BatchCommandTest::outputsAreNamedByTheirContent() {
    const CliResult named = runCli({"report", at("in"), "-o", at("out"), "--language", "en", "--set",
                                    "machine.name=A/B", "--name", "{machine}-{file}-{axis}"});
    QVERIFY2(named.code <= 1, named.err);
    const QStringList files = QDir(at("out")).entryList(QDir::Files);
    QVERIFY2(files.size() == 2 && files[0].startsWith("A_B-a-"), qPrintable(files.join(' ')));
    runCli({"figure", at("in"), "-o", at("pictures"), "--as", "svg", "--set", "machine.name=M", "--name",
            "{machine}"});
    for (const char *picture : {"pictures/M.svg", "pictures/M-2.svg", "pictures/below/M.svg"})
        QVERIFY2(QFileInfo::exists(at(picture)), picture);
    QCOMPARE(runCli({"report", at("in"), "-o", at("out"), "--name", "{mashine}"}).code, 2);
    QCOMPARE(runCli({"report", at("in"), "-o", at("out"), "--name", "all"}).code, 2);
    for (const QString &outside :
         {QStringLiteral("../{file}"), QStringLiteral("a/../../{file}"), at("{file}")}) {
        const CliResult refused = runCli({"report", at("in"), "-o", at("out"), "--name", outside});
        QVERIFY2(refused.code == 2 && refused.err.contains("leads out of the folder"), refused.err);
    }
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("x.pdf"), "--name", "{machine}"}).code, 2);
}

void BatchCommandTest::linksAreFollowedOnce() {
    QVERIFY(QFile::link(at("in/below"), at("in/linked")) && QFile::link(at("in"), at("in/below/around")));
    QVERIFY(QFile::link(at("in/a.palmer"), at("in/again.palmer")));
    QCOMPARE(lines(runCli({"evaluate", at("in"), "--json-lines"}).out).size(), 4);
}

void BatchCommandTest::pipesAreRead() {
    for (const char *command :
         {"evaluate <(cat %1)", "cat %1 | %2 evaluate /dev/stdin", "evaluate /dev/stdin < %1"}) {
        const QString whole = QString(command).contains("%2") ? QString(command).replace("%2", PALMER_CLI)
                                                              : QStringLiteral(PALMER_CLI " ") + command;
        QProcess shell;
        shell.start("/bin/bash", {"-c", QString(whole).replace("%1", at("in/b.palmer")) + " --json"});
        QVERIFY(shell.waitForFinished(patience));
        QVERIFY2(object(shell.readAllStandardOutput())["tests"].isArray(), shell.readAllStandardError());
    }
}

void BatchCommandTest::aFailedFileIsAnObject() {
    write(at("in/bad.palmer"), "{");
    const CliResult all = runCli({"evaluate", at("in"), at("missing.palmer"), "--json-lines"});
    QCOMPARE(all.code, 3);
    QStringList failed;
    for (const QByteArray &line : lines(all.out)) {
        if (const QJsonObject one = object(line); one["exit"] == 3)
            failed << one["file"].toString().section('/', -1);
    }
    QCOMPARE(failed, QStringList({"bad.palmer", "missing.palmer"}));
    QCOMPARE(lines(all.out).size(), 5);
}

void BatchCommandTest::figuresGoIntoAFolder() {
    QCOMPARE(runCli({"figure", at("in"), "-o", at("out")}).code, 2); // which kind?
    QCOMPARE(runCli({"figure", at("in"), "-o", at("out"), "--as", "svg"}).code, 0);
    for (const char *file : {"out/a.svg", "out/b.svg", "out/below/c.svg"})
        QVERIFY2(contents(at(file)).contains("<svg"), file);
}

void BatchCommandTest::fieldsAreSetByTheirPath_data() {
    QTest::addColumn<QStringList>("settings");
    QTest::addColumn<QString>("path"); // in the file that is written
    QTest::addColumn<QJsonValue>("value");
    QTest::newRow("a text") << QStringList{"machine.name=DMU 50"} << "machine.name" << QJsonValue("DMU 50");
    QTest::newRow("a text of digits")
        << QStringList{"machine.serialNumber=0815"} << "machine.serialNumber" << QJsonValue("0815");
    QTest::newRow("a text that could be a number")
        << QStringList{"machine.serialNumber=815"} << "machine.serialNumber" << QJsonValue("815");
    QTest::newRow("a whole number") << QStringList{"machine.year=2024"} << "machine.year" << QJsonValue(2024);
    QTest::newRow("with an equals sign")
        << QStringList{"report.remarks=a=b"} << "report.remarks" << QJsonValue("a=b");
    QTest::newRow("a limit of every test")
        << QStringList{"limits.A.value=20 um"} << "tests[0].limits.A.value" << QJsonValue(0.020);
    QTest::newRow("with a comma") << QStringList{"limits.A.value=0,020 mm"} << "tests[0].limits.A.value"
                                  << QJsonValue(0.020);
    QTest::newRow("of one test") << QStringList{"tests[0].title=Axe X"} << "tests[0].title"
                                 << QJsonValue("Axe X");
    QTest::newRow("a word") << QStringList{"role=asLeft"} << "tests[0].role" << QJsonValue("asLeft");
    QTest::newRow("an empty text") << QStringList{"tests[0].title="} << "tests[0].title" << QJsonValue("");
}

namespace {

QJsonValue valueAt(QJsonValue value, const QString &path) {
    for (QString step : path.split('.')) {
        const bool indexed = step.endsWith(']');
        const QString key = step.section('[', 0, 0);
        value = value[key];
        if (indexed)
            value = value[step.section('[', 1).chopped(1).toInt()];
    }
    return value;
}

} // namespace

void BatchCommandTest::fieldsAreSetByTheirPath() {
    QFETCH(QStringList, settings);
    QFETCH(QString, path);
    QFETCH(QJsonValue, value);
    QStringList command{
        "import", QStringLiteral(DATA "rtl/typical.rtl"), "--accept", "-o", at("o.palmer"), "--language",
        "en"};
    for (const QString &setting : settings)
        command << "--set" << setting;
    const CliResult imported = runCli(command);
    QVERIFY2(imported.code == 0, imported.err);
    QCOMPARE(valueAt(object(contents(at("o.palmer"))), path), value);
}

void BatchCommandTest::unknownFieldsAreRefused_data() {
    QTest::addColumn<QString>("setting");
    for (const char *setting :
         {"machine.nme=X", "limits.A.valu=1", "machine.year=soon", "role=before", "tests[7].title=X",
          "tests[x].title=X", "machine.=X", ".name=X", "machine..name=X", "machine=X", "nonsense=1",
          "limits.A.value=", "axis=Y", "unit=um", "tests[0]=X", "tests[0]={}", "machine.name[0]=X", "[0]=1",
          "targets[0]=1e999"})
        QTest::newRow(setting) << setting;
    for (const char *setting : {"limits.A.value=20", "limits.A.value=5arcsec"}) // µm or mm?
        QTest::newRow(setting) << setting;
}

void BatchCommandTest::unknownFieldsAreRefused() {
    QFETCH(QString, setting);
    const CliResult one = runCli({"evaluate", at("in/a.palmer"), "--set", setting, "--language", "en"});
    QCOMPARE(one.code, 2);
    QCOMPARE(one.out, QByteArray());
    QCOMPARE(one.err.count('\n'), 1);
    QVERIFY2(one.err.contains(setting.section('=', 0, 0).toUtf8()), one.err);
    const CliResult report =
        runCli({"report", at("in/a.palmer"), "-o", at("o.pdf"), "--set", setting, "--language", "en"});
    QCOMPARE(report.code, 2);
    QVERIFY(!QFileInfo::exists(at("o.pdf")));
}

void BatchCommandTest::aFieldIsSetOnce() {
    const CliResult twice = runCli({"evaluate", at("in/a.palmer"), "--set", "limits.A.value=20um", "--set",
                                    "limits.A.value=30um", "--language", "en"});
    QCOMPARE(twice.code, 2);
    QVERIFY2(twice.err.contains("--set limits.A.value stands twice"), twice.err);
}

/// An edition and its alias are one: its verdicts stay.
void BatchCommandTest::anAliasIsTheEditionItself() {
    const auto verdict = [&](const char *edition) -> QJsonValue {
        const QJsonObject results =
            object(runCli({"evaluate", EXAMPLES "x-axis-as-found-as-left.palmer", "--set",
                           "limits.A.value=20um", "--json", "--edition", edition})
                       .out);
        return results["tests"].toArray()[1].toObject()["verdict"];
    };
    const QByteArray own =
        object(runCli({"evaluate", EXAMPLES "x-axis-as-found-as-left.palmer", "--json"}).out)["tests"]
            .toArray()[1]
            .toObject()["edition"]
            .toString()
            .toUtf8();
    QVERIFY(verdict(own.constData()).isString());
    QVERIFY(verdict("ISO 230-2:1988").isNull());
    const auto alias = own == "ISO 230-2:2006" ? "GB/T 17421.2-2016" : "GB/T 17421.2-2023";
    QCOMPARE(verdict(alias), verdict(own.constData()));
}

void BatchCommandTest::aTableBecomesASignedOffReport() {
    write(at("x.csv"), "Target (mm);+1 (µm);-1 (µm);+2 (µm);-2 "
                       "(µm)\n0;1,0;2,1;1,2;2,0\n50;2,0;3,1;2,2;3,2\n100;1,5;2,4;1,6;2,7\n");
    const CliResult one =
        runCli({"report", at("x.csv"), "--accept", "-o", at("x.pdf"), "--language", "fr", "--set",
                "limits.A.value=20um", "--set", "machine.name=DMU 50", "--set", "axis=X"});
    QVERIFY2(one.code == 0, one.err);
    const QJsonObject results = object(runCli({"evaluate", at("x.pdf"), "--json"}).out);
    QCOMPARE(results["machine"].toObject()["name"].toString(), QString("DMU 50"));
    const QJsonObject a = results["tests"].toArray()[0].toObject()["parameters"].toArray()[0].toObject();
    QCOMPARE(a["limit"].toDouble(), 0.020);
    QCOMPARE(a["verdict"].toString(), QString("conforms"));
}

void BatchCommandTest::templatesAreApplied() {
    write(at("m.palmer-template"),
          R"({"format": "palmer template", "version": 1, "name": "m", "machine": {"name": "Big mill"}})");
    write(at("l.palmer-template"),
          R"({"format": "palmer template", "version": 1, "name": "l", "kind": "positioning",
              "limits": {"A": {"value": 0.001, "edition": "ISO 230-2:1988"}}, "decisionRule": {"rule": "simple acceptance"}})");
    const CliResult one = runCli({"evaluate", at("in/a.palmer"), "--json", "--template",
                                  at("m.palmer-template"), "--template", at("l.palmer-template")});
    QVERIFY2(one.code == 1, one.err); // the limit is exceeded
    const QJsonObject results = object(one.out);
    QCOMPARE(results["machine"].toObject()["name"].toString(), QString("Big mill"));
    QCOMPARE(results["tests"].toArray()[0].toObject()["limits"].toString(), QString("exceeded"));
    // The machine of a file is never replaced by another one.
    write(at("own.palmer"),
          R"({"format": "palmer test report", "version": 1, "machine": {"serialNumber": "1"},
          "tests": [{"kind": "drift", "id": "d", "times": [0, 1], "deviations": [0, 0]}]})");
    for (const auto &[serial, code] : {std::pair{"1", 0}, std::pair{"2", 3}}) {
        write(at("n.palmer-template"), R"({"format": "palmer template", "version": 1, "name": "n",
              "machine": {"name": "Mill", "serialNumber": ")" +
                                           QByteArray(serial) + R"("}})");
        QCOMPARE(runCli({"evaluate", at("own.palmer"), "--template", at("n.palmer-template")}).code, code);
    }
    // Nor its instrument; of names, where a serial number is not stated, it is said.
    write(at("laser.palmer"), R"({"format": "palmer test report", "version": 1, "machine": {"name": "Mill"},
          "instruments": [{"id": "laser", "serialNumber": "L1"}],
          "tests": [{"kind": "drift", "id": "d", "times": [0, 1], "deviations": [0, 0]}]})");
    for (const auto &[content, code, said] :
         {std::tuple{R"("instrument": {"id": "laser", "serialNumber": "L9"})", 3, "serial number L9"},
          std::tuple{R"("instrument": {"id": "laser", "serialNumber": "L 1"})", 0, ""},
          std::tuple{R"("machine": {"name": "Lathe", "serialNumber": "5"})", 0, "“Mill” by “Lathe”"},
          std::tuple{R"("machine": {"name": "mill", "serialNumber": "5"})", 0, ""},
          std::tuple{R"("kind": "circular", "limits": {"G": {"value": 0.01}})", 2, "fits no test"},
          std::tuple{R"("conditions": {"soak": "12 h"})", 2, "fits no test"}}) {
        write(at("t.palmer-template"),
              QByteArray(R"({"format": "palmer template", "version": 1, )") + content + "}");
        const CliResult applied = runCli(
            {"evaluate", at("laser.palmer"), "--template", at("t.palmer-template"), "--language", "en"});
        QCOMPARE(applied.code, code);
        QVERIFY2(applied.err.contains(said) && applied.err.isEmpty() == !*said, applied.err);
    }
    // Limits in mm are none of a rotary axis; of several files the others are worked on.
    const QString rotary = QStringLiteral(EXAMPLES "rotary-axis.palmer");
    const QStringList limits{"--template", at("l.palmer-template"), "--language", "en"};
    QCOMPARE(runCli(QStringList{"evaluate", rotary} + limits).code, 2);
    const CliResult both = runCli(QStringList{"evaluate", rotary, at("in/a.palmer")} + limits);
    QCOMPARE(both.code, 1);
    QVERIFY2(both.err.contains("rotary-axis.palmer: --template") && both.err.count('\n') == 1, both.err);
    // A file of an option is read, and never written to.
    const QByteArray before = contents(at("l.palmer-template"));
    for (const QStringList &call :
         {QStringList{"report", at("in/a.palmer")}, QStringList{"report", at("in"), at("in/a.palmer")}}) {
        const CliResult kept = runCli(call + limits + QStringList{"-o", at("l.palmer-template"), "--force"});
        QVERIFY2(kept.code == 2 || contents(at("l.palmer-template")) == before, kept.err);
        QCOMPARE(contents(at("l.palmer-template")), before);
    }
    write(at("bad.palmer-template"), R"({"format": "palmer template"})");
    // A file that cannot be read, once, however many are worked on.
    for (const char *name : {"bad.palmer-template", "nowhere.palmer-template"}) {
        for (const QStringList &files : {QStringList{at("in/a.palmer")}, QStringList{at("in")}}) {
            const CliResult bad =
                runCli(QStringList{"evaluate"} + files + QStringList{"--template", at(name)});
            QCOMPARE(bad.code, 3);
            QCOMPARE(bad.out, QByteArray());
            QVERIFY2(bad.err.contains(name) && bad.err.count('\n') == 1, bad.err);
        }
    }
}

void BatchCommandTest::anotherEditionIsAViewInTheReport() {
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("v.pdf"), "--edition", "2006", "--language", "en"})
                 .code,
             0);
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("p.pdf"), "--editions", "1988,2006", "--language",
                     "en"})
                 .code,
             0);
    QCOMPARE(runCli({"report", at("in/b.palmer"), "-o", at("q.pdf"), "--editions", "1988,1750", "--language",
                     "en"})
                 .code,
             2);
    QVERIFY(!QFileInfo::exists(at("q.pdf")));
    QVERIFY(contents(at("p.pdf")).size() > contents(at("v.pdf")).size() / 2);
}

void BatchCommandTest::everyParameterIsExplained_data() {
    QTest::addColumn<QString>("file");
    for (const QString &file : QDir(examples).entryList({"*.palmer"}))
        QTest::newRow(qPrintable(file)) << file;
}

void BatchCommandTest::everyParameterIsExplained() {
    QFETCH(QString, file);
    const QJsonObject results = object(runCli({"evaluate", examples + file, "--json"}).out);
    const QJsonArray parameters = results["tests"].toArray()[0].toObject()["parameters"].toArray();
    QVERIFY(!parameters.isEmpty());
    for (const char *language : {"fr", "en"}) {
        const CliResult all = runCli({"explain", examples + file, "--test", "1", "--language", language});
        QCOMPARE(all.code, 0);
        const QString text = QString::fromUtf8(all.out);
        QCOMPARE(text.count("\n\n"), parameters.size()); // each begins a paragraph
        for (const QJsonValue &parameter : parameters)
            QVERIFY2(text.contains("\n\n" + parameter["symbol"].toString().left(1)), qPrintable(text));
        const CliResult one = runCli({"explain", examples + file, parameters.last()["id"].toString(),
                                      "--test", "1", "--language", language});
        QCOMPARE(one.code, 0);
        QVERIFY(all.out.endsWith(one.out.mid(one.out.indexOf("\n\n"))));
    }
}

void BatchCommandTest::explainNamesWhatThereIs() {
    const CliResult unknown = runCli({"explain", at("in/a.palmer"), "Z", "--language", "en"});
    QCOMPARE(unknown.code, 2);
    QVERIFY2(unknown.err.contains("known: A, "), unknown.err);
    QCOMPARE(runCli({"explain", at("in/a.palmer"), "a"}).code, 0); // in any case
    QCOMPARE(runCli({"explain", at("in/a.palmer"), "A↑"}, {}, {{"LC_ALL", "C.UTF-8"}}).code, 0);
    QCOMPARE(runCli({"explain", at("in/a.palmer"), "A", "--test", "2"}).code, 2);
    QCOMPARE(runCli({"explain", at("in/a.palmer"), "A", "R"}).code, 2);
    QCOMPARE(runCli({"synthesize", "drift", "-o", at("drift.palmer")}).code, 0);
    QVERIFY(runCli({"explain", at("drift.palmer"), "--language", "en"})
                .err.endsWith("its tests have no results to explain\n"));
    const CliResult one = runCli({"explain", at("in/a.palmer"), "A", "--language", "en"});
    QVERIFY2(one.out.contains("18.0"), one.out); // ISO 230-2:1988, table 2: 18.03 µm
}

void BatchCommandTest::typicalValuesAreOfferedAsOptions_data() {
    everyParameterIsExplained_data();
}

/// What the window offers, with its source; each option that is printed is one that is taken.
void BatchCommandTest::typicalValuesAreOfferedAsOptions() {
    QFETCH(QString, file);
    const CliResult offered = runCli({"explain", examples + file, "--typical", "--language", "en"});
    QCOMPARE(offered.code, 0);
    const bool isLinear = file.startsWith("iso230-2") || file.startsWith("long") || file.startsWith("one");
    QVERIFY2(!isLinear || offered.out.contains("typical minimum of ISO 230-2"), offered.out);
    static const QRegularExpression option("--set '([^']+)'");
    for (const auto &match : option.globalMatch(QString::fromUtf8(offered.out))) {
        const CliResult taken = runCli({"evaluate", examples + file, "--set", match.captured(1)});
        QVERIFY2(taken.code <= 1, match.captured(1).toUtf8() + ": " + taken.err);
    }
    QVERIFY(offered.out.isEmpty() != offered.err.isEmpty()); // where there is none, it is said
    QCOMPARE(runCli({"explain", examples + file, "A", "--typical"}).code, 2);
}

QTEST_GUILESS_MAIN(BatchCommandTest)
#include "batchcommandtest.moc"
