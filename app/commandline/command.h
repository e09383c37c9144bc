// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"
#include "language/language.h"

#include <QString>
#include <QStringList>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace palmer {

/// Exit codes of the program; for several files the worst one: cannotRead, wrongUsage, difference, done.
enum ExitCode : int {
    done = 0,
    difference = 1, ///< a verdict other than "conforms", an unmet requirement, a deviating value
    wrongUsage = 2,
    cannotRead = 3, ///< a file cannot be read, written or understood
};

/// Returns the worse of two codes.
[[nodiscard]] int worse(int a, int b);

/// An option of a command: --name, or --name VALUE if `value` is not empty. Names of one letter have one
/// dash.
struct Option {
    const char *name = nullptr;
    const char *value =
        nullptr; ///< placeholder in the help; empty for a switch; "csv|text": one of these words
    Text description;
    bool repeats = false; ///< may be repeated
    /// The option is refused unless one of these is given: an argument ("circular"), an option ("extract") or
    /// an option with its value ("as=csv|as=siemens"). Empty: no condition.
    const char *goesWith = "";
    bool mayBeEmpty = false; ///< "" is allowed and means none
    /// The file to read that a value names; null: it names none.
    QString (*fileRead)(const QString &value) = nullptr;
};

/// For Option::fileRead: the value is the file.
[[nodiscard]] inline QString itself(const QString &value) {
    return value;
}

/// Returns options and lists of options as one list.
template <class... Parts>
[[nodiscard]] constexpr auto optionList(const Parts &...parts) {
    std::array<Option, (sizeof(Parts) + ...) / sizeof(Option)> result{};
    auto next = result.begin();
    const auto add = [&next](const auto &part) {
        if constexpr (std::is_same_v<decltype(part), const Option &>)
            *next++ = part;
        else
            next = std::copy(part.begin(), part.end(), next);
    };
    (add(parts), ...);
    return result;
}

/// The allowed words for the value of an option; empty if any value is allowed.
[[nodiscard]] QStringList wordsOf(const Option &option);

/// Returns the option with that name, without dashes; null if there is none.
[[nodiscard]] const Option *findOption(std::span<const Option> options, const QString &name);
/// The option as typed: -o, --help.
[[nodiscard]] QString dashed(const Option &option);

/// The arguments and options of a call.
struct Invocation {
    Language language;
    bool languageChosen = false;            ///< by --language; otherwise from the locale
    std::map<QString, QStringList> options; ///< values in order; one empty value for a switch
    QStringList arguments;
    QStringList filesOfOptions; ///< to read

    [[nodiscard]] bool has(const char *option) const;
    /// The first value of an option; null without it.
    [[nodiscard]] std::optional<QString> value(const char *option) const;
    [[nodiscard]] QStringList values(const char *option) const;
};

/// A command of the program; the help is generated from it.
struct Command {
    const char *name = nullptr;
    const char *arguments = nullptr; ///< "FILE…"; empty: none
    Text description;
    std::span<const Option> options;
    int (*run)(const Invocation &) = nullptr;
    bool draws = false; ///< needs a QApplication
    /// Whether a part ("trend" of register) takes an option; null: as Option::goesWith says.
    bool (*partTakes)(const QString &part, const Option &option) = nullptr;
};

/// The parts of a command ("circular|positioning"); empty if its arguments are files.
[[nodiscard]] QStringList partsOf(const Command &command);

/// Returns "; did you mean %1?" for the word closest to `given`, as a sentence; empty if none is close.
[[nodiscard]] QString meant(const QString &given, const QStringList &words, const Language &language);

/// Wrong usage: one line on stderr, exit code 2.
class UsageError : public std::runtime_error {
public:
    explicit UsageError(Message sentence, QString mistyped = {}, QStringList known = {})
        : std::runtime_error(sentence.text.source)
        , message(std::move(sentence))
        , given(std::move(mistyped))
        , words(std::move(known)) {}

    Message message;
    QString given;     ///< a word that is unknown,
    QStringList words; ///< and those that are known: for "did you mean"
};

/// Throws UsageError: the option has no effect without one of its partners.
[[noreturn]] void refuseEffect(const std::string &option, const std::string &partners);

/// All commands.
[[nodiscard]] std::span<const Command> commands();

/// Options of every command.
[[nodiscard]] std::span<const Option> commonOptions();

/// True if one of the words is a command that draws figures or pages.
[[nodiscard]] bool needsDrawing(const QStringList &words);

/// Parses the words after the command name. Throws UsageError.
[[nodiscard]] Invocation parseArguments(const Command &command, const QStringList &words, Language language);

/// The language of --language anywhere among the words; null if missing or unknown.
[[nodiscard]] std::optional<Language> chosenLanguage(const QStringList &words);

} // namespace palmer
