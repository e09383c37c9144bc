// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "commands/registertrend.h"
#include "document/filewords.h"
#include "export/answersjson.h"
#include "register/due.h"
#include "register/jsonline.h"
#include "register/listing.h"
#include "register/machinechoices.h"
#include "register/register.h"
#include "register/scan.h"
#include "register/sincelast.h"
#include "register/storedsentence.h"
#include "report/blocks/plaintext.h"

#include <QDate>
#include <QDir>
#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

namespace palmer {

namespace {

// clang-format off
constexpr std::array registerOptions{
    Option{"register", "PATH|postgresql://…", REPORT_TEXT("report", "the register; without it that of the user"), false, "", false, itself},
    Option{"machine", "WORDS", REPORT_TEXT("report", "list, trend, report: name or serial number of the machine, its number in the list, or what names, maker, type or place contain")},
    Option{"axis", "X|XY", REPORT_TEXT("report", "list, trend, type: the axis, or the plane of circles")},
    Option{"kind", wordsToChoose<Kind>.data(), REPORT_TEXT("report", "list: the kind of test")},
    Option{"since", "DATE", REPORT_TEXT("report", "list: tests from that day on (YYYY-MM-DD)")},
    Option{"until", "DATE", REPORT_TEXT("report", "list: tests up to that day")},
    Option{"verdict", "respected|notProven|exceeded|noneAgreed", REPORT_TEXT("report", "list: how the tests stand to their limits")},
    Option{"due", "DATE", REPORT_TEXT("report", "list: tests after which another, or the certificate of an instrument, is due up to that day")},
    Option{"interval", "MONTHS", REPORT_TEXT("report", "list: months between tests, of machines that have no interval of their own")},
    Option{"text", "WORDS", REPORT_TEXT("report", "list: each of the words somewhere in names, title, date, edition, instruments or file")},
    Option{"csv", "", REPORT_TEXT("report", "list: for programs, a row per parameter")},
    Option{"decimal-mark", "point|comma", REPORT_TEXT("report", "list: of CSV for spreadsheets, with a byte-order mark"), false, "csv"},
    Option{"json", "", REPORT_TEXT("report", "list, trend, type, scan: as JSON, one object a line")},
    Option{"since-last", "", REPORT_TEXT("report", "list, trend: what has changed in each test since the last one of its axis or plane; reads their files")},
    Option{"files", "", REPORT_TEXT("report", "list: the files that cannot be read or are not found, with their reason")},
    Option{"parameter", "A", REPORT_TEXT("report", "trend: the parameter; may stand several times; without it the main ones; type: the parameter"), true},
    Option{"edition", "E", REPORT_TEXT("report", "trend, type: all tests evaluated anew under one edition")},
    Option{"type", "WORDS", REPORT_TEXT("report", "type: the type of the machines, or maker and type; may be left out where files are all of one")},
    Option{"content", "0.95", REPORT_TEXT("report", "type: share of the type that lies below the tolerance limit")},
    Option{"confidence", "0.95", REPORT_TEXT("report", "type: confidence of the tolerance limit")},
    Option{"distribution", "logNormal|normal", REPORT_TEXT("report", "type: distribution of the chosen tolerance limit; both are shown")},
    Option{"o", "OUT", REPORT_TEXT("report", "trend: OUT.csv, json, svg, png or pdf; type: OUT.json, svg, png or pdf; report: OUT.pdf, of two languages OUT.fr.pdf and OUT.en.pdf")},
    Option{"number", "N", REPORT_TEXT("report", "report: the number of the history; without it one of year and serial number"), false, "", true},
    Option{"prune", "", REPORT_TEXT("report", "scan: take out files that are not found any more; with --force also where a folder would lose more than half of its tests")},
    Option{"rebuild", "", REPORT_TEXT("report", "scan: make the register anew; until that is done others read it as it was")},
    Option{"watch", "", REPORT_TEXT("report", "scan: go on and scan again when something changes, until it is ended")},
    Option{"language", "fr|en|fr,en", REPORT_TEXT("report", "language of tables and errors; report: of the report, also both")},
    jobsOption,
    forceOption,
};
// clang-format on

/// A subcommand and the options it takes besides `register`.
struct Part {
    const char *name = nullptr;
    std::vector<const char *> options;
    qsizetype arguments = 0; ///< −1: any number
    int (*run)(const Invocation &) = nullptr;
};

QString dateOption(const Invocation &invocation, const char *option) {
    QString given = invocation.value(option).value_or(QString());
    constexpr qsizetype length = 10;
    if (!given.isEmpty() && (given.size() != length || !QDate::fromString(given, Qt::ISODate).isValid()))
        refuse(option, given, "YYYY-MM-DD");
    return given;
}

ScanOptions scanOptions(const Invocation &invocation) {
    ScanOptions result;
    result.jobs = jobsOf(invocation);
    result.prune = invocation.has("prune");
    result.force = invocation.has("force");
    result.progress = [](const ScanProgress &progress) { showProgress(progress.done, progress.total); };
    return result;
}

QByteArray json(const ScanResult &result) {
    return jsonLine("scan", {{"files", result.files},
                             {"read", result.read},
                             {"unreadable", result.unreadable.size()},
                             {"notFound", result.notFound},
                             {"pruned", result.pruned},
                             {"machines", result.machines},
                             {"tests", result.tests}});
}

int report(const ScanResult &result, const Invocation &invocation) {
    clearProgress();
    for (const Unreadable &one : result.unreadable)
        printError(one.path + QStringLiteral(": ") + sentenceFrom(one.error, invocation.language));
    const auto count = [](int value) { return Number{static_cast<double>(value), Quantity::count}; };
    if (invocation.has("json"))
        printOut(json(result));
    else
        printOut(
            invocation.language.sentence(
                {REPORT_TEXT("report", "Files: %1, of them read now: %2, unreadable: %3, not found: %4. "
                                       "Machines in the register: %5, tests: %6."),
                 {count(result.files), count(result.read), count(static_cast<int>(result.unreadable.size())),
                  count(result.notFound), count(result.machines), count(result.tests)}}) +
            u'\n');
    for (const QString &folder : result.notPruned)
        printError(folder + QStringLiteral(": ") +
                   invocation.language.text(REPORT_TEXT(
                       "report", "more than half of its tests are not found, as on a drive that is "
                                 "not connected; nothing was taken out, --force does it")));
    return !result.unreadable.empty() ? cannotRead : result.notPruned.isEmpty() ? done : wrongUsage;
}

QStringList foldersOf(const Invocation &invocation) {
    QStringList folders = invocation.arguments.mid(1);
    if (folders.isEmpty())
        throw UsageError({REPORT_TEXT("report", "register scan needs a folder"), {}});
    return folders;
}

/// True if a scan found other files than the one before.
bool hasChanged(const ScanResult &result, const ScanResult &before) {
    return result.read > 0 || result.pruned > 0 || result.files != before.files ||
           result.notFound != before.notFound || result.unreadable.size() != before.unreadable.size();
}

/// Scans repeatedly; reports an error of the register once until it is resolved.
[[noreturn]] void watch(const Invocation &invocation, const QStringList &folders, ScanResult before) {
    constexpr std::chrono::milliseconds least = std::chrono::seconds(2);
    constexpr int share = 10; // scans take at most a tenth of the time; network shares do not report changes
    std::chrono::milliseconds pause = least;
    QString said;
    for (;;) {
        std::this_thread::sleep_for(pause);
        const auto begin = std::chrono::steady_clock::now();
        try {
            Register reg(registerAddress(invocation));
            ScanResult result = scan(reg, folders, scanOptions(invocation));
            if (hasChanged(result, before))
                report(result, invocation);
            before = std::move(result);
            said.clear();
        } catch (const Error &error) {
            const QString sentence = invocation.language.sentence(error.message);
            if (sentence != said)
                printError(withoutPassword(registerAddress(invocation)), error, invocation.language);
            said = sentence;
        }
        pause = std::max(least, share * std::chrono::duration_cast<std::chrono::milliseconds>(
                                            std::chrono::steady_clock::now() - begin));
    }
}

int runScan(const Invocation &invocation) {
    const QStringList folders = foldersOf(invocation);
    const auto open = invocation.has("rebuild") ? Register::Open::rebuild : Register::Open::keep;
    ScanResult result;
    {
        Register reg(registerAddress(invocation), open);
        result = scan(reg, folders, scanOptions(invocation));
    }
    const int code = report(result, invocation);
    if (invocation.has("watch"))
        watch(invocation, folders, std::move(result));
    return code;
}

std::optional<Kind> kindOption(const Invocation &invocation) {
    const auto given = invocation.value("kind");
    if (!given)
        return std::nullopt;
    return ofFileWord<Kind>(given->toStdString()); // one of them: the option says so
}

void listFiles(Database &database, const Invocation &invocation) {
    const std::vector<ListedSource> sources = troubledSources(database);
    const bool json = invocation.has("json");
    if (sources.empty() && !json)
        printOut(invocation.language.text(REPORT_TEXT("report", "All files of the register can be read.")) +
                 u'\n');
    for (const ListedSource &source : sources) {
        const bool isGone = source.state == QLatin1StringView("notFound");
        QString why = isGone
                          ? invocation.language.text(REPORT_TEXT("report", "the file is not found any more"))
                          : sentenceFrom(source.error, invocation.language);
        const QString path = QString(source.path).replace(u'\n', u' ');
        if (json)
            printOut(errorJson(source.path, why, cannotRead)); // as of a file that a command fails on
        else
            printOut(path + QStringLiteral(": ") + why.replace(u'\n', u' ') + u'\n');
    }
}

class List {
public:
    explicit List(const Invocation &invocation)
        : m_invocation(invocation)
        , m_csv(invocation.has("csv"))
        , m_json(invocation.has("json"))
        , m_due(dateOption(invocation, "due"))
        , m_sinceLast(invocation.has("since-last"))
        , m_marks(csvMarks(invocation)) {
        m_filter.axis = invocation.value("axis").value_or(QString());
        m_filter.kind = kindOption(invocation);
        m_filter.since = dateOption(invocation, "since");
        m_filter.until = dateOption(invocation, "until");
        m_filter.limits = invocation.value("verdict").value_or(QString());
        m_filter.words = invocation.value("text").value_or(QString());
        const bool files = invocation.has("files");
        if (m_csv && (m_json || files))
            throw UsageError({REPORT_TEXT("report", "--%1 and --%2 do not go together"),
                              {std::string("csv"), std::string(files ? "files" : "json")}});
        if (const auto months = invocation.value("interval"))
            m_interval = static_cast<int>(wholeBetween("interval", *months, 1, longestInterval));
    }

    int run() {
        Register reg(registerAddress(m_invocation), Register::Open::read);
        Database &database = reg.database();
        if (m_invocation.has("files")) {
            listFiles(database, m_invocation);
            return done;
        }
        const auto called = m_invocation.value("machine");
        const std::vector<ListedMachine> list =
            called ? machinesCalled(database, *called) : machines(database);
        if (m_csv)
            printOut(m_marks.begin + listedTestsCsvHead(m_marks.decimal));
        for (const ListedMachine &machine : list) // only one machine is held in memory
            print(database, machine);
        if (!m_hasPrinted && !m_csv && !m_json)
            printOut(m_invocation.language.text(REPORT_TEXT("report", "No test of the register fits.")) +
                     u'\n');
        return done;
    }

private:
    void print(Database &database, const ListedMachine &machine) {
        TestFilter ofMachine; // due dates depend on all of its tests
        ofMachine.machines = {machine.id};
        std::vector<ListedTest> chosen = tests(database, ofMachine);
        (void)markDue(database, machine, chosen, m_interval);
        const std::vector<ListedTest> all = m_sinceLast ? chosen : std::vector<ListedTest>();
        const auto isDue = [this](const std::optional<std::string> &date) {
            return m_due.isEmpty() || (date && QString::fromStdString(*date) <= m_due);
        };
        std::erase_if(chosen, [&](const ListedTest &test) {
            return (!isDue(test.due) && !isDue(test.certificateDue)) || !matches(test, m_filter);
        });
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto shown = std::ranges::find(chosen, all[i].id, &ListedTest::id);
            const auto last = shown == chosen.end() ? std::nullopt : lastBefore(all, i);
            if (last)
                shown->sinceLast = sinceLast(all[*last], all[i]);
        }
        if (m_csv || m_json) {
            for (const ListedTest &test : chosen)
                printOut(m_csv ? listedTestCsv(test, m_marks.decimal) : listedTestJson(test));
        } else if (!chosen.empty()) {
            printOut((m_hasPrinted ? QStringLiteral("\n") : QString()) +
                     plainText(composeList(evidenceOf(machine, m_invocation.language), chosen,
                                           m_invocation.language)));
            m_hasPrinted = true;
        }
    }

    const Invocation &m_invocation;
    bool m_csv;
    bool m_json;
    QString m_due;
    TestFilter m_filter;
    std::optional<int> m_interval;
    bool m_sinceLast;
    CsvMarks m_marks;
    bool m_hasPrinted = false;
};

int runList(const Invocation &invocation) {
    return List(invocation).run();
}

/// Joins two machines, or sets the interval of one.
int runChoice(const Invocation &invocation) {
    const QStringList &words = invocation.arguments;
    std::optional<int> months;
    if (words[0] == QLatin1StringView("interval"))
        months = static_cast<int>(wholeBetween("MONTHS", words[2], 0, longestInterval));
    const QString address = registerAddress(invocation);
    const auto called = [&](const QString &name) {
        return machineCalled(Register(address, Register::Open::read).database(), name, invocation.language);
    };
    const ListedMachine machine = called(words[1]);
    const ListedMachine other = months ? machine : called(words[2]);
    if (!months && machine.id == other.id)
        throw UsageError({REPORT_TEXT("report", "“%1” and “%2” are one machine already"),
                          {words[1].toStdString(), words[2].toStdString()}});
    Register reg(address);
    for (const QString &sentence :
         chooseMachine(reg, machine, months ? nullptr : &other, months, invocation.language))
        printError(sentence);
    return done;
}

/// Separates a machine from the one that it was joined with, by its own name or serial number.
int runSeparate(const Invocation &invocation) {
    const QString &name = invocation.arguments[1];
    Register reg(registerAddress(invocation));
    const QString wanted = asCompared(name);
    for (const ListedMachine &machine : machines(reg.database())) {
        const auto part = std::ranges::find_if(machine.joined, [&](const MachineFields &joined) {
            return asCompared(joined.serialNumber) == wanted || asCompared(joined.name) == wanted;
        });
        if (part == machine.joined.end())
            continue;
        separateMachine(reg, machine, *part, invocation.language);
        return done;
    }
    throw UsageError({REPORT_TEXT("report", "no machine called “%1” was joined with another; “register list” "
                                            "shows which were"),
                      {name.toStdString()}});
}

const std::vector<Part> &parts() {
    static const std::vector<Part> all{
        {"scan", {"json", "prune", "rebuild", "watch", "jobs", "force"}, -1, runScan},
        {"list",
         {"machine", "axis", "kind", "since", "until", "verdict", "due", "interval", "text", "csv",
          "decimal-mark", "json", "since-last", "files"},
         0,
         runList},
        {"trend",
         {"machine", "axis", "parameter", "edition", "since-last", "json", "o", "force"},
         0,
         runRegisterTrend},
        {"report", {"machine", "number", "o", "force"}, 0, runRegisterReport},
        {"type",
         {"type", "parameter", "axis", "edition", "content", "confidence", "distribution", "json", "o",
          "force"},
         -1,
         runRegisterType},
        {"join", {}, 2, runChoice},
        {"separate", {}, 1, runSeparate},
        {"interval", {}, 2, runChoice},
    };
    return all;
}

/// True if the part takes the option, as every part takes that of the register and the language.
bool takes(const QString &part, const Option &option) {
    const auto found =
        std::ranges::find_if(parts(), [&](const Part &one) { return part == QLatin1StringView(one.name); });
    const std::string_view name = option.name;
    return name == "register" || name == "language" ||
           (found != parts().end() &&
            std::ranges::any_of(found->options, [&](const char *own) { return name == own; }));
}

int runRegister(const Invocation &invocation) {
    const QString word = invocation.arguments.front();
    const auto part =
        std::ranges::find_if(parts(), [&](const Part &one) { return word == QLatin1StringView(one.name); });
    if (part == parts().end()) {
        const QStringList known = partsOf(registerCommand());
        throw UsageError(
            {REPORT_TEXT("report", "%1 does not know “%2”; it knows: %3"),
             {std::string("register"), word.toStdString(), known.join(QStringLiteral(", ")).toStdString()}},
            word, known);
    }
    for (const auto &[name, value] : invocation.options) {
        if (!takes(word, *findOption(registerOptions, name)))
            throw UsageError({REPORT_TEXT("report", "unknown option %1 of the command %2"),
                              {(QString(name.size() == 1 ? 1 : 2, u'-') + name).toStdString(),
                               "register " + std::string(part->name)}});
    }
    const bool both = word == QLatin1StringView("report");
    for (const QString &name :
         invocation.value("language").value_or(QString()).split(u',', Qt::SkipEmptyParts)) {
        const bool alone = name == invocation.value("language");
        if (!Language::fromName(name) || (!alone && !both))
            throw UsageError({REPORT_TEXT("report", "unknown language %1; known: fr, en"),
                              {invocation.value("language")->toStdString()}});
    }
    if (part->arguments == 0 && invocation.arguments.size() > 1)
        throw UsageError({REPORT_TEXT("report", "register %1 takes no file"), {word.toStdString()}});
    if (part->arguments > 0 && invocation.arguments.size() != part->arguments + 1)
        throw UsageError({REPORT_TEXT("report", "expected: %1"),
                          {"register join MACHINE MACHINE, register separate MACHINE, register "
                           "interval MACHINE MONTHS"}});
    return codeOf(withoutPassword(registerAddress(invocation)), invocation.language,
                  [&] { return part->run(invocation); });
}

} // namespace

QString registerAddress(const Invocation &invocation) {
    const auto given = invocation.value("register");
    if (!given && QDir::homePath() == QDir::rootPath() && !qEnvironmentVariableIsSet("XDG_DATA_HOME"))
        throw UsageError(
            {REPORT_TEXT("report", "the user has no folder of their own (HOME): say with %1 where "
                                   "the register is"),
             {std::string("--register PATH")}});
    return given.value_or(Register::standardPath());
}

Command registerCommand() {
    static const std::string words = [] {
        std::string all;
        for (const auto &one : parts())
            all += (all.empty() ? "" : "|") + std::string(one.name);
        return all + " …";
    }();
    return {
        "register",
        words.c_str(),
        REPORT_TEXT("report",
                    "all tests of all machines in some folders, over the years: scan FOLDER…, list, trend, "
                    "report, type [FILE…], join MACHINE MACHINE, separate MACHINE, interval MACHINE MONTHS"),
        registerOptions,
        runRegister,
        true,
        takes};
}

} // namespace palmer
