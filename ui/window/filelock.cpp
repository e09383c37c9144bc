// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/filelock.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <utility>

namespace palmer::ui {

bool mayNotBeWritten(const QString &path) {
    const QFileInfo file(path);
    constexpr auto anybody = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
    return !path.isEmpty() && file.exists() &&
           (!file.isWritable() || !(file.permissions() & anybody) ||
            !QFileInfo(file.absolutePath()).isWritable());
}

std::optional<FileLock::Holder> FileLock::claim(const QString &path) {
    const QFileInfo file(path);
    const QString name =
        path.isEmpty() ? QString() : file.dir().filePath(QStringLiteral(".~lock.%1#").arg(file.fileName()));
    if (m_lock && m_lock->fileName() == name)
        return std::nullopt;
    m_lock.reset();
    if (name.isEmpty() || !file.exists())
        return std::nullopt;
    auto lock = std::make_unique<QLockFile>(name);
    lock->setStaleLockTime(0); // takes over only locks whose process has ended
    if (lock->tryLock(0)) {
        m_lock = std::move(lock);
        return std::nullopt;
    }
    Holder holder;
    if (lock->error() != QLockFile::LockFailedError ||
        !lock->getLockInfo(&holder.process, &holder.host, &holder.program))
        return std::nullopt; // no write permission in the folder
    return holder;
}

void FileLock::release() {
    m_lock.reset();
}

} // namespace palmer::ui
