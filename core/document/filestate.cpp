// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/filestate.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace palmer {

namespace {

constexpr qint64 mostHashed = qint64{4} * 1024 * 1024; ///< bytes

} // namespace

bool FileState::isSameContent(const FileState &before) const {
    if (exists != before.exists || size != before.size)
        return false;
    if (!hash.isEmpty() && !before.hash.isEmpty())
        return hash == before.hash;
    return modified == before.modified;
}

FileState stateOfFile(const QString &path, bool withHash) {
    const QFileInfo info(path);
    FileState state{info.exists(), info.size(), info.lastModified(), {}};
    if (!withHash || !info.isFile() || state.size > mostHashed)
        return state;
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha1);
    if (file.open(QIODevice::ReadOnly) && hash.addData(&file))
        state.hash = hash.result();
    return state;
}

} // namespace palmer
