#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// Writes a file in one step: beside, flushed, renamed. Whatever fails, the file that was there before stays
/// as it was; then throws Error(unwritable), which says why and what to do. Devices and pipes are written
/// directly.
void saveBytes(const QByteArray &bytes, const QString &path);

/// The test file of a document, written so.
void saveDocument(const Document &document, const QString &path);

/// The bytes of a file. Throws Error(unreadable) for what cannot be read, Error(tooLarge) above 1 GiB, at
/// once where the file tells its size.
[[nodiscard]] QByteArray readBytes(const QString &path);

/// Reads the test file at that path. Throws Error(unreadable) for what cannot be read, Error(tooLarge) above
/// 1 GiB, and what readDocument throws.
[[nodiscard]] Document openDocument(const QString &path);

} // namespace palmer
