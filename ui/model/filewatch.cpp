// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/filewatch.h"

#include <QFile>
#include <QFileInfo>

namespace palmer::ui {

FileWatch::FileWatch(QObject *parent)
    : QObject(parent) {
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::look);
}

void FileWatch::watch(const QString &path) {
    watch(path, path.isEmpty() ? FileState{} : stateOfFile(path, true));
}

void FileWatch::watch(const QString &path, const FileState &known) {
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty())
        m_watcher.removePaths(watched);
    m_path = path;
    m_known = known;
    m_told = {};
    if (path.isEmpty())
        return;
    m_told = stateOfFile(path, true);
    m_watcher.addPath(path);
    m_watcher.addPath(QFileInfo(path).absolutePath()); // programs that save atomically replace the file
}

bool FileWatch::isChanged() {
    if (m_path.isEmpty())
        return false;
    FileState now = stateOfFile(m_path, false);
    if (now.exists && m_known.exists && now.size == m_known.size && now.modified == m_known.modified)
        return false;
    now = stateOfFile(m_path, true);
    if (!now.isSameContent(m_known))
        return true;
    m_known.modified = now.modified; // only touched
    return false;
}

void FileWatch::look() {
    if (m_path.isEmpty())
        return;
    if (!m_watcher.files().contains(m_path) && QFile::exists(m_path))
        m_watcher.addPath(m_path); // a replaced file is no longer watched
    if (!isChanged())
        return;
    const FileState now = stateOfFile(m_path, true);
    if (now.exists == m_told.exists && now.modified == m_told.modified && now.hash == m_told.hash)
        return;
    m_told = now;
    emit changed();
}

} // namespace palmer::ui
