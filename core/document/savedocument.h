// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// Largest file to be read, bytes: three times the size of the largest measurements.
constexpr qint64 largestFile = qint64(1) << 28;

/// Writes a file atomically: temporary file next to it, checked, flushed to disk, renamed. If anything fails,
/// even a full disk at the last byte, an existing file is unchanged; then throws Error(unwritable) with the
/// cause and a remedy. Devices and pipes are written directly; a pipe without a reader is an error after two
/// seconds. The only way this program writes files.
void saveBytes(const QByteArray &bytes, const QString &path);

/// Returns the test file of a document. Throws Error(tooLarge) or the errors of requireBounds if it could not
/// be opened again, and the errors of writeDocument.
[[nodiscard]] QByteArray bytesToSave(const Document &document);

/// Saves the test file of a document.
void saveDocument(const Document &document, const QString &path);

/// Returns the bytes of a file, or of a resource of the program. Throws Error(unreadable) for an unreadable
/// file, a folder, a device or a pipe (which might never end), Error(tooLarge) above `limit`; all before the
/// first byte is read.
[[nodiscard]] QByteArray readBytes(const QString &path, qint64 limit = largestFile);

/// Throws the Error(tooLarge) of readBytes if `size` is above the limit.
void requireReadable(qint64 size, qint64 limit = largestFile);

/// Reads the test file at that path. Throws the errors of readBytes and readDocument.
[[nodiscard]] Document openDocument(const QString &path);

} // namespace palmer
