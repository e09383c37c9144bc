#include "commands/command.h"

#include "commands/check.h"
#include "commands/evaluate.h"
#include "commands/explain.h"
#include "commands/export.h"
#include "commands/feed.h"
#include "commands/figure.h"
#include "commands/import.h"
#include "commands/register.h"
#include "commands/report.h"
#include "commands/selftest.h"
#include "commands/synthesize.h"
#include "commands/targets.h"
#include "commands/verify.h"
#include "report/plaintext.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

// Valid for every command.
constexpr std::array commonOptions{
    Option{"language", "fr|en", REPORT_TEXT("report", "language of tables, findings and errors")},
    Option{"help", "", REPORT_TEXT("report", "this help")},
};

struct HelpRow {
    QString left;
    QString right;
};

QString rows(const std::vector<HelpRow> &list) {
    int width = 0;
    for (const HelpRow &row : list)
        width = std::max(width, displayWidth(row.left));
    QString text;
    for (const HelpRow &row : list) {
        const int indent = width + 4;
        const QStringList lines = wrapped(row.right, terminalWidth - indent);
        for (qsizetype i = 0; i < lines.size(); ++i) {
            const QString left = i == 0 ? QStringLiteral("  ") + row.left : QString();
            text += left + QString(indent - displayWidth(left), u' ') + lines[i] + u'\n';
        }
    }
    return text;
}

/// The option as it is typed: -o, --help.
QString dashed(const Option &option) {
    const QString bare = QString::fromUtf8(option.name);
    return (bare.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + bare;
}

QString optionName(const Option &option) {
    QString name = dashed(option);
    if (*option.value != 0)
        name += u' ' + QString::fromUtf8(option.value);
    return name;
}

void addOptions(std::vector<HelpRow> &list, std::span<const Option> options, const Language &language) {
    for (const Option &option : options)
        list.push_back({optionName(option), language.text(option.description)});
}

QString commandLine(const Command &command) {
    return QString::fromUtf8(command.name) + u' ' + QString::fromUtf8(command.arguments);
}

const Option *findOwnOption(const Command &command, const QString &name) {
    const auto found = std::ranges::find_if(
        command.options, [&name](const Option &option) { return name == QString::fromUtf8(option.name); });
    return found == command.options.end() ? nullptr : &*found;
}

const Option *findOption(const Command &command, const QString &name) {
    if (const Option *own = findOwnOption(command, name))
        return own;
    const auto found = std::ranges::find_if(
        commonOptions, [&name](const Option &option) { return name == QString::fromUtf8(option.name); });
    return found == commonOptions.end() ? nullptr : &*found;
}

/// An option with its value, which is `given` ("--name=value") or the next word.
void take(Invocation &invocation, const Option &option, std::optional<QString> given,
          const QStringList &words, qsizetype &next) {
    const bool wantsValue = *option.value != 0;
    if (wantsValue && !given && next < words.size())
        given = words[next++];
    if (wantsValue && !given)
        throw UsageError({REPORT_TEXT("report", "the option %1 needs a value (%2)"),
                          {dashed(option).toStdString(), std::string(option.value)}});
    if (!wantsValue && given)
        throw UsageError(
            {REPORT_TEXT("report", "the option %1 takes no value"), {dashed(option).toStdString()}});
    QString &value = invocation.options[QString::fromUtf8(option.name)];
    value = option.repeats && !value.isEmpty() ? value + u'\n' + given.value_or(QString())
                                               : given.value_or(QString());
}

} // namespace

int worse(int a, int b) {
    return std::max(a, b); // the codes ascend in their rank
}

bool Invocation::has(QLatin1StringView option) const {
    return options.contains(option);
}

std::optional<QString> Invocation::value(QLatin1StringView option) const {
    const auto found = options.find(option);
    return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::span<const Command> commands() {
    static const std::array table{evaluateCommand(), checkCommand(),   reportCommand(),     verifyCommand(),
                                  figureCommand(),   explainCommand(), importCommand(),     exportCommand(),
                                  targetsCommand(),  feedCommand(),    synthesizeCommand(), registerCommand(),
                                  selftestCommand()};
    return table;
}

bool needsDrawing(const QStringList &words) {
    return std::ranges::any_of(commands(), [&words](const Command &command) {
        return command.draws && words.contains(QString::fromUtf8(command.name));
    });
}

Invocation parseArguments(const Command &command, const QStringList &words, Language language) {
    Invocation result{std::move(language), false, {}, {}};
    bool onlyFiles = false;
    for (qsizetype next = 0; next < words.size();) {
        const QString &word = words[next++];
        if (onlyFiles || !word.startsWith(u'-') || word == QLatin1StringView("-")) {
            result.arguments << word;
        } else if (word == QLatin1StringView("--")) {
            onlyFiles = true;
        } else {
            const qsizetype mark = word.indexOf(u'=');
            const bool isLong = word.startsWith(QLatin1StringView("--"));
            const QString longName = word.mid(2, mark < 0 ? -1 : mark - 2);
            QString name = word.size() == 2 ? word.mid(1) : QString(); // -o
            if (isLong)
                name = longName.size() > 1 ? longName : QString();
            if (name == QLatin1StringView("h")) // as everywhere
                name = QStringLiteral("help");
            const Option *option = findOption(command, name);
            if (!option)
                throw UsageError({REPORT_TEXT("report", "unknown option %1 of the command %2"),
                                  {word.toStdString(), std::string(command.name)}});
            take(result, *option, mark < 0 ? std::nullopt : std::optional(word.mid(mark + 1)), words, next);
        }
    }
    // A command may give the option another meaning: the languages of its reports.
    const bool ownLanguage = findOwnOption(command, QStringLiteral("language"));
    if (const auto chosen = result.value(QLatin1StringView("language")); chosen && !ownLanguage) {
        const auto found = Language::fromName(*chosen);
        if (!found)
            throw UsageError(
                {REPORT_TEXT("report", "unknown language %1; known: fr, en"), {chosen->toStdString()}});
        result.language = *found;
        result.languageChosen = true;
    }
    if (result.has(QLatin1StringView("help")))
        return result;
    const bool takesFiles = *command.arguments != 0;
    if (takesFiles && result.arguments.isEmpty())
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file (%2)"),
                          {std::string(command.name), std::string(command.arguments)}});
    if (!takesFiles && !result.arguments.isEmpty())
        throw UsageError(
            {REPORT_TEXT("report", "the command %1 takes no file"), {std::string(command.name)}});
    return result;
}

std::optional<Language> chosenLanguage(const QStringList &words) {
    const QLatin1StringView option("--language");
    std::optional<Language> result;
    for (qsizetype i = 0; i < words.size() && words[i] != QLatin1StringView("--"); ++i) {
        QString name;
        if (words[i] == option)
            name = words.value(i + 1);
        else if (words[i].startsWith(option) && words[i].size() > option.size() &&
                 words[i][option.size()] == u'=')
            name = words[i].mid(option.size() + 1);
        if (auto language = Language::fromName(name))
            result = std::move(language);
    }
    return result;
}

QString programHelp(const Language &language) {
    std::vector<HelpRow> list;
    for (const Command &command : commands())
        list.push_back({commandLine(command).trimmed(), language.text(command.description)});
    std::vector<HelpRow> options;
    addOptions(options, commonOptions, language);
    options.push_back(
        {QStringLiteral("--version"), language.text(REPORT_TEXT("report", "version of the program"))});
    return language.text(REPORT_TEXT(
               "report", "palmer-cli evaluates machine-tool tests: positioning of axes (ISO 230-2), "
                         "circular tests (ISO 230-4).")) +
           QStringLiteral("\n\npalmer-cli ") +
           language.text(REPORT_TEXT("report", "COMMAND [OPTION]… [FILE]…")) + QStringLiteral("\n\n") +
           rows(list) + u'\n' + rows(options) + u'\n' +
           language.text(REPORT_TEXT("report",
                                     "FILE is a test file (.palmer), a report of Palmer (PDF) or a "
                                     "measurement file that can be imported; - is standard input.")) +
           u'\n';
}

QString commandHelp(const Command &command, const Language &language) {
    std::vector<HelpRow> options;
    addOptions(options, command.options, language);
    for (const Option &option : commonOptions) {
        if (!findOwnOption(command, QString::fromUtf8(option.name)))
            addOptions(options, {&option, 1}, language);
    }
    return QStringLiteral("palmer-cli ") + QString::fromUtf8(command.name) + QStringLiteral(" [OPTION]… ") +
           QString::fromUtf8(command.arguments) + QStringLiteral("\n\n") +
           wrapped(language.text(command.description), terminalWidth).join(u'\n') + QStringLiteral("\n\n") +
           rows(options);
}

} // namespace palmer
