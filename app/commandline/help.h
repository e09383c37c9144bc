// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"

#include <QString>
#include <vector>

namespace palmer {

/// A line of help: what is typed, and its meaning.
struct HelpRow {
    QString left;
    QString right;
};

/// The rows in two columns, at most `width` wide unless a word is wider; long left sides get their own line.
[[nodiscard]] QString inColumns(const std::vector<HelpRow> &rows, int width);

/// Returns the options of a command that a part of it takes ("trend"); all if `part` is empty.
[[nodiscard]] std::vector<Option> optionsOf(const Command &command, const QString &part);

/// Rows of the commands, of options, of common options, and of the choices for --set.
[[nodiscard]] std::vector<HelpRow> commandRows(const Language &language);
[[nodiscard]] std::vector<HelpRow> optionRows(std::span<const Option> options, const Language &language);
[[nodiscard]] std::vector<HelpRow> commonRows(const Command &command, const Language &language);
[[nodiscard]] std::vector<HelpRow> versionRows(const Language &language);
[[nodiscard]] std::vector<HelpRow> keyRows(const Language &language);

/// Calls of a command, or of a part of it, that work; the exit codes of a command, without one of all.
[[nodiscard]] QStringList examplesOf(const Command &command, const QString &part = {});
[[nodiscard]] std::vector<HelpRow> exitRows(const Language &language, const Command *command = nullptr);

/// Describes the possible FILEs, and further keys of --set.
[[nodiscard]] QString filesSentence(const Language &language);
[[nodiscard]] QString fieldsSentence(const Language &language);

/// Help of the program, of one command, and of the choices for --set (`--help KEYS`).
[[nodiscard]] QString programHelp(const Language &language);
[[nodiscard]] QString commandHelp(const Command &command, const Language &language, const QString &part = {});
[[nodiscard]] QString keysHelp(const Language &language);

/// True if the command reads measurement files and accepts choices for them.
[[nodiscard]] bool takesKeys(const Command &command);
inline constexpr const char *keysWord = "KEYS";

/// The manual page of palmer-cli, section 1, generated from the same tables as --help.
[[nodiscard]] QString manualPage(const Language &language);

/// Completions of the last word of a command line: one per line, followed by a tab and its meaning. Empty if
/// any text or a file name may follow. For the shells (resources/linux/completions).
[[nodiscard]] QString completion(const QStringList &words, const Language &language);

} // namespace palmer
