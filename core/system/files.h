// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <memory>

namespace palmer {

/// True if both names refer to one file, through links of any kind. Only existing regular files count.
[[nodiscard]] bool isSameFile(const QString &path, const QString &other);

/// True if the folder's entries, and what they are, can be read.
[[nodiscard]] bool mayBeListed(const QString &folder);

/// The absolute path with links resolved.
[[nodiscard]] QString linkTarget(const QString &path);

/// True if all data of an open file are on the disk, or its file system cannot tell. `file`: its descriptor.
[[nodiscard]] bool isOnDisk(int file);

/// Makes new names in the folder of `path` durable. Without it a power cut would restore the old file, but
/// never lose both.
void syncFolderOf(const QString &path);

/// The name that a saved file may have for a moment, before it takes the place of another; there after the
/// program was killed in that moment. The next file saved to the same path takes it away.
[[nodiscard]] QString nameWhileSaving(const QString &path);

/// A file that takes its name when it is complete and on the disk; until then no other program sees it, or
/// only with the name that it has while saving, where the file system knows no files without name. Not
/// QSaveFile, whose names stay for ever if the program is killed.
class StagedFile {
public:
    StagedFile() = default;
    virtual ~StagedFile() = default;
    StagedFile(const StagedFile &) = delete;
    StagedFile &operator=(const StagedFile &) = delete;

    /// False if it could not be written, or the existing file must not be replaced; it cannot take its name
    /// then.
    [[nodiscard]] virtual bool isComplete() const = 0;

    /// False if the name could not be taken; what was there is unchanged. `keepOld`: keeps the existing file
    /// until the object is destroyed, if the file system can.
    [[nodiscard]] virtual bool takeName(bool keepOld) = 0;

    /// After takeName: puts back what was there, as far as it was kept.
    virtual void restore() = 0;
};

/// Writes the bytes. `path`: the destination, in an existing folder; links are followed.
[[nodiscard]] std::unique_ptr<StagedFile> stageFile(const QByteArray &bytes, const QString &path);

/// Why a device or pipe could not be written.
enum class DeviceFault { none, full, unread, refused };

/// Writes directly to a device or a pipe. `awaitsReader`: blocks until the pipe has one.
[[nodiscard]] DeviceFault writeDevice(const QByteArray &bytes, const QString &path, bool awaitsReader);

} // namespace palmer
