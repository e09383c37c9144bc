#include "ui/model/filewatch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace palmer::ui {

namespace {

constexpr qint64 mostHashed = 4 * 1024 * 1024; ///< bytes; of larger files size and time have to do

} // namespace

FileWatch::FileWatch(QObject *parent)
    : QObject(parent) {
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::look);
}

FileWatch::State FileWatch::stateOf(bool withHash) const {
    const QFileInfo info(m_path);
    State state{info.exists(), info.size(), info.lastModified(), {}};
    if (!withHash || !state.exists || state.size > mostHashed)
        return state;
    QFile file(m_path);
    QCryptographicHash hash(QCryptographicHash::Sha1);
    if (file.open(QIODevice::ReadOnly) && hash.addData(&file))
        state.hash = hash.result();
    return state;
}

void FileWatch::watch(const QString &path) {
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    if (!watched.isEmpty())
        m_watcher.removePaths(watched);
    m_path = path;
    m_known = {};
    m_told = {};
    if (path.isEmpty())
        return;
    m_known = stateOf(true);
    m_told = m_known;
    m_watcher.addPath(path);
    m_watcher.addPath(QFileInfo(path).absolutePath()); // programs that save atomically replace the file
}

bool FileWatch::isChanged() {
    if (m_path.isEmpty())
        return false;
    State now = stateOf(false);
    if (now.exists && m_known.exists && now.size == m_known.size && now.modified == m_known.modified)
        return false;
    now = stateOf(true);
    if (now.exists == m_known.exists && now.size == m_known.size && !now.hash.isEmpty() &&
        now.hash == m_known.hash) {
        m_known.modified = now.modified; // touched, no more
        return false;
    }
    return true;
}

void FileWatch::look() {
    if (m_path.isEmpty())
        return;
    if (!m_watcher.files().contains(m_path) && QFile::exists(m_path))
        m_watcher.addPath(m_path); // replaced files are dropped
    if (!isChanged())
        return;
    const State now = stateOf(true);
    if (now.exists == m_told.exists && now.modified == m_told.modified && now.hash == m_told.hash)
        return;
    m_told = now;
    emit changed();
}

} // namespace palmer::ui
