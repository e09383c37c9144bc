// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/fewtrials.h"
#include "app/runcli.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <map>

using namespace palmer::testdata;

namespace {

// A call that works; OUT stands for an empty folder.
struct Base {
    const char *name;
    QStringList words;
};

// What a call did.
struct Outcome {
    int code = -1;
    QByteArray said;
    std::map<QString, QByteArray> files;

    bool operator==(const Outcome &) const = default;
};

struct OptionRow {
    QString name;  // --edition, -o
    QString value; // placeholder, empty for a switch
};

/// The rotary axis with a budget: what an option does shows in any number of trials.
QByteArray axisOfFewTrials() {
    QFile file(EXAMPLES "rotary-axis.palmer");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(file.fileName()));
    return palmer::testdata::withFewTrials(file.readAll());
}

QStringList lines(const QStringList &arguments) {
    return QString::fromUtf8(runCli(arguments, {}, {{"COLUMNS", "1000"}}).out).split('\n');
}

QStringList commandsOfHelp() {
    QStringList names;
    for (const QString &line : lines({"--help"})) {
        if (line.startsWith("  ") && !line.startsWith("  -"))
            names << line.trimmed().section(' ', 0, 0);
    }
    return names;
}

QList<OptionRow> optionsOf(const QString &command) {
    QList<OptionRow> rows;
    static const QRegularExpression form("^  (--?[a-z-]+)(?: ([^ ]+))?  ");
    for (const QString &line : lines({command, "--help"})) {
        const auto match = form.match(line + "  ");
        if (match.hasMatch() && match.captured(1) != "--help")
            rows << OptionRow{match.captured(1), match.captured(2)};
    }
    return rows;
}

// What cannot be seen in an output, and why.
const std::map<QString, const char *> unseen{
    {"--jobs", "only the time"},
    {"--threads", "only the time"},
    {"--accept", "answers questions that a file may raise"},
    {"--force", "a permission"},
    {"--with-originals", "keeps what may be there"},
    {"--language", "of errors, too"},
    {"--set", "a field that this output may not speak of"},
    {"--template", "likewise"},
    {"--as", "the ending of OUT may say the same"},
};

} // namespace

class OptionEffectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void anEmptyValueIsRefused();
    void everyOptionHasAnEffectOrIsRefused_data();
    void everyOptionHasAnEffectOrIsRefused();
    void everyChoiceOfTheImportHasAnEffectOrIsRefused_data();
    void everyChoiceOfTheImportHasAnEffectOrIsRefused();

private:
    [[nodiscard]] QString at(const QString &name) const { return m_folder.filePath(name); }
    [[nodiscard]] Outcome outcome(QStringList words) const;
    [[nodiscard]] QStringList valuesOf(const QString &name) const;
    [[nodiscard]] std::vector<Base> bases() const;

    QTemporaryDir m_folder;
    std::map<QString, QList<OptionRow>> m_options;
};

void OptionEffectTest::initTestCase() {
    QVERIFY(m_folder.isValid());
    write(at("m.palmer-template"),
          R"({"format": "palmer template", "version": 1, "name": "m", "machine": {"name": "Big mill"}})");
    write(at("axis.palmer"), axisOfFewTrials());
    QVERIFY(axisOfFewTrials().contains("trials"));
    write(at("drift.palmer"), R"({"format": "palmer test report", "version": 1, "tests": [{"kind": "drift",
        "times": [0, 60], "deviations": [0, 0.001]}]})");
    QVERIFY(
        QDir(m_folder.path()).mkdir("reference") &&
        QFile::copy(PALMER_SOURCE_DIR "/resources/reference/iso230-4-annex-c.json", at("reference/c.json")));
    QCOMPARE(runCli({"synthesize", "circular", "--feed", "1000", "--feed", "500", "--source", "commonLag=6",
                     "-o", at("two.palmer")})
                 .code,
             0);
    QCOMPARE(runCli({"report", at("two.palmer"), "-o", at("report.pdf"), "--language", "en"}).code, 0);
    for (const QString &command : commandsOfHelp())
        m_options[command] = optionsOf(command);
    QVERIFY(m_options.size() > 10);
}

std::vector<Base> OptionEffectTest::bases() const {
    const QString axis = at("axis.palmer");
    std::vector<Base> all{
        {"evaluate an axis", {"evaluate", axis}},
        {"evaluate as JSON", {"evaluate", axis, "--json"}},
        {"evaluate into a table", {"evaluate", EXAMPLES "rotary-axis.palmer", "--table", "csv"}},
        {"evaluate circles", {"evaluate", at("two.palmer")}},
        {"evaluate a drift test", {"evaluate", at("drift.palmer")}},
        {"evaluate a measurement", {"evaluate", PALMER_SOURCE_DIR "/doc/x-axis.csv", "--accept"}},
        {"check", {"check", axis}},
        {"check circles", {"check", at("two.palmer")}},
        {"report", {"report", axis, "--language", "en", "-o", "OUT/r.pdf"}},
        {"report of circles", {"report", at("two.palmer"), "--language", "en", "-o", "OUT/r.pdf"}},
        {"verify", {"verify", at("report.pdf")}},
        {"extract", {"verify", at("report.pdf"), "--extract", "OUT/x.palmer"}},
        {"figure of an axis", {"figure", axis, "-o", "OUT/f.svg"}},
        {"figure of a circle", {"figure", at("two.palmer"), "-o", "OUT/f.csv"}},
        {"explain", {"explain", axis}},
        {"explain one", {"explain", at("two.palmer"), "G(b)_XY"}},
        {"compare two tests",
         {"compare", EXAMPLES "x-axis-as-found-as-left.palmer", EXAMPLES "x-axis-as-found-as-left.palmer"}},
        {"import", {"import", PALMER_SOURCE_DIR "/doc/x-axis.csv", "--accept", "-o", "OUT/i.palmer"}},
        {"targets as text", {"targets", "--travel", "800", "-o", "OUT/t.txt"}},
        {"targets to fill in", {"targets", "--travel", "800", "-o", "OUT/t.palmer"}},
        {"part program",
         {"targets", "--travel", "800", "--period", "20", "--program", "iso", "-o", "OUT/t.nc"}},
        {"schema", {"schema", "results"}},
        {"feed", {"feed", "--specified-diameter", "100", "--specified-feed", "500", "--diameter", "125"}},
        {"synthesize circles", {"synthesize", "circular", "-o", "OUT/s.palmer"}},
        {"synthesize noisy circles", {"synthesize", "circular", "--noise", "0.1", "-o", "OUT/s.palmer"}},
        {"synthesize a machine",
         {"synthesize", "circular", "--source", "radiusDrift=3", "-o", "OUT/s.palmer"}},
        {"synthesize one sense", {"synthesize", "circular", "--senses", "clockwise", "-o", "OUT/s.palmer"}},
        {"synthesize a drift test", {"synthesize", "drift", "-o", "OUT/s.palmer"}},
        {"synthesize an axis", {"synthesize", "positioning", "-o", "OUT/s.palmer"}},
        {"synthesize a noisy axis", {"synthesize", "positioning", "--noise", "0.1", "-o", "OUT/s.palmer"}},
        {"self-test", {"selftest", at("reference")}},
    };
    struct Form {
        const char *name;
        const char *ending;
    };
    for (const Form &form : {Form{"csv", "csv"},
                             {"json", "json"},
                             {"linuxcnc", "comp"},
                             {"siemens", "mpf"},
                             {"weihong", "dat"},
                             {"compensation-csv", "csv"},
                             {"program", "nc"}}) {
        QStringList words{"export", EXAMPLES "long-axis-with-zone.palmer", "--as", form.name,
                          "-o",     QString("OUT/e.") + form.ending};
        if (QString(form.name) == "program")
            words << "--dialect"
                  << "iso";
        if (QString(form.name) == "siemens")
            words << "--reference"
                  << "0";
        all.push_back({form.name, words});
    }
    return all;
}

Outcome OptionEffectTest::outcome(QStringList words) const {
    const QTemporaryDir out;
    for (QString &word : words)
        word.replace("OUT/", out.filePath("") + "/");
    const CliResult result = runCli(words);
    Outcome outcome{result.code, result.out + '\x1F' + result.err, {}};
    outcome.said.replace(out.path().toUtf8(), "OUT");
    QDirIterator files(out.path(), QDir::Files);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly))
            outcome.files[files.fileName()] = file.readAll();
    }
    return outcome;
}

// Values of which one at least does something on a file that the option is for.
QStringList OptionEffectTest::valuesOf(const QString &name) const {
    const std::map<QString, QStringList> known{
        {"--edition", {"ISO 230-2:1988", "ISO 230-4:1996"}},
        {"--editions", {"ISO 230-2:1988", "ISO 230-4:1996"}},
        {"--jobs", {"2"}},
        {"--name", {"{axis}"}},
        {"--seed", {"7"}},
        {"--trials", {"1000"}},
        {"--threads", {"2"}},
        {"--template", {at("m.palmer-template")}},
        {"--profile", {"none"}},
        {"--set", {"machine.name=Other"}},
        {"--test", {"2"}},
        {"-o", {"OUT/other"}},
        {"--extract", {"OUT/other.palmer"}},
        {"--report", {"OUT/validation.pdf"}},
        {"--compare", {at("other.comp")}},
        {"--tolerance", {"12"}},
        {"--truth", {"OUT/truth.json"}},
        {"--axis", {"Y"}},
        {"--travel", {"700"}},
        {"--from", {"100"}},
        {"--range", {"-50:900"}},
        {"--zone", {"100:600"}},
        {"--to", {"900"}},
        {"--interval", {"50"}},
        {"--reference", {"100"}},
        {"--per-metre", {"7"}},
        {"--period", {"30"}},
        {"--decimals", {"1"}},
        {"--runs", {"3"}},
        {"--feed", {"700"}},
        {"--dwell", {"9"}},
        {"--approach", {"4"}},
        {"--specified-diameter", {"200"}},
        {"--specified-feed", {"300"}},
        {"--diameter", {"50"}},
        {"--source", {"backlash:X=6"}},
        {"--plane", {"YZ"}},
        {"--radius", {"50"}},
        {"--points", {"90"}},
        {"--arc", {"0:90"}},
        {"--pause", {"0.5"}},
        {"--targets", {"5"}},
        {"--noise", {"0.7"}},
        {"--correlation", {"0.5"}},
        {"--resolution", {"0.1"}},
        {"--hours", {"4"}},
        {"--step", {"120"}},
    };
    const auto found = known.find(name);
    return found == known.end() ? QStringList() : found->second;
}

/// That of a script whose variable is not set: `report -o ""` must not write ".fr.pdf".
void OptionEffectTest::anEmptyValueIsRefused() {
    for (const auto &[command, options] : m_options) {
        for (const OptionRow &option : options) {
            if (option.value.isEmpty() || option.name == "--number") // a history may have none
                continue;
            const CliResult result = runCli({command, "FILE", option.name, ""});
            QCOMPARE(result.code, 2);
            QVERIFY2(result.err.contains("the option " + option.name.toUtf8() + " needs a value"),
                     result.err.constData());
        }
        const CliResult result = runCli({command, ""});
        QVERIFY2(result.code == 2 && result.err.contains("empty") != result.err.contains("takes no file"),
                 result.err.constData());
    }
}

void OptionEffectTest::everyOptionHasAnEffectOrIsRefused_data() {
    QTest::addColumn<QStringList>("words");
    const std::vector<Base> all = bases();
    for (const Base &base : all)
        QTest::newRow(base.name) << base.words;
    // A command that comes is to be tried here, too. That of the register has words of its own and is tried
    // there.
    for (const auto &[command, options] : m_options) {
        const bool isTried =
            command == "register" || command == "help" ||
            std::ranges::any_of(all, [&](const Base &base) { return base.words[0] == command; });
        QVERIFY2(isTried, qPrintable(command));
    }
}

void OptionEffectTest::everyOptionHasAnEffectOrIsRefused() {
    QFETCH(const QStringList, words);
    const Outcome base = outcome(words);
    QVERIFY2(base.code <= 1, base.said);
    QCOMPARE(outcome(words), base); // else nothing could be seen
    for (const OptionRow &option : m_options[words.front()]) {
        if (unseen.contains(option.name))
            continue;
        QStringList values = valuesOf(option.name);
        if (option.value.contains('|') && !option.value.front().isUpper())
            values = option.value.split('|');
        if (option.value.isEmpty())
            values = {QString()};
        QVERIFY2(!values.isEmpty(), qPrintable("a value for " + option.name));
        bool hasEffect = false;
        bool isRefused = true;
        for (const QString &value : values) {
            QStringList other = words;
            const auto stands = other.indexOf(option.name);
            if (stands >= 0 && !option.value.isEmpty())
                other[stands + 1] = value;
            else if (stands < 0)
                other << option.name << (option.value.isEmpty() ? QStringList() : QStringList(value));
            const Outcome with = outcome(other);
            hasEffect |= with.code <= 1 && with != base;
            isRefused &= with.code > 1;
            if (hasEffect)
                break;
        }
        if (option.value.isEmpty() && words.contains(option.name)) { // a switch that stands already
            QStringList without = words;
            without.removeOne(option.name);
            hasEffect = outcome(without) != base;
        }
        QVERIFY2(hasEffect || isRefused, qPrintable(option.name + " does nothing: " + words.join(' ')));
    }
}

void OptionEffectTest::everyChoiceOfTheImportHasAnEffectOrIsRefused_data() {
    QTest::addColumn<QString>("file");
    for (const char *file : {"tables/circle-xy.csv", "tables/circle-radius.csv", "tables/drift.csv",
                             "tables/list.csv", "tables/bare-alternating.txt", "rtl/typical.rtl"})
        QTest::newRow(file) << DATA + QString(file);
}

void OptionEffectTest::everyChoiceOfTheImportHasAnEffectOrIsRefused() {
    QFETCH(const QString, file);
    const QStringList words{"import", file, "--accept", "-o", "OUT/i.palmer"};
    const Outcome base = outcome(words);
    static const QRegularExpression form("^  ([a-zA-Z0-9]+) +[^:]*: (.*)$");
    static const QRegularExpression word(R"((?:^|, )([^,()]+)(?: \([^,]*\))?)");
    int keys = 0;
    for (const QString &line : lines({"import", "--help", "KEYS"})) {
        const auto match = form.match(line);
        if (!match.hasMatch())
            continue;
        ++keys;
        const QString key = match.captured(1);
        QStringList values{"1"}; // of numbers and texts
        if (match.captured(2).contains(", "))
            values.clear();
        auto found = word.globalMatch(match.captured(2));
        while (values.isEmpty() || (match.captured(2).contains(", ") && found.hasNext()))
            values << found.next().captured(1).trimmed();
        bool hasEffect = false;
        bool isRefused = true;
        int unchanged = 0;
        for (const QString &value : values) {
            const Outcome with = outcome(words + QStringList{"--set", key + "=" + value});
            hasEffect |= with != base && with.code <= 1;
            isRefused &= with.code > 1;
            unchanged += with == base ? 1 : 0;
            if (hasEffect)
                break;
        }
        const bool isAnswer = values == QStringList("1") && !match.captured(2).contains("text") &&
                              !match.captured(2).contains("number");
        if (key == "encoding") // plain ASCII is the same in all
            continue;
        const bool isAsItIs = unchanged < values.size(); // some words say what was found
        QVERIFY2(hasEffect || isRefused || isAnswer || isAsItIs, qPrintable(key + " does nothing: " + file));
    }
    QVERIFY(keys > 30);
}

QTEST_GUILESS_MAIN(OptionEffectTest)
#include "optioneffecttest.moc"
