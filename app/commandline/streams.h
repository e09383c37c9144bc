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

/// Writes to standard output, in UTF-8 under any locale. Throws Error(unwritable).
void printOut(const QString &text);
void printOut(const QByteArray &bytes);

/// For commands that print JSON.
inline constexpr Option jsonLinesOption{
    "json-lines", "", REPORT_TEXT("report", "as --json, always one object a line, of one file too")};

/// The form chosen by --json or --json-lines; null: no JSON.
[[nodiscard]] std::optional<JsonForm> jsonForm(const Invocation &invocation, bool several);

/// Language of names in files for scripts: fixed unless --language is given.
[[nodiscard]] Language namesLanguage(const Invocation &invocation);

/// Error for insufficient memory.
[[nodiscard]] Error notEnoughMemory();

/// Prints one line on standard error: `palmer-cli: text`, with spaces for control characters.
void printError(const QString &text);

/// Reports a failed file: `palmer-cli: FILE: text` on standard error and, with --json-lines, an object on
/// standard output. Returns the code.
int fail(const Invocation &invocation, const QString &file, const QString &text, ExitCode code);
int fail(const Invocation &invocation, const QString &file, const Error &error); ///< cannotRead

/// Prints `palmer-cli: FILE: place: what is wrong`.
void printError(const QString &file, const Error &error, const Language &language);

/// Returns the exit code of `work()`; if it throws an Error, prints it with the name of the file: cannotRead.
template <class Work>
[[nodiscard]] int codeOf(const QString &file, const Language &language, const Work &work) {
    try {
        return work();
    } catch (const Error &error) {
        printError(file, error, language);
        return cannotRead;
    }
}
/// Prints `palmer-cli: FILE: line:column: remark`, one line each.
void printRemarks(const QString &file, const std::vector<Remark> &remarks, const Language &language);

/// The bytes of a file; "-" is standard input. Throws Error.
[[nodiscard]] QByteArray bytesFrom(const QString &file);

/// For Option::fileRead: the file of all profiles.
[[nodiscard]] QString profilesFile(const QString &name);

/// Options of commands that read measurement files: answers to questions about these.
inline constexpr std::array foreignOptions{
    Option{"profile", "NAME", REPORT_TEXT("report", "the choices kept under this name"), false, "", false,
           profilesFile},
    Option{"set", "key=value",
           REPORT_TEXT("report", "a choice of the import (unit=um, decimalMark=comma, axis=X, "
                                 "columns=target,run+,run-, …), or a field of the test file by its path "
                                 "(machine.name=DMU 50, limits.A.value=20um: of every test, "
                                 "tests[0].title=…), numbers with any unit that fits (500 mm, "
                                 "2 m/min, 22.5 °C); may stand several times"),
           true},
    Option{"accept", "",
           REPORT_TEXT("report",
                       "take what is assumed where the file does not say it; doubts want an answer each")},
};

/// Choices by --profile and --set. Throws UsageError, or Error if the profiles cannot be read.
[[nodiscard]] ImportOptions chosenOptions(const Invocation &invocation);

/// The measurement of a file; its remarks and questions are printed. Throws Error if it cannot be read.
[[nodiscard]] Imported importedFrom(QByteArrayView bytes, const QString &file, const ImportOptions &options,
                                    const Invocation &invocation);

/// Throws Error if questions remain that neither --set nor --accept answers (--accept only takes proposals).
void requireAnswers(const Imported &imported, const Invocation &invocation);

/// The keys of --set that are choices of the import but do not apply to this file. Keys that only answer a
/// question that may not arise are not included.
[[nodiscard]] std::vector<std::string> choicesWithoutEffect(const Imported &imported,
                                                            const Invocation &invocation);

/// Throws UsageError: the choice has no effect.
[[noreturn]] void refuseChoice(const std::string &key);

/// The document of a file: a test file, the one inside a report, or the import of an instrument file or
/// table whose questions are answered. Throws Error.
enum class Say { remarks, nothing };
[[nodiscard]] Document documentFrom(const QString &file, const Invocation &invocation,
                                    Say say = Say::remarks);

} // namespace palmer
