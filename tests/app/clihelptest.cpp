// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"
#include "import/choices.h"
#include "report/blocks/plaintext.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTest>

using palmer::testdata::CliResult;
using palmer::testdata::runCli;

namespace {

QString out(const QStringList &words, const QString &columns = {}, const QString &locale = "C") {
    std::map<QString, QString> environment{{"LC_ALL", locale}};
    if (!columns.isEmpty())
        environment["COLUMNS"] = columns;
    const CliResult result = runCli(words, {}, environment);
    if (result.code != 0 || !result.err.isEmpty())
        qFatal("%s: %s", qPrintable(words.join(' ')), result.err.constData());
    return QString::fromUtf8(result.out);
}

QStringList commands() {
    QStringList names;
    for (const QString &line : out({"--complete", ""}).split('\n', Qt::SkipEmptyParts))
        names << line.section('\t', 0, 0);
    return names;
}

/// The first words of what may follow.
QStringList following(const QStringList &words) {
    QStringList result;
    for (const QString &line : out(QStringList{"--complete"} + words).split('\n', Qt::SkipEmptyParts))
        result << line.section('\t', 0, 0);
    return result;
}

/// What the shell makes of a line, whose bytes need not be UTF-8 as the words of QProcess are.
CliResult shell(const QByteArray &command) {
    QTemporaryFile script;
    if (!script.open() || script.write(command) != command.size() || !script.flush())
        qFatal("cannot write");
    QProcess process;
    process.start("/bin/sh", {script.fileName()});
    if (!process.waitForFinished(patience) || process.exitStatus() != QProcess::NormalExit)
        qFatal("%s did not end by itself", command.constData());
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

class CliHelpTest : public QObject {
    Q_OBJECT

private slots:
    void listsEveryKeyOfSet() {
        for (const char *command : {"import", "evaluate", "report"}) {
            for (const char *language : {"en", "fr"}) {
                const QString text = out({command, "--help", "KEYS", "--language", language}, "1000");
                for (const palmer::ImportKey &key : palmer::importKeys()) {
                    const qsizetype at = text.indexOf(QString("\n  ") + key.key + ' ');
                    QVERIFY2(at >= 0, key.key);
                    const QString line = text.mid(at + 1).section('\n', 0, 0);
                    for (const palmer::ImportWord &word : key.words)
                        QVERIFY2(line.contains(word.word), qPrintable(line));
                }
            }
        }
        QVERIFY(out({"import", "--help"}).contains("--help KEYS"));
        QVERIFY(!out({"feed", "--help"}).contains("KEYS"));
        QCOMPARE(out({"help", "import", "keys"}), out({"import", "--help", "KEYS"}));
    }

    void keepsToTheColumnsOfTheTerminal_data() {
        QTest::addColumn<int>("columns");
        for (const int columns : {72, 80, 140, 250})
            QTest::addRow("%d", columns) << columns;
    }
    void keepsToTheColumnsOfTheTerminal() {
        QFETCH(const int, columns);
        const QString width = QString::number(columns);
        for (const QString &command : commands()) {
            for (const char *language : {"en", "fr"}) {
                const QStringList words = command == "help"
                                              ? QStringList{"--help", "--language", language}
                                              : QStringList{command, "--help", "--language", language};
                for (const QString &line : out(words, width).split('\n'))
                    QVERIFY2(palmer::displayWidth(line) <= columns, qPrintable(command + ": " + line));
            }
        }
        const QString axis = EXAMPLES "rotary-axis.palmer";
        for (const QStringList &words :
             {QStringList{"evaluate", axis}, {"evaluate", axis, "--table", "text"}}) {
            if (columns < (words.size() > 2 ? 140 : 72))
                continue; // numbers are never broken
            int widest = 0;
            for (const QString &line : out(words, width).split('\n')) {
                QVERIFY2(palmer::displayWidth(line) <= columns, qPrintable(line));
                widest = std::max(widest, palmer::displayWidth(line));
            }
            QVERIFY2(words.size() < 3 || columns > 140 || widest > columns - 20,
                     qPrintable(QString::number(widest)));
        }
        // What goes into a file is as wide as it has to be, a row a line.
        QCOMPARE(out({"evaluate", axis, "--table", "text"}).split('\n').value(1).contains("centre"), true);
    }

    void printsNoColour() {
        for (const char *noColour : {"", "1"}) {
            const CliResult result = runCli({"evaluate", EXAMPLES "rotary-axis.palmer"}, {},
                                            {{"NO_COLOR", noColour}, {"TERM", "xterm"}});
            QVERIFY(!result.out.contains('\x1b') && !result.err.contains('\x1b'));
        }
    }

    void completesFromTheSameTables() {
        QVERIFY(commands().contains("evaluate"));
        QList<QStringList> calls;
        for (const QString &command : commands()) {
            if (command == "help")
                continue;
            calls << QStringList{command};
            for (const QString &part : following({command, ""}))
                calls << QStringList{command, part};
        }
        for (const QStringList &call : calls) {
            const QString help = out(call + QStringList{"--help"}, "1000");
            const QStringList options = following(call + QStringList{"-"});
            QVERIFY(options.contains("--help"));
            for (const QString &option : options)
                QVERIFY2(help.contains("\n  " + option + ' '), qPrintable(call.join(' ') + ' ' + option));
            qsizetype inHelp = 0;
            for (const QString &line : help.split('\n'))
                inHelp += line.startsWith("  -") && !line.startsWith("  --help KEYS") ? 1 : 0;
            QCOMPARE(options.size(), inHelp);
        }
        QCOMPARE(following({"ev"}), QStringList{"evaluate"});
        QCOMPARE(following({"evaluate", "--table", ""}), (QStringList{"csv", "text"}));
        QCOMPARE(following({"evaluate", "--table=t"}), QStringList{"--table=text"});
        QCOMPARE(following({"--language", "fr", "che"}), QStringList{"check"});
        QCOMPARE(following({"synthesize", ""}), (QStringList{"circular", "positioning", "drift"}));
        QCOMPARE(following({"import", "--set", "unit=a"}), (QStringList{"unit=arcmin", "unit=arcsec"}));
        QCOMPARE(following({"import", "--set", "deci"}), QStringList{"decimalMark="});
        QCOMPARE(following({"import", "--help", ""}), QStringList{"KEYS"});
        QVERIFY(following({"evaluate", "--edition", "ISO230-2:20"}).contains("ISO230-2:2014"));
        QCOMPARE(following({"evaluate", "x"}), QStringList()); // the shell knows the files
        QCOMPARE(following({"register", "scan", ""}), QStringList());
        QVERIFY(following({"schema", ""}).contains("results"));
        QVERIFY(out({"--complete", "ev"}, {}, "fr_FR.UTF-8").contains("résultats"));
        QCOMPARE(out({"evaluate", "--edition", "ISO230-2:2014", EXAMPLES "rotary-axis.palmer"}),
                 out({"evaluate", "--edition", "ISO 230-2:2014", EXAMPLES "rotary-axis.palmer"}));
    }

    void manualPageSaysWhatTheHelpSays() {
        for (const char *locale : {"C", "fr_FR.UTF-8"}) {
            QString page = out({"--manual-page"}, {}, locale);
            QVERIFY(page.startsWith(".TH PALMER\\-CLI 1") || page.startsWith(".TH PALMER-CLI 1"));
            page.replace("\\-", "-");
            for (const QString &command : commands()) {
                if (command == "help")
                    continue;
                QVERIFY2(page.contains("\n.SS " + command), qPrintable(command));
                for (const QString &line : out({command, "--help"}, "1000", locale).split('\n')) {
                    if (line.startsWith("  -") && !line.startsWith("  --help KEYS")) {
                        const QString typed = line.trimmed().section("  ", 0, 0);
                        QVERIFY2(page.contains("\\fB" + typed + "\\fR\n"), qPrintable(typed));
                    }
                }
            }
            for (const palmer::ImportKey &key : palmer::importKeys())
                QVERIFY2(page.contains(QString("\\fB") + key.key + "\\fR\n"), key.key);
            for (const QString &line : page.split('\n'))
                QVERIFY2(!line.startsWith('\'') && !line.startsWith(". "), qPrintable(line));
        }
    }

    void everyHelpHasExamplesAndExitCodes() {
        for (const QString &command : commands()) {
            if (command == "help")
                continue;
            const QString help = out({command, "--help"}, "1000");
            const QString examples = help.section("\nExamples\n", 1).section("\nExit codes\n", 0, 0);
            QVERIFY2(help.contains("\nExit codes\n  0  done\n"), qPrintable(command));
            QVERIFY2(examples.contains("  palmer-cli " + command), qPrintable(command));
            for (const QString &example : examples.split('\n', Qt::SkipEmptyParts)) {
                for (const QString &word : example.split(' ', Qt::SkipEmptyParts))
                    QVERIFY2(!word.startsWith('-') || help.contains("\n  " + word + ' '),
                             qPrintable(example));
            }
        }
        const QString trend = out({"help", "register", "trend"}, "1000");
        QVERIFY(trend.contains("--parameter") && !trend.contains("--prune") &&
                trend.contains("register trend"));
        QVERIFY(!trend.contains("register scan"));
        QCOMPARE(out({"register", "trend", "--help"}, "1000"), trend);
        QVERIFY(out({"help", "register", "join"}, "1000")
                    .startsWith("palmer-cli register join [OPTION]… MACHINE MACHINE\n"));
        QVERIFY(out({"help", "register", "scan"}, "1000", "fr_FR.UTF-8")
                    .startsWith("palmer-cli register scan [OPTION]… FOLDER…\n"));
        QVERIFY(!out({"help", "synthesize", "positioning"}).contains("--radius"));
        QVERIFY(out({"help", "synthesize", "circular"}).contains("--radius"));
    }

    void mandocHasNothingToSay() {
        for (const char *locale : {"C", "fr_FR.UTF-8"}) {
            QProcess lint;
            lint.start("mandoc", {"-Tlint"});
            QVERIFY(lint.waitForStarted());
            lint.write(out({"--manual-page"}, {}, locale).toUtf8());
            lint.closeWriteChannel();
            QVERIFY(lint.waitForFinished());
            QCOMPARE(lint.readAllStandardOutput() + lint.readAllStandardError(), QByteArray());
        }
    }

    void wrongUsageIsSaidInOneLine_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("says");
        const QString axis = EXAMPLES "rotary-axis.palmer";
        QTest::newRow("a command") << QStringList{"evalaute", axis} << QByteArray("did you mean evaluate?");
        QTest::newRow("an option") << QStringList{"evaluate", axis, "--jsno"}
                                   << QByteArray("did you mean --json?");
        QTest::newRow("a word") << QStringList{"evaluate", axis, "--table", "txet"}
                                << QByteArray("did you mean text?");
        QTest::newRow("a part") << QStringList{"register", "trand"} << QByteArray("did you mean trend?");
        QTest::newRow("help of a part")
            << QStringList{"help", "register", "scna"} << QByteArray("did you mean scan?");
        QTest::newRow("a schema") << QStringList{"schema", "result"} << QByteArray("did you mean results?");
        QTest::newRow("a kind") << QStringList{"synthesize", "cirular"}
                                << QByteArray("did you mean circular?");
        QTest::newRow("no profile") << QStringList{"evaluate", axis, "--profile", "x"}
                                    << QByteArray("--profile");
        QTest::newRow("a long name") << QStringList{"feed", QString(5000, 'x')}
                                     << QByteArray("takes no file");
        QTest::newRow("a long option")
            << QStringList{"feed", "--" + QString(5000, 'x')} << QByteArray("of the command");
        for (const char *option : {"--dwell", "--feed", "--approach"})
            QTest::newRow(option) << QStringList{"targets", "--travel", "500", option, "1e9", "-o", "-"}
                                  << QByteArray(option);
    }
    void wrongUsageIsSaidInOneLine() {
        QFETCH(const QStringList, words);
        QFETCH(const QByteArray, says);
        const QTemporaryDir home;
        const CliResult result = runCli(words, {}, {{"XDG_CONFIG_HOME", home.path()}});
        QCOMPARE(result.code, 2);
        QCOMPARE(result.err.count('\n'), 1);
        QVERIFY2(result.err.contains(says), result.err);
        QVERIFY2(QString::fromUtf8(result.err).size() <= 501, result.err);
        QVERIFY2(!result.err.trimmed().endsWith(':'), result.err);
    }

    void aSynthesisIsTheSameInEveryLocale() {
        const QStringList call{"synthesize", "positioning", "--noise", "1", "-o", "-"};
        QCOMPARE(out(call, {}, "fr_FR.UTF-8"), out(call));
    }

    // Names that are bytes and no UTF-8, as on old disks.
    void opensFilesOfForeignNames() {
        const QTemporaryDir folder;
        const QByteArray name = folder.path().toUtf8() + "/caf\xe9.palmer";
        QFile example(EXAMPLES "rotary-axis.palmer");
        QVERIFY(example.open(QIODevice::ReadOnly));
        const QByteArray bytes = example.readAll();
        std::FILE *file = std::fopen(name.constData(), "wb");
        QVERIFY(file && std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), file) ==
                            std::size_t(bytes.size()));
        std::fclose(file);
        const QString program = QStringLiteral(PALMER_CLI);
        const QByteArray cli = program.toUtf8();
        const CliResult one = shell(cli + " evaluate --json '" + name + "'");
        QCOMPARE(one.err, QByteArray());
        QCOMPARE(one.code, 0);
        QVERIFY2(one.out.contains("caf\xc3\xa9.palmer\""), one.out.left(300));
        const CliResult all = shell(cli + " evaluate --table csv '" + folder.path().toUtf8() + "'");
        QCOMPARE(all.code, 0);
        QVERIFY2(all.out.contains("caf\xc3\xa9.palmer,1,"), all.out.left(300));
        const CliResult report = shell(cli + " figure --as svg '" + folder.path().toUtf8() + "' -o '" +
                                       folder.path().toUtf8() + "/out'");
        QCOMPARE(report.err, QByteArray());
        QVERIFY(QFile::exists(folder.filePath("out/café.svg")));
        const CliResult missing = shell(cli + " evaluate '" + folder.path().toUtf8() + "/n\xe9.palmer'");
        QCOMPARE(missing.code, 3);
        QVERIFY2(missing.err.contains("n\xc3\xa9.palmer: there is no such file\n"), missing.err);
        const CliResult refused =
            shell(cli + " figure '" + name + "' -o '" + folder.path().toUtf8() + "/\xe9.svg'");
        QCOMPARE(refused.code, 3);
        QCOMPARE(refused.err.count('\n'), 1);
        QVERIFY2(refused.err.contains("UTF-8"), refused.err);
        // A register cannot hold the name, and says so.
        const QByteArray path = folder.path().toUtf8();
        for (const QByteArray &words :
             {"scan '" + path + "' --register '" + path + "/r.sqlite'", "type --parameter A '" + name + "'",
              "scan '" + path + "/out' --register '" + path + "/\xe9.sqlite'",
              "list --register '" + path + "/\xe9.sqlite'"}) {
            const CliResult result = shell(cli + " register " + words);
            QCOMPARE(result.code, 3);
            QVERIFY2(result.err.contains("\xc3\xa9") && result.err.contains("UTF-8"), result.err);
        }
    }

    // A stack larger than the memory that may be had: no thread ever begins.
    void doesWithoutThreads_data() {
        QTest::addColumn<QByteArray>("words");
        const QByteArray axis = EXAMPLES "rotary-axis.palmer";
        QTest::newRow("report") << "report " + axis + " --language en -o - --force";
        QTest::newRow("simulation") << "evaluate --json --uncertainty monteCarlo --trials 20000 " + axis;
        QTest::newRow("circle") << QByteArray("evaluate --json LONG");
        QTest::newRow("import") << QByteArray("import TABLE -o - --accept");
        QTest::newRow("register") << QByteArray("register scan EXAMPLES --register FOLDER/r.db");
    }
    void doesWithoutThreads() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("the sanitizer reserves more memory than any limit lets it");
#endif
        QFETCH(QByteArray, words);
        const QTemporaryDir folder;
        const QByteArray path = folder.path().toUtf8();
        const QByteArray cli = PALMER_CLI;
        words.replace("FOLDER", path).replace("EXAMPLES", EXAMPLES);
        if (words.contains("LONG")) {
            QCOMPARE(shell(cli + " synthesize circular --points 300000 -o " + path + "/long.palmer").code, 0);
            words.replace("LONG", path + "/long.palmer");
        }
        if (words.contains("TABLE")) { // more than a megabyte
            QFile table(folder.filePath("table.csv"));
            QVERIFY(table.open(QIODevice::WriteOnly));
            table.write("Target mm;1 up um;1 down um\n");
            for (int i = 0; i < 120'000; ++i)
                table.write(QByteArray::number(i * 0.01, 'f', 2) + ";1.5;2.5\n");
            table.close();
            words.replace("TABLE", path + "/table.csv");
        }
        const CliResult usual = shell(cli + ' ' + words);
        if (words.startsWith("register"))
            QVERIFY(QFile::remove(folder.filePath("r.db")));
        const CliResult without = shell("ulimit -s 8000000; ulimit -v 2000000; " + cli + ' ' + words);
        QCOMPARE(without.code, usual.code);
        QCOMPARE(without.out, usual.out);
        QCOMPARE(without.err, usual.err);
    }

    // Whatever memory there is, one line and a code, never a crash.
    void saysThatThereIsNotEnoughMemory_data() {
        QTest::addColumn<QByteArray>("words");
        const QByteArray axis = EXAMPLES "rotary-axis.palmer";
        QTest::newRow("simulate") << "evaluate --uncertainty monteCarlo --trials 100000 " + axis;
        QTest::newRow("report") << "report " + axis + " --language en -o /dev/null --force";
        QTest::newRow("many circles")
            << QByteArray("synthesize circular --points 4000000 -o /dev/null --force");
    }
    void saysThatThereIsNotEnoughMemory() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("the sanitizer reserves more memory than any limit lets it");
#endif
        QFETCH(const QByteArray, words);
        for (const int mebibytes : {700, 400, 250}) {
            QProcess process;
            const QByteArray line =
                "ulimit -v " + QByteArray::number(mebibytes * 1024) + "; exec " PALMER_CLI " " + words;
            process.start("/bin/sh", {"-c", QString::fromUtf8(line)});
            QVERIFY(process.waitForFinished(patience));
            const QByteArray err = process.readAllStandardError();
            if (err.contains("error while loading shared libraries"))
                break; // the system's word: too little even to begin
            QVERIFY2(process.exitStatus() == QProcess::NormalExit, line + ": " + err);
            QVERIFY2(process.exitCode() == 0 || process.exitCode() == 3, line + ": " + err);
            QVERIFY2(err.count('\n') == (process.exitCode() == 3 ? 1 : 0), line + ": " + err);
        }
    }
};

QTEST_GUILESS_MAIN(CliHelpTest)
#include "clihelptest.moc"
