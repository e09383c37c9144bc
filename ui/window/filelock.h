// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>
#include <memory>
#include <optional>

namespace palmer::ui {

/// Neither the program nor anybody may write to the file, or to its folder. False where there is no file.
[[nodiscard]] bool mayNotBeWritten(const QString &path);

/// Marks a file as open for other programs and other machines, as long as this lives: a file beside it,
/// `.~lock.NAME#`, that says process, program and host.
class FileLock {
public:
    /// Who has the file open already.
    struct Holder {
        qint64 process = 0;
        QString host;
        QString program;
    };

    /// Marks that file and no other. Null, too, for an empty path, where there is no file and in a folder
    /// that nobody may write to; a mark that a program of this machine has left behind is taken over.
    [[nodiscard]] std::optional<Holder> take(const QString &path);
    void release();

private:
    std::unique_ptr<QLockFile> m_lock; ///< null where there is none, or another has it
};

} // namespace palmer::ui
