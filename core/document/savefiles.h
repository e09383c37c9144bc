// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"

#include <QByteArray>
#include <QString>
#include <utility>
#include <vector>

namespace palmer {

struct FileToSave {
    QByteArray bytes;
    QString path;
};

/// Error(unwritable) of one of several files.
class UnsavedFile : public Error {
public:
    UnsavedFile(const Error &error, QString file)
        : Error(error)
        , path(std::move(file)) {}

    QString path;
};

/// What happens to a pipe that has no reader yet: an error, or the call blocks until it has one, as a shell's
/// redirection does.
enum class UnreadPipe { refused, awaited };

/// Writes files in one step: all of them beside, checked and on the disk before the first is renamed. Where
/// one cannot be saved, a full disk and the last byte among it, those that were there before stay as they
/// were, and no new one is left; then throws UnsavedFile, which says why and what to do. Should a later
/// renaming fail, which takes a folder that forbids it for that file alone, hard links bring the earlier
/// files back, where the disk knows them (FAT does not). Devices and pipes are written directly, before the
/// renaming. No path twice.
void saveFiles(const std::vector<FileToSave> &files, UnreadPipe unread = UnreadPipe::refused);

} // namespace palmer
