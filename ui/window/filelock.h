// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>
#include <memory>
#include <optional>

namespace palmer::ui {

/// True if the program cannot write to the file or its folder, or nobody may write to the file. False if
/// there is no file.
[[nodiscard]] bool mayNotBeWritten(const QString &path);

/// Marks a file as open to other programs and machines for the lifetime of this object, with a file
/// `.~lock.NAME#` in the same folder that names process, program and host.
class FileLock {
public:
    /// Owner of the lock.
    struct Holder {
        qint64 process = 0;
        QString host;
        QString program;
    };

    /// Releases the former file and marks this one. Returns the owner if it is locked already; null if it was
    /// locked now, and also for an empty path, a missing file or a folder without write permission. A stale
    /// lock of this machine is taken over.
    [[nodiscard]] std::optional<Holder> claim(const QString &path);
    void release();

private:
    std::unique_ptr<QLockFile> m_lock; ///< null if there is no lock or another process owns it
};

} // namespace palmer::ui
