#include "commands/command.h"
#include "commands/streams.h"

#include <QApplication>
#include <QCoreApplication>
#include <QHashFunctions>
#include <algorithm>
#include <array>
#include <csignal>
#include <memory>

namespace {

using namespace palmer;

/// The locale's language: the first of these that is set decides, as everywhere in POSIX.
Language languageOfLocale() {
    for (const char *variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const QString locale = qEnvironmentVariable(variable);
        if (!locale.isEmpty())
            return Language::fromLocale(locale);
    }
    return Language(Language::Id::english);
}

int runCommand(const Command &command, const QStringList &words, const Language &language) {
    const Invocation invocation = parseArguments(command, words, language);
    if (invocation.has(QLatin1StringView("help"))) {
        printOut(commandHelp(command, invocation.language));
        return done;
    }
    return command.run(invocation);
}

int runProgram(const QStringList &words, const Language &language) {
    // --language may stand before the command, too.
    const auto name = std::ranges::find_if(words, [&](const QString &word) {
        return !word.startsWith(u'-') &&
               !(&word != &words.front() && *(&word - 1) == QLatin1StringView("--language"));
    });
    const QStringList before(words.begin(), name);
    if (before.contains(QLatin1StringView("--version"))) {
        printOut(QStringLiteral("Palmer " PALMER_VERSION "\n"));
        return done;
    }
    if (before.contains(QLatin1StringView("--help"))) {
        printOut(programHelp(language));
        return done;
    }
    if (name == words.end())
        throw UsageError({REPORT_TEXT("report", "a command is missing; palmer-cli --help lists them"), {}});
    const auto found = std::ranges::find_if(
        commands(), [&](const Command &command) { return *name == QString::fromUtf8(command.name); });
    if (found == commands().end())
        throw UsageError({REPORT_TEXT("report", "unknown command %1; palmer-cli --help lists them"),
                          {name->toStdString()}});
    return runCommand(*found, before + QStringList(name + 1, words.end()), language);
}

/// stderr is ours: what Qt has to say of its surroundings (no XDG_RUNTIME_DIR) is no error of a file.
void keepQuiet(QtMsgType type, const QMessageLogContext &, const QString &message) {
    if (type == QtFatalMsg)
        printError(message);
}

/// Figures need a QApplication; it needs no display.
std::unique_ptr<QCoreApplication> applicationFor(const QStringList &words, char *argv[]) {
    static int count = 1; // the words are ours, none is Qt's
    if (!needsDrawing(words))
        return std::make_unique<QCoreApplication>(count, argv);
    qInstallMessageHandler(keepQuiet);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    return std::make_unique<QApplication>(count, argv);
}

} // namespace

int main(int argc, char *argv[]) {
    QHashSeed::setDeterministicGlobalSeed(); // else no two PDFs were alike
    std::signal(SIGXFSZ, SIG_IGN);           // a file that may not grow is an error with a sentence
    const Language ofLocale = languageOfLocale();
    // Qt speaks UTF-8 only and would say so on stderr under any other locale.
    qputenv("LC_ALL", "C.UTF-8");
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << QString::fromLocal8Bit(argv[i]);
    const auto application = applicationFor(words, argv);
    const Language language = chosenLanguage(words).value_or(ofLocale);
    try {
        return runProgram(words, language);
    } catch (const UsageError &error) {
        printError(language.sentence(error.message));
        return wrongUsage;
    } catch (const Error &error) {
        printError(QStringLiteral("-"), error, language);
        return cannotRead;
    }
}
