// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"

#include <QByteArray>
#include <QString>
#include <memory>
#include <utility>
#include <vector>

namespace palmer {

class Spool;

struct FileToSave {
    QByteArray bytes;
    QString path;
    std::shared_ptr<const Spool> spool = {}; ///< holds the bytes; null if they do so themselves
};

/// Error(unwritable) for one of several files.
class UnsavedFile : public Error {
public:
    UnsavedFile(const Error &error, QString file)
        : Error(error)
        , path(std::move(file)) {}

    QString path;
};

/// Handling of a pipe without a reader: an error, or block until there is one, like shell redirection.
enum class UnreadPipe { refused, awaited };

/// Writes files atomically: files without a name for all of them, checked and flushed to disk before the
/// first is named. If one cannot be saved, even because of a full disk at the last byte, existing files are
/// unchanged and no new one is left; then throws UnsavedFile with the cause and a remedy. If a later naming
/// fails, which takes a folder that forbids it for that file only, the earlier files are restored, if the
/// file system exchanges names (FAT does not). Devices and pipes are written directly, before the renaming.
/// Precondition: distinct paths.
void saveFiles(const std::vector<FileToSave> &files, UnreadPipe unread = UnreadPipe::refused);

} // namespace palmer
