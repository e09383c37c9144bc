// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/command.h"
#include "commandline/help.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "environment.h"
#include "system/process.h"
#include "system/streams.h"

#include <QGuiApplication>
#include <QHashFunctions>
#include <algorithm>
#include <memory>
#include <new>

namespace {

using namespace palmer;

QStringList commandNames() {
    QStringList names;
    for (const Command &command : commands())
        names << QString::fromUtf8(command.name);
    return names;
}

/// Throws UsageError if there is no such command.
const Command &commandCalled(const QString &name) {
    const auto found = std::ranges::find_if(
        commands(), [&name](const Command &command) { return name == QString::fromUtf8(command.name); });
    if (found == commands().end())
        throw UsageError(
            {REPORT_TEXT("report", "unknown command %1; palmer-cli --help lists them"), {name.toStdString()}},
            name, commandNames());
    return *found;
}

int runCommand(const Command &command, const QStringList &words, const Language &language) {
    const Invocation invocation = parseArguments(command, words, language);
    if (invocation.has("help")) {
        const bool asksKeys = takesKeys(command) &&
                              invocation.arguments.contains(QLatin1StringView(keysWord), Qt::CaseInsensitive);
        const QStringList parts = partsOf(command);
        const QString part = invocation.arguments.value(0);
        if (!part.isEmpty() && !parts.isEmpty() && !parts.contains(part))
            throw UsageError({REPORT_TEXT("report", "%1 does not know “%2”; it knows: %3"),
                              {std::string(command.name), part.toStdString(),
                               parts.join(QStringLiteral(", ")).toStdString()}},
                             part, parts);
        printOut(asksKeys ? keysHelp(invocation.language)
                          : commandHelp(command, invocation.language, parts.isEmpty() ? QString() : part));
        return done;
    }
    return command.run(invocation);
}

int runProgram(const QStringList &words, const Language &language) {
    // For the shell and for packages; not in the help.
    if (words.value(0) == QLatin1StringView("--complete")) {
        printOut(completion(words.mid(1), language).toUtf8()); // a tab-separated table
        return done;
    }
    if (words.value(0) == QLatin1StringView("--manual-page")) {
        printOut(manualPage(language));
        return done;
    }
    // --language may also precede the command.
    const auto name = std::ranges::find_if(words, [&](const QString &word) {
        return !word.startsWith(u'-') &&
               !(&word != &words.front() && *(&word - 1) == QLatin1StringView("--language"));
    });
    const QStringList before(words.begin(), name);
    if (before.contains(QLatin1StringView("--version"))) {
        printOut(QStringLiteral("Palmer " PALMER_VERSION "\n"));
        return done;
    }
    const bool asksByName = name != words.end() && *name == QLatin1StringView("help");
    if (asksByName && name + 1 != words.end()) { // "help report" is "report --help"
        const QStringList rest(name + 1, words.end());
        return runCommand(commandCalled(rest.front()),
                          before + rest.mid(1) + QStringList{QStringLiteral("--help")}, language);
    }
    if (asksByName || before.contains(QLatin1StringView("--help")) ||
        before.contains(QLatin1StringView("-h"))) {
        printOut(programHelp(language));
        return done;
    }
    if (name == words.end())
        throw UsageError({REPORT_TEXT("report", "a command is missing; palmer-cli --help lists them"), {}});
    return runCommand(commandCalled(*name), before + QStringList(name + 1, words.end()), language);
}

/// Suppresses Qt's warnings about the environment (no XDG_RUNTIME_DIR): stderr is for errors of files.
void keepQuiet(QtMsgType type, const QMessageLogContext &, const QString &message) {
    if (type == QtFatalMsg)
        printError(message);
}

/// Figures need a QGuiApplication, but no display.
std::unique_ptr<QCoreApplication> applicationFor(const QStringList &words, char **argv) {
    static int count = 1; // no arguments for Qt
    if (!needsDrawing(words))
        return std::make_unique<QCoreApplication>(count, argv);
    qInstallMessageHandler(keepQuiet);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    useOwnFontConfiguration();
    return std::make_unique<QGuiApplication>(count, argv);
}

} // namespace

int main(int argc, char *argv[]) {
    prepareStreams();
    QHashSeed::setDeterministicGlobalSeed(); // otherwise PDFs would differ
    reportFilesTooLarge();
    const Language ofLocale = languageOfLocale();
    // Qt requires UTF-8 and would warn on stderr about any other locale.
    qputenv("LC_ALL", "C.UTF-8");
    const QStringList words = wordsOf(argc, argv);
    static_cast<void>(terminalColumns()); // before standard output is redirected
    const Language language = chosenLanguage(words).value_or(ofLocale);
    try {
        const auto application = applicationFor(words, argv);
        return runProgram(words, language);
    } catch (const UsageError &error) {
        printError(language.sentence(error.message) + meant(error.given, error.words, language));
        return wrongUsage;
    } catch (const Error &error) {
        printError(QStringLiteral("-"), error, language);
        return cannotRead;
    } catch (const std::bad_alloc &) {
        printError(language.sentence(notEnoughMemory().message));
        return cannotRead;
    }
}
