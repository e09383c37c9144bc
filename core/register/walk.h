// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"

#include <QString>
#include <QStringList>
#include <stop_token>
#include <vector>

namespace palmer {

/// A file as listed in a folder.
struct ListedFile {
    QString path; ///< absolute, without "." and ".."
    qint64 size = 0;
    qint64 modified = 0; ///< ms since 1970
};

/// A folder that cannot be listed, or a file or folder whose name the register cannot hold.
struct UnreadableFolder {
    QString path;
    Error error;
};

struct Listing {
    std::vector<ListedFile> files; ///< by path
    std::vector<UnreadableFolder> unreadable;
    QStringList machineFolders; ///< those that hold a list of machines
};

/// Returns the test files and PDFs in and below these folders, also through symbolic links, each folder once
/// however many links lead to it; a file in `places` is listed itself. Hidden ones are omitted.
[[nodiscard]] Listing listFiles(const QStringList &places, const std::stop_token &stop = {});

/// True if a path is one of these places or below one.
[[nodiscard]] bool isBelow(const QString &path, const QStringList &places);

/// Returns the path absolute, without "." and "..", and without a trailing slash.
[[nodiscard]] QString cleanPath(const QString &path);

} // namespace palmer
