// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/document.h"
#include "document/documenterror.h"
#include "export/resultsjson.h"
#include "import/imported.h"
#include "language/language.h"

#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// Writes to standard output (UTF-8, whatever the locale). Throws Error(unwritable) when it cannot.
void printOut(const QString &text);
void printOut(const QByteArray &bytes);

/// Of commands that print JSON.
inline constexpr Option jsonLinesOption{
    "json-lines", "", REPORT_TEXT("report", "as --json, always one object a line, of one file too")};

/// What --json and --json-lines ask for; null: no JSON.
[[nodiscard]] std::optional<JsonForm> jsonForm(const Invocation &invocation, bool several);

/// The language of names in files for scripts: the same everywhere, unless they ask for another.
[[nodiscard]] Language namesLanguage(const Invocation &invocation);

/// What to say where the memory does not suffice.
[[nodiscard]] Error notEnoughMemory();

/// One line on standard error: `palmer-cli: text`; control characters are shown as spaces.
void printError(const QString &text);

/// `palmer-cli: FILE: place: what is wrong`.
void printError(const QString &file, const Error &error, const Language &language);

/// `palmer-cli: FILE: line:column: remark`, one line each.
void printRemarks(const QString &file, const std::vector<Remark> &remarks, const Language &language);

/// The bytes of a file, "-" is standard input. Throws Error.
[[nodiscard]] QByteArray bytesFrom(const QString &file);

/// The options of commands that read measurement files: the answers to questions about them.
inline constexpr std::array foreignOptions{
    Option{"profile", "NAME", REPORT_TEXT("report", "the choices kept under this name")},
    Option{"set", "key=value",
           REPORT_TEXT("report", "a choice of the import (unit=um, decimalMark=comma, axis=X, "
                                 "columns=target,run+,run-, …), or a field of the test file by its path "
                                 "(machine.name=DMU 50, limits.A.value=0.020: of every test, "
                                 "tests[0].title=…); may stand several times"),
           true},
    Option{"accept", "",
           REPORT_TEXT("report",
                       "take what is assumed where the file does not say it; doubts want an answer each")},
};

/// What --profile and --set choose. Throws UsageError, Error for a file of profiles that cannot be read.
[[nodiscard]] ImportOptions chosenOptions(const Invocation &invocation);

/// The measurement of a file with its remarks printed. Questions that --set does not answer, and --accept
/// does not because nothing is proposed or it is not there, are printed and nothing is returned.
[[nodiscard]] std::optional<Imported> importedFrom(QByteArrayView bytes, const QString &file,
                                                   const ImportOptions &options,
                                                   const Invocation &invocation);

/// The keys of --set that are choices of the import and that this file does not have. What is only the answer
/// to a question that may come is none of them.
[[nodiscard]] std::vector<std::string> choicesWithoutEffect(const Imported &imported,
                                                            const Invocation &invocation);

/// Throws UsageError: that choice has no effect.
[[noreturn]] void refuseChoice(const std::string &key);

/// The document of a file: a test file, that inside a report, or what an instrument's file or a table is
/// imported as, as importedFrom has it; nothing for questions that were printed. Throws Error.
[[nodiscard]] std::optional<Document> documentFrom(const QString &file, const Invocation &invocation);

} // namespace palmer
