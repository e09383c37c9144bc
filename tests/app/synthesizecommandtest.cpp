// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"
#include "runcli.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer::testdata;

namespace {

QJsonObject jsonOf(const QByteArray &bytes) {
    QJsonParseError error{};
    const QJsonObject result = QJsonDocument::fromJson(bytes, &error).object();
    if (error.error != QJsonParseError::NoError)
        qWarning("no JSON: %s", qPrintable(error.errorString()));
    return result;
}

} // namespace

/// Measurements with known truth, and what the diagnosis makes of them, from outside.
class SynthesizeCommandTest : public QObject {
    Q_OBJECT

private slots:
    void truthComesBack_data();
    void outputsAreNeverLost();
    void truthComesBack();
    void severalFeeds();
    void sumOfWhatCannotBeTold();
    void teachingExamples_data();
    void teachingExamples();
    void vibrationStaysInTheRest();
    void positioning();
    void sameSeedSameFile();
    void wrongUsage_data();
    void wrongUsage();

private:
    [[nodiscard]] QString path(const char *name) const { return m_folder.filePath(name); }
    QTemporaryDir m_folder;
};

void SynthesizeCommandTest::outputsAreNeverLost() {
    const QStringList made{"synthesize", "circular", "--points", "50"};
    const QString test = path("t.palmer");
    QCOMPARE(runCli(made + QStringList{"-o", test}).code, 0);
    const QByteArray before = contents(test);
    const auto refused = [&](const QStringList &outputs) { return runCli(made + outputs).code == 2; };
    QVERIFY(refused({"-o", path("s.palmer"), "--truth", test})); // a test file is no truth
    QVERIFY(!QFileInfo::exists(path("s.palmer")));
    QVERIFY(refused({"-o", test, "--truth", test}));
    QVERIFY(refused({"-o", path("x.json"), "--truth", path("x.json")})); // there or not
    QVERIFY(refused({"-o", path("x.json"), "--truth", path("./x.json")}));
    QVERIFY(!QFileInfo::exists(path("x.json")));
    for (const char *other : {"x.csv", "x.pdf", "x.xlsx"}) {
        QVERIFY2(refused({"-o", path(other)}), other);
        QVERIFY2(refused({"-o", path("y.palmer"), "--truth", path(other)}), other);
        QVERIFY(!QFileInfo::exists(path(other)) && !QFileInfo::exists(path("y.palmer")));
    }
    QCOMPARE(runCli(made + QStringList{"-o", path("x.csv"), "--force"}).code, 0);
    // Where one cannot be written neither is.
    QCOMPARE(runCli(made + QStringList{"-o", path("z.palmer"), "--truth", path("none/z.json")}).code, 3);
    QVERIFY(!QFileInfo::exists(path("z.palmer")));
    QCOMPARE(contents(test), before);
}

void SynthesizeCommandTest::truthComesBack_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("axis");
    QTest::addColumn<double>("value");
    const auto row = [](const char *source, const char *id, const char *axis, double value) {
        QTest::newRow(source) << source << id << axis << value;
    };
    row("scaleMismatch=60", "scaleMismatch", "", 60);
    row("squareness=-50", "squareness", "", -50);
    row("servoMismatch=0.6", "servoMismatch", "", 0.6);
    row("backlash:Y=6", "backlash", "Y", 6);
    row("lateralPlay:Z=5,5", "lateralPlay", "Z", 5.5);
    row("straightness:Y=-9", "straightness", "Y", -9);
    row("cyclic:Z=3@16", "cyclic", "Z", 3);
    row("reversalSpike:Y=8@2.5", "reversalSpike", "Y", 8);
    row("radiusDrift=4", "radiusDrift", "", 4);
}

void SynthesizeCommandTest::truthComesBack() {
    QFETCH(QString, source);
    QFETCH(QString, id);
    QFETCH(QString, axis);
    QFETCH(double, value);
    const QString file = path("made.palmer");
    const CliResult made =
        runCli({"synthesize", "circular", "--plane", "YZ", "--points", "720", "--noise", "0.1",
                "--resolution", "0.1", "--source", source, "--truth", path("truth.json"), "-o", file});
    QCOMPARE(made.code, 0);
    const QJsonObject truth = jsonOf(contents(path("truth.json")));
    const QJsonObject stated = truth[u"sources"].toArray().first().toObject();
    QCOMPARE(stated[u"id"].toString(), id);
    QCOMPARE(stated[u"axis"].toString(), axis);
    QCOMPARE(stated[u"value"].toDouble(), value);
    const CliResult evaluated = runCli({"evaluate", file, "--json"});
    const QJsonObject diagnosis = jsonOf(evaluated.out)[u"tests"].toArray().first()[u"diagnosis"].toObject();
    QCOMPARE(diagnosis[u"rank"].toInt(), diagnosis[u"of"].toInt());
    const QJsonObject first = diagnosis[u"sources"].toArray().first().toObject();
    QCOMPARE(first[u"id"].toString(), id);
    QCOMPARE(first[u"axis"].toString(), axis);
    QCOMPARE(first[u"unit"].toString(), stated[u"unit"].toString());
    const double u = first[u"u"].toDouble();
    QVERIFY(u > 0 && std::abs(first[u"value"].toDouble() - value) < 5 * u);
    QVERIFY(first[u"contribution"].toDouble() > 1e-3); // mm
    const QJsonObject interval = first[u"interval"].toObject();
    const double half = (interval[u"to"].toDouble() - interval[u"from"].toDouble()) / 2;
    QVERIFY(diagnosis[u"modelFits"].toBool() && diagnosis[u"reasons"].toArray().isEmpty());
    QVERIFY(first[u"degreesOfFreedom"].toDouble() > 1 && half > 1.95 * u && half < 4.4 * u); // Student
    QVERIFY(first[u"reasons"].toArray().isEmpty());
    // The steps of backlash show that there is none; lateral play makes none where its axis turns.
    QCOMPARE(diagnosis[u"rotation"].isObject(), id == "backlash");
    QVERIFY(!diagnosis[u"rotation"][u"stated"].toBool());
    // The table says it, too, in both languages.
    const QByteArray english = runCli({"evaluate", file}).out;
    QVERIFY(english.contains("Diagnosis (an interpretation)"));
    QVERIFY(runCli({"evaluate", file, "--language", "fr"}).out.contains("Diagnostic (interprétation)"));
}

void SynthesizeCommandTest::severalFeeds() {
    const QString file = path("feeds.palmer");
    QCOMPARE(runCli({"synthesize", "circular", "--points", "360", "--noise", "0.1", "--source",
                     "commonLag=-15", "--feed", "500", "--feed", "2000", "--feed", "4000", "-o", file})
                 .code,
             0);
    const QJsonObject results = jsonOf(runCli({"evaluate", file, "--json"}).out);
    QCOMPARE(results[u"tests"].toArray().size(), 3);
    const QJsonArray together = results[u"feedDiagnoses"].toArray();
    QCOMPARE(together.size(), 1);
    QCOMPARE(together.first()[u"tests"].toArray().size(), 3);
    // The lag changes the radius alone: no part of G(b), found by its name.
    bool found = false;
    for (const QJsonValue source : together.first()[u"diagnosis"][u"sources"].toArray()) {
        if (source[u"id"].toString() == "commonLag") {
            found = true;
            QVERIFY(std::abs(source[u"value"].toDouble() + 15) < 0.2);
        }
    }
    QVERIFY(found);
}

void SynthesizeCommandTest::sumOfWhatCannotBeTold() {
    const QString file = path("oneSense.palmer");
    QCOMPARE(runCli({"synthesize", "circular", "--senses", "clockwise", "--points", "360", "--noise", "0.1",
                     "--source", "squareness=30", "-o", file})
                 .code,
             0);
    const QJsonArray sources = jsonOf(runCli({"evaluate", file, "--json"}).out)[u"tests"]
                                   .toArray()
                                   .first()[u"diagnosis"][u"sources"]
                                   .toArray();
    int sums = 0;
    int apart = 0;
    for (const QJsonValue source : sources) {
        if (source[u"id"].toString() == "squareness") {
            ++apart;
            QVERIFY(source[u"value"].isNull() && !source[u"separable"].toBool());
            QCOMPARE(source[u"with"].toArray().first().toString(), QString("servoMismatch"));
        }
        const QJsonValue first = source[u"of"].toArray().first();
        if (source[u"id"].toString() == "sum" && first[u"id"].toString() == "squareness") {
            ++sums;
            QVERIFY(std::abs(source[u"value"].toDouble() - 30) < 5 * source[u"u"].toDouble());
            QCOMPARE(source[u"unit"].toString(), QString("µrad"));
        }
    }
    QCOMPARE(apart, 1);
    QCOMPARE(sums, 1);
    QVERIFY(runCli({"evaluate", file}).out.contains("Known of these sources is their sum: Squareness X–Y"));
}

void SynthesizeCommandTest::teachingExamples_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("value");
    const auto row = [](const char *file, const char *id, double value) {
        QTest::newRow(file) << QString(file) << QString(id) << value;
    };
    row("01-centre", "centre", 25);
    row("02-radius", "radius", 8);
    row("03-scale-mismatch", "scaleMismatch", 60);
    row("04-squareness", "squareness", 50);
    row("05-servo-mismatch", "servoMismatch", 0.6);
    row("06-backlash", "backlash", 6);
    row("07-lateral-play", "lateralPlay", 5);
    row("08-straightness", "straightness", 10);
    row("09-periodic-deviation", "cyclic", 2);
    row("10-reversal-spike", "reversalSpike", 6);
    row("11-common-lag", "commonLag", 20);
    row("12-drift", "radiusDrift", 3);
}

void SynthesizeCommandTest::teachingExamples() {
    QFETCH(QString, file);
    QFETCH(QString, id);
    QFETCH(double, value);
    const QString name = QStringLiteral(EXAMPLES "teaching-%1.palmer").arg(file);
    const QJsonObject results = jsonOf(runCli({"evaluate", name, "--json"}).out);
    const QJsonArray feeds = results[u"feedDiagnoses"].toArray();
    const QJsonObject whole =
        (feeds.isEmpty() ? results[u"tests"].toArray().first() : feeds.first())[u"diagnosis"].toObject();
    int known = 0;
    for (const QJsonValue source : whole[u"sources"].toArray()) {
        const bool wanted = source[u"id"].toString() == id && source[u"axis"].toString() != "Y";
        if (wanted && std::abs(source[u"value"].toDouble() - value) < 5 * source[u"u"].toDouble())
            ++known;
        // Nothing else is there but the same of the other axis.
        if (source[u"id"].toString() != id)
            QVERIFY2(std::abs(source[u"value"].toDouble()) < 5 * source[u"u"].toDouble(),
                     qPrintable(source[u"id"].toString()));
    }
    QCOMPARE(known, 1);
}

/// A vibration is no source that is fitted: it is left, at its frequency.
void SynthesizeCommandTest::vibrationStaysInTheRest() {
    const QJsonObject results =
        jsonOf(runCli({"evaluate", EXAMPLES "teaching-13-vibration.palmer", "--json"}).out);
    const QJsonObject diagnosis = results[u"tests"].toArray().first()[u"diagnosis"].toObject();
    // 0.8 µm · sin: 0.57 µm of standard deviation.
    QVERIFY(std::abs(diagnosis[u"residual"].toDouble() * 1e3 - 0.8 / std::sqrt(2.0)) < 0.02);
    // A wave is no noise: it is named, and no interval is given.
    QVERIFY(!diagnosis[u"modelFits"].toBool());
    QVERIFY(diagnosis[u"reasons"].toArray().first().toString().startsWith("a wave of "));
    for (const QJsonValue source : diagnosis[u"sources"].toArray())
        QVERIFY2(source[u"u"].isNull() && source[u"interval"].isNull(), qPrintable(source[u"id"].toString()));
    QCOMPARE(runCli({"synthesize", "circular", "--source", "vibration=0.8@12", "--feed", "3000", "--points",
                     "720", "--truth", path("v.json"), "-o", path("v.palmer")})
                 .code,
             0);
    const QJsonObject truth = jsonOf(contents(path("v.json")))[u"sources"].toArray().first().toObject();
    QCOMPARE(truth[u"id"].toString(), QString("vibration"));
    QCOMPARE(truth[u"value"].toDouble(), 0.8);
    QCOMPARE(truth[u"frequency"].toDouble(), 12.0);
}

void SynthesizeCommandTest::positioning() {
    const QString file = path("axis.palmer");
    QCOMPARE(runCli({"synthesize", "positioning", "--axis", "Z", "--travel", "500", "--targets", "6",
                     "--runs", "5", "--source", "scale=20", "--source", "backlash=4", "--truth",
                     path("axis.json"), "-o", file})
                 .code,
             0);
    const QJsonObject test =
        jsonOf(runCli({"evaluate", file, "--json"}).out)[u"tests"].toArray().first().toObject();
    for (const QJsonValue parameter : test[u"parameters"].toArray()) {
        const double value = parameter[u"value"].toDouble();
        if (parameter[u"id"].toString() == "M")
            QVERIFY(std::abs(value - 0.010) < 1e-12); // 20 µm/m over 500 mm
        if (parameter[u"id"].toString() == "B")
            QVERIFY(std::abs(value - 0.004) < 1e-12);
        if (parameter[u"id"].toString() == "Bmean")
            QVERIFY(std::abs(value + 0.004) < 1e-12); // what comes from above stands too far
    }
    QCOMPARE(jsonOf(contents(path("axis.json")))[u"sources"].toArray().size(), 2);
}

void SynthesizeCommandTest::sameSeedSameFile() {
    const auto made = [&](const char *name, const char *seed) {
        runCli({"synthesize", "circular", "--points", "100", "--noise", "1", "--correlation", "0.5", "--seed",
                seed, "-o", path(name)});
        return contents(path(name));
    };
    const QByteArray one = made("one.palmer", "7");
    QVERIFY(!one.isEmpty());
    QCOMPARE(made("two.palmer", "7"), one);
    QVERIFY(made("three.palmer", "8") != one);
}

void SynthesizeCommandTest::wrongUsage_data() {
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char *name, const QStringList &arguments) { QTest::newRow(name) << arguments; };
    row("no kind", {"-o", "x.palmer"});
    row("unknown kind", {"spiral", "-o", "x.palmer"});
    row("two kinds", {"circular", "positioning", "-o", "x.palmer"});
    row("no output", {"circular"});
    row("unknown source", {"circular", "--source", "rust=1", "-o", "x.palmer"});
    row("source without value", {"circular", "--source", "squareness", "-o", "x.palmer"});
    row("no number", {"circular", "--source", "squareness=much", "-o", "x.palmer"});
    row("axis missing", {"circular", "--source", "backlash=1", "-o", "x.palmer"});
    row("axis of another plane", {"circular", "--source", "backlash:Z=1", "-o", "x.palmer"});
    row("axis too many", {"circular", "--source", "squareness:X=1", "-o", "x.palmer"});
    row("shape too many", {"circular", "--source", "squareness=1@3", "-o", "x.palmer"});
    row("no pitch", {"circular", "--source", "cyclic:X=1@0", "-o", "x.palmer"});
    row("feed 0", {"circular", "--feed", "0", "-o", "x.palmer"});
    row("radius below 0", {"circular", "--radius", "-1", "-o", "x.palmer"});
    row("half a point", {"circular", "--points", "10.5", "-o", "x.palmer"});
    row("too many points", {"circular", "--points", "1e9", "-o", "x.palmer"});
    row("arc backwards", {"circular", "--arc", "90:0", "-o", "x.palmer"});
    row("arc too long", {"circular", "--arc", "0:400", "-o", "x.palmer"});
    row("arc of one end", {"circular", "--arc", "90", "-o", "x.palmer"});
    row("correlation 1", {"circular", "--correlation", "1", "-o", "x.palmer"});
    row("noise below 0", {"circular", "--noise", "-0.1", "-o", "x.palmer"});
    row("senses", {"circular", "--senses", "left", "-o", "x.palmer"});
    row("plane of one axis", {"circular", "--plane", "X", "-o", "x.palmer"});
    row("seed", {"circular", "--seed", "x", "-o", "x.palmer"});
    row("source of a circle", {"positioning", "--source", "squareness=1", "-o", "x.palmer"});
    row("no runs", {"positioning", "--runs", "0", "-o", "x.palmer"});
}

void SynthesizeCommandTest::wrongUsage() {
    QFETCH(QStringList, arguments);
    const CliResult result =
        runCli(QStringList{"synthesize"} + arguments.replaceInStrings("x.palmer", path("no.palmer")));
    QCOMPARE(result.code, 2);
    QCOMPARE(result.err.count('\n'), 1); // one sentence
    QVERIFY(!QFile::exists(path("no.palmer")));
    if (arguments.contains("rust=1"))
        QVERIFY2(result.err.contains("radiusDrift, vibration\n"), result.err); // every one there is
}

QTEST_GUILESS_MAIN(SynthesizeCommandTest)
#include "synthesizecommandtest.moc"
