// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// Largest file that is read, bytes: three times what the largest measurements take.
constexpr qint64 largestFile = qint64(1) << 28;

/// Writes a file in one step: beside, checked, on the disk, renamed. Whatever fails, a full disk and the last
/// byte among it, the file that was there before stays as it was; then throws Error(unwritable), which says
/// why and what to do. Devices and pipes are written directly; a pipe that nobody reads is an error after two
/// seconds. The one way in which this program writes files.
void saveBytes(const QByteArray &bytes, const QString &path);

/// The test file of a document. Throws Error(tooLarge), or what demandBounds throws, for one that could not
/// be opened again, and what writeDocument throws.
[[nodiscard]] QByteArray bytesToSave(const Document &document);

/// Saves the test file of a document.
void saveDocument(const Document &document, const QString &path);

/// The bytes of a file, or of a resource of the program. Throws Error(unreadable) for what cannot be read,
/// is a folder, a device or a pipe (which might never end), Error(tooLarge) above `limit`; all of it before
/// the first byte is read.
[[nodiscard]] QByteArray readBytes(const QString &path, qint64 limit = largestFile);

/// Throws the Error(tooLarge) of readBytes when `size` is above the limit.
void demandReadable(qint64 size, qint64 limit = largestFile);

/// Whether both names lead to one file: by device and inode, through links of any kind. Only regular files
/// that are there count.
[[nodiscard]] bool isSameFile(const QString &path, const QString &other);

/// Reads the test file at that path. Throws what readBytes and readDocument throw.
[[nodiscard]] Document openDocument(const QString &path);

} // namespace palmer
