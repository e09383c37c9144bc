// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"

#include <QString>
#include <vector>

namespace palmer {

/// A line of help: what is typed, and what it means.
struct HelpRow {
    QString left;
    QString right;
};

/// The rows in two columns, at most `width` wide where no word is wider; what is typed stands alone above
/// where it is long.
[[nodiscard]] QString inColumns(const std::vector<HelpRow> &rows, int width);

/// The rows of the commands, of options, of what all commands have, of the choices that --set takes.
[[nodiscard]] std::vector<HelpRow> commandRows(const Language &language);
[[nodiscard]] std::vector<HelpRow> optionRows(std::span<const Option> options, const Language &language);
[[nodiscard]] std::vector<HelpRow> commonRows(const Command &command, const Language &language);
[[nodiscard]] std::vector<HelpRow> versionRows(const Language &language);
[[nodiscard]] std::vector<HelpRow> keyRows(const Language &language);

/// What FILE may be, and what else the keys of --set may be.
[[nodiscard]] QString filesSentence(const Language &language);
[[nodiscard]] QString fieldsSentence(const Language &language);

/// Help of the whole program, of one command, and of the choices that --set takes (`--help KEYS`).
[[nodiscard]] QString programHelp(const Language &language);
[[nodiscard]] QString commandHelp(const Command &command, const Language &language);
[[nodiscard]] QString keysHelp(const Language &language);

/// Whether the command reads measurement files and takes choices for them.
[[nodiscard]] bool takesKeys(const Command &command);
inline constexpr const char *keysWord = "KEYS";

} // namespace palmer
