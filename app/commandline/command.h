// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"
#include "language/language.h"

#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>

namespace palmer {

/// Exit codes of the program; of several files the worst wins: cannotRead, wrongUsage, difference, done.
enum ExitCode : int {
    done = 0,
    difference = 1, ///< a verdict other than "conforms", an unmet requirement, a value that does not agree
    wrongUsage = 2,
    cannotRead = 3, ///< a file cannot be read, written or understood
};

/// The worse of two codes, by rank and not by number alone.
[[nodiscard]] int worse(int a, int b);

/// An option of a command: --name, or --name VALUE where `value` stands for something. A name of one letter
/// has one dash.
struct Option {
    const char *name = nullptr;
    const char *value =
        nullptr; ///< placeholder in the help; empty for a switch; "csv|text": one of these words
    Text description;
    bool repeats = false; ///< may stand several times
    /// What it has no effect without, and is refused: one of these, each an argument ("circular"), an option
    /// ("extract") or an option with its value ("as=csv|as=siemens"). Empty: always has one.
    const char *goesWith = "";
    bool mayBeEmpty = false; ///< "" says that there shall be none
};

/// The words that the value of an option has to be one of; none where anything may be given.
[[nodiscard]] QStringList wordsOf(const Option &option);

/// The option as it is typed: -o, --help.
[[nodiscard]] QString dashed(const Option &option);

/// What a command was called with.
struct Invocation {
    Language language;
    bool languageChosen = false; ///< by --language; else it is that of the locale
    std::map<QString, QString> options;
    QStringList arguments;

    [[nodiscard]] bool has(QLatin1StringView option) const;
    [[nodiscard]] std::optional<QString> value(QLatin1StringView option) const;
    /// Of an option that may stand several times.
    [[nodiscard]] QStringList values(QLatin1StringView option) const;
};

/// A command of the program; the help is made of these rows.
struct Command {
    const char *name = nullptr;
    const char *arguments = nullptr; ///< "FILE…"; empty: takes none
    Text description;
    std::span<const Option> options;
    int (*run)(const Invocation &) = nullptr;
    bool draws = false; ///< needs a QApplication
};

/// Wrong usage: one line on stderr, exit code 2.
class UsageError : public std::runtime_error {
public:
    explicit UsageError(Message sentence)
        : std::runtime_error(sentence.text.source)
        , message(std::move(sentence)) {}

    Message message;
};

/// The commands there are.
[[nodiscard]] std::span<const Command> commands();

/// The options that every command has.
[[nodiscard]] std::span<const Option> commonOptions();

/// Whether a command among the words draws figures or pages.
[[nodiscard]] bool needsDrawing(const QStringList &words);

/// Takes the words after the command's name apart. Throws UsageError.
[[nodiscard]] Invocation parseArguments(const Command &command, const QStringList &words, Language language);

/// The language asked for by --language anywhere among the words, if it is one.
[[nodiscard]] std::optional<Language> chosenLanguage(const QStringList &words);

} // namespace palmer
