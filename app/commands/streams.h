#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "import/remark.h"
#include "language/language.h"

#include <QString>

namespace palmer {

/// Writes to standard output (UTF-8, whatever the locale). Throws Error(unwritable) when it cannot.
void printOut(const QString &text);
void printOut(const QByteArray &bytes);

/// One line on standard error: `palmer-cli: text`; control characters are shown as spaces.
void printError(const QString &text);

/// `palmer-cli: FILE: place: what is wrong`.
void printError(const QString &file, const Error &error, const Language &language);

/// `palmer-cli: FILE: line:column: remark`, one line each.
void printRemarks(const QString &file, const std::vector<Remark> &remarks, const Language &language);

/// The bytes of a file, "-" is standard input. Throws Error.
[[nodiscard]] QByteArray bytesFrom(const QString &file);

/// The document of a file: a test file, or what an instrument's file or a table is imported as, whose remarks
/// are printed. Throws Error.
[[nodiscard]] Document documentFrom(const QString &file, const Language &language);

} // namespace palmer
