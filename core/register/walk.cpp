// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/walk.h"

#include "register/machinechoices.h"

#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <fcntl.h>
#include <set>
#include <unistd.h>

namespace palmer {

namespace {

bool isListed(const QString &name) {
    return name.endsWith(QLatin1StringView(".palmer"), Qt::CaseInsensitive) ||
           name.endsWith(QLatin1StringView(".pdf"), Qt::CaseInsensitive);
}

class Walk {
public:
    explicit Walk(const std::stop_token &stop)
        : m_stop(stop) {}

    void add(const QString &place) {
        const QFileInfo info(place);
        if (info.isDir())
            m_open.push_back(place);
        else if (info.isFile())
            addFile(info);
        else
            refuse(place, REPORT_TEXT("report", "there is no such folder"));
        while (!m_open.empty() && !m_stop.stop_requested()) {
            const QString folder = m_open.back();
            m_open.pop_back();
            list(folder);
        }
    }

    [[nodiscard]] Listing take() {
        std::ranges::sort(m_listing.files, {}, &ListedFile::path);
        const auto isSame = [](const ListedFile &a, const ListedFile &b) { return a.path == b.path; };
        m_listing.files.erase(std::unique(m_listing.files.begin(), m_listing.files.end(), isSame),
                              m_listing.files.end());
        std::ranges::sort(m_listing.unreadable, {}, &UnreadableFolder::path);
        return std::move(m_listing);
    }

private:
    void refuse(const QString &path, Text text) {
        m_listing.unreadable.push_back({path, Error(Error::Kind::unreadable, {text, {}})});
    }

    void addFile(const QFileInfo &info) {
        m_listing.files.push_back(
            {cleanPath(info.filePath()), info.size(), info.lastModified().toMSecsSinceEpoch()});
    }

    void list(const QString &folder) {
        const QFileInfo info(folder);
        if (!m_seen.insert(info.canonicalFilePath()).second) // reached through another link
            return;
        constexpr int toList = R_OK | X_OK;
        if (::faccessat(AT_FDCWD, QFile::encodeName(folder).constData(), toList, AT_EACCESS) != 0) {
            refuse(folder, REPORT_TEXT("report", "the folder cannot be read"));
            return;
        }
        std::vector<QString> below;
        QDirIterator entries(folder, QDir::Dirs | QDir::Files | QDir::NoDotAndDotDot);
        while (entries.hasNext()) {
            entries.next();
            const QFileInfo entry = entries.fileInfo();
            if (entry.isDir())
                below.push_back(entry.filePath());
            else if (isListed(entry.fileName()))
                addFile(entry);
            else if (entry.fileName() == machineFileName)
                m_listing.machineFolders << cleanPath(folder);
        }
        std::ranges::sort(below, std::ranges::greater()); // the last is visited first
        m_open.insert(m_open.end(), below.begin(), below.end());
    }

    const std::stop_token &m_stop;
    std::vector<QString> m_open;
    std::set<QString> m_seen;
    Listing m_listing;
};

} // namespace

QString cleanPath(const QString &path) {
    return QDir::cleanPath(QFileInfo(path).absoluteFilePath());
}

bool isBelow(const QString &path, const QStringList &places) {
    return std::ranges::any_of(places, [&](const QString &place) {
        return path == place || path.startsWith(place.endsWith(u'/') ? place : place + u'/');
    });
}

Listing listFiles(const QStringList &places, const std::stop_token &stop) {
    Walk walk(stop);
    for (const QString &place : places)
        walk.add(cleanPath(place));
    return walk.take();
}

} // namespace palmer
