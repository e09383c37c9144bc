// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/walk.h"

#include "register/machinechoices.h"
#include "system/filename.h"
#include "system/files.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <set>

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
        if (!isUtf8FileName(place))
            refuseName(place);
        else if (info.isDir())
            m_open.push_back(place);
        else if (info.isFile())
            addFile(info);
        else
            refuse(place, REPORT_TEXT("report", "there is no such file or folder"));
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

    /// The text of a database holds no other names.
    void refuseName(const QString &path) {
        refuse(shownFileName(path),
               REPORT_TEXT("report", "a register holds only names in UTF-8, and this one "
                                     "is not; rename it"));
    }

    void addFile(const QFileInfo &info) {
        m_listing.files.push_back(
            {cleanPath(info.filePath()), info.size(), info.lastModified().toMSecsSinceEpoch()});
    }

    void list(const QString &folder) {
        const QFileInfo info(folder);
        if (!m_seen.insert(info.canonicalFilePath()).second) // reached through another link
            return;
        if (!mayBeListed(folder)) {
            refuse(folder, REPORT_TEXT("report", "the folder cannot be read"));
            return;
        }
        std::vector<QString> below;
        std::error_code error; // QDir passes over names that are not UTF-8
        std::filesystem::directory_iterator entries(pathOf(folder), error);
        for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
            const QString name = fileNameOf(entries->path().filename());
            const QFileInfo entry(folder + u'/' + name);
            std::error_code ignored;
            const bool isFolder = entries->is_directory(ignored);
            if (name.startsWith(u'.') || !(isFolder || isListed(name) || name == machineFileName))
                continue;
            if (!isUtf8FileName(name))
                refuseName(entry.filePath());
            else if (isFolder)
                below.push_back(entry.filePath());
            else if (isListed(name) && entry.exists())
                addFile(entry);
            else if (name == machineFileName)
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
