#pragma once

#include "document/document.h"
#include "document/documenterror.h"
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

/// The document of a file, "-" is standard input. Throws Error.
[[nodiscard]] Document documentFrom(const QString &file);

} // namespace palmer
