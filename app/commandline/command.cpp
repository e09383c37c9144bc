// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/command.h"

#include "commands/commands.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palmer {

namespace {

constexpr std::array optionsOfAll{
    Option{"language", "fr|en", REPORT_TEXT("report", "language of tables, findings and errors")},
    Option{"help", "", REPORT_TEXT("report", "this help")},
};

/// Throws UsageError unless the value is one of the option's words, or a list of them ("fr,en") if one of the
/// words is a list.
void requireWord(const Option &option, const QString &given) {
    const QStringList words = wordsOf(option);
    const auto isWord = [&words](const QString &word) { return words.contains(word); };
    const bool takesLists =
        std::ranges::any_of(words, [](const QString &word) { return word.contains(u','); });
    const QStringList parts = takesLists ? given.split(u',') : QStringList(given);
    if (!words.isEmpty() && !std::ranges::all_of(parts, isWord))
        throw UsageError({REPORT_TEXT("report", "%1 cannot be %2; known: %3"),
                          {dashed(option).toStdString(), given.toStdString(),
                           words.join(QStringLiteral(", ")).toStdString()}},
                         given, words);
}

/// Stores an option with its value, which is `given` ("--name=value") or the next word.
void addOption(Invocation &invocation, const Option &option, std::optional<QString> given,
               const QStringList &words, qsizetype &next) {
    const bool wantsValue = *option.value != 0;
    if (wantsValue && !given && next < words.size())
        given = words[next++];
    // A script with an unset variable passes an empty value.
    if (wantsValue && (!given || (given->isEmpty() && !option.mayBeEmpty)))
        throw UsageError({REPORT_TEXT("report", "the option %1 needs a value (%2)"),
                          {dashed(option).toStdString(), std::string(option.value)}});
    if (!wantsValue && given)
        throw UsageError(
            {REPORT_TEXT("report", "the option %1 takes no value"), {dashed(option).toStdString()}});
    QStringList &values = invocation.options[QString::fromUtf8(option.name)];
    if (!values.isEmpty() && wantsValue && !option.repeats)
        throw UsageError({REPORT_TEXT("report", "the option %1 stands twice; it takes one value"),
                          {dashed(option).toStdString()}});
    if (given)
        requireWord(option, *given);
    values << given.value_or(QString());
    if (option.fileRead)
        invocation.filesOfOptions << option.fileRead(values.back());
}

/// True if the call contains something the option has an effect with.
bool hasEffect(const Option &option, const Invocation &invocation) {
    const QStringList partners = QString::fromUtf8(option.goesWith).split(u'|', Qt::SkipEmptyParts);
    return partners.isEmpty() || std::ranges::any_of(partners, [&](const QString &partner) {
               if (invocation.arguments.contains(partner))
                   return true;
               const auto found = invocation.options.find(partner.section(u'=', 0, 0));
               return found != invocation.options.end() &&
                      (!partner.contains(u'=') || found->second.contains(partner.section(u'=', 1)));
           });
}

/// The partners of an option, as typed: "--as csv, --as siemens".
std::string partnersOf(const Command &command, const Option &option) {
    QStringList typed;
    for (const QString &partner : QString::fromUtf8(option.goesWith).split(u'|')) {
        const Option *other = findOption(command.options, partner.section(u'=', 0, 0));
        typed << (other ? dashed(*other) + partner.mid(QByteArrayView(other->name).size()).replace(u'=', u' ')
                        : partner);
    }
    return typed.join(QStringLiteral(", ")).toStdString();
}

/// Throws UsageError for an option without effect, instead of silently ignoring it.
void requireEffects(const Command &command, const Invocation &invocation) {
    for (const Option &option : command.options) {
        if (invocation.has(option.name) && !hasEffect(option, invocation))
            refuseEffect(dashed(option).toStdString(), partnersOf(command, option));
    }
}

/// "title" of --title=x, "o" of -o; otherwise empty.
QString optionName(const QString &word) {
    const qsizetype mark = word.indexOf(u'=');
    const bool isLong = word.startsWith(QLatin1StringView("--"));
    const QString longName = word.mid(2, mark < 0 ? -1 : mark - 2);
    QString name = word.size() == 2 ? word.mid(1) : QString();
    if (isLong)
        name = longName.size() > 1 ? longName : QString();
    return name == QLatin1StringView("h") ? QStringLiteral("help") : name; // by convention
}

QStringList optionWords(const Command &command) {
    QStringList words;
    for (const auto &options : {command.options, std::span<const Option>(optionsOfAll)}) {
        for (const Option &option : options)
            words << dashed(option);
    }
    return words;
}

void resolveLanguage(Invocation &invocation) {
    const auto chosen = invocation.value("language"); // already checked to be a known word
    if (!chosen)
        return;
    invocation.language = Language::fromName(*chosen).value();
    invocation.languageChosen = true;
}

void requireFiles(const Command &command, const Invocation &invocation) {
    const bool takesFiles = *command.arguments != 0;
    const bool needsFiles = takesFiles && *command.arguments != '[';
    if (needsFiles && invocation.arguments.isEmpty())
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file (%2)"),
                          {std::string(command.name), std::string(command.arguments)}});
    if (!takesFiles && !invocation.arguments.isEmpty())
        throw UsageError(
            {REPORT_TEXT("report", "the command %1 takes no file"), {std::string(command.name)}});
    if (invocation.arguments.contains(QString()))
        throw UsageError({REPORT_TEXT("report", "the name of a file is empty")});
}

} // namespace

void refuseEffect(const std::string &option, const std::string &partners) {
    throw UsageError({REPORT_TEXT("report", "%1 has no effect here; it goes with: %2"), {option, partners}});
}

int worse(int a, int b) {
    return std::max(a, b); // higher codes rank higher
}

bool Invocation::has(const char *option) const {
    return options.contains(QLatin1StringView(option));
}

std::optional<QString> Invocation::value(const char *option) const {
    const auto found = options.find(QLatin1StringView(option));
    return found == options.end() ? std::nullopt : std::optional(found->second.front());
}

QStringList Invocation::values(const char *option) const {
    const auto found = options.find(QLatin1StringView(option));
    return found == options.end() ? QStringList() : found->second;
}

const Option *findOption(std::span<const Option> options, const QString &name) {
    const auto found = std::ranges::find_if(
        options, [&name](const Option &option) { return name == QString::fromUtf8(option.name); });
    return found == options.end() ? nullptr : &*found;
}

QString dashed(const Option &option) {
    const QString bare = QString::fromUtf8(option.name);
    return (bare.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + bare;
}

QStringList wordsOf(const Option &option) {
    const QString value = QString::fromUtf8(option.value);
    if (!value.contains(u'|') || value.front().isUpper()) // OUT.svg|png: a name with one of these endings
        return {};
    return value.split(u'|');
}

QStringList partsOf(const Command &command) {
    const QString known = QString::fromUtf8(command.arguments);
    return known.contains(u'|') && known.front().isLower() ? known.section(u' ', 0, 0).split(u'|')
                                                           : QStringList();
}

namespace {

/// Characters to change, insert, leave out or swap until one word is the other (optimal string alignment).
qsizetype distance(const QString &a, const QString &b) {
    std::vector<std::vector<qsizetype>> d(static_cast<std::size_t>(a.size()) + 1,
                                          std::vector<qsizetype>(static_cast<std::size_t>(b.size()) + 1));
    for (std::size_t i = 0; i < d.size(); ++i) {
        for (std::size_t j = 0; j < d[i].size(); ++j) {
            const auto at = [](const QString &word, std::size_t k) {
                return word[static_cast<qsizetype>(k)];
            };
            d[i][j] = static_cast<qsizetype>(i) + static_cast<qsizetype>(j);
            if (i == 0 || j == 0)
                continue;
            const qsizetype changed = at(a, i - 1) == at(b, j - 1) ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + changed});
            if (i > 1 && j > 1 && at(a, i - 1) == at(b, j - 2) && at(a, i - 2) == at(b, j - 1))
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d.back().back();
}

} // namespace

QString meant(const QString &given, const QStringList &words, const Language &language) {
    constexpr qsizetype longest = 40; // no word is longer
    const auto closest = std::ranges::min_element(words, {}, [&](const QString &word) {
        return distance(given.left(longest).toLower(), word.toLower());
    });
    const auto letters = std::ranges::count_if(given, [](QChar c) { return c != u'-'; });
    if (closest == words.end() ||
        distance(given.left(longest).toLower(), closest->toLower()) > 1 + letters / 4)
        return {};
    return language.semicolon() +
           language.sentence({REPORT_TEXT("report", "did you mean %1?"), {closest->toStdString()}});
}

std::span<const Option> commonOptions() {
    return optionsOfAll;
}

std::span<const Command> commands() {
    static const std::array table{evaluateCommand(), checkCommand(),   reportCommand(),  verifyCommand(),
                                  figureCommand(),   explainCommand(), compareCommand(), importCommand(),
                                  exportCommand(),   targetsCommand(), feedCommand(),    synthesizeCommand(),
                                  registerCommand(), schemaCommand(),  selftestCommand()};
    return table;
}

bool needsDrawing(const QStringList &words) {
    return std::ranges::any_of(commands(), [&words](const Command &command) {
        return command.draws && words.contains(QString::fromUtf8(command.name));
    });
}

Invocation parseArguments(const Command &command, const QStringList &words, Language language) {
    Invocation result{std::move(language), false, {}, {}, {}};
    bool onlyFiles = false;
    for (qsizetype next = 0; next < words.size();) {
        const QString &word = words[next++];
        if (onlyFiles || !word.startsWith(u'-') || word == QLatin1StringView("-")) {
            result.arguments << word;
        } else if (word == QLatin1StringView("--")) {
            onlyFiles = true;
        } else {
            const Option *option = findOption(command.options, optionName(word));
            if (!option)
                option = findOption(optionsOfAll, optionName(word));
            if (!option)
                throw UsageError({REPORT_TEXT("report", "unknown option %1 of the command %2"),
                                  {word.toStdString(), std::string(command.name)}},
                                 word.section(u'=', 0, 0), optionWords(command));
            const qsizetype mark = word.indexOf(u'=');
            addOption(result, *option, mark < 0 ? std::nullopt : std::optional(word.mid(mark + 1)), words,
                      next);
        }
    }
    // A command may redefine the option as the languages of its reports.
    if (!findOption(command.options, QStringLiteral("language")))
        resolveLanguage(result);
    if (!result.has("help")) {
        requireFiles(command, result);
        requireEffects(command, result);
    }
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

} // namespace palmer
