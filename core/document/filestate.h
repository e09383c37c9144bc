// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

namespace palmer {

/// What tells one state of a file from another. The content counts: a file that was touched is the same.
struct FileState {
    bool exists = false;
    qint64 size = 0;
    QDateTime modified;
    QByteArray hash; ///< of the content; empty: not taken, then size and time have to do

    /// Whether a file is as `before` says.
    [[nodiscard]] bool isSameContent(const FileState &before) const;
};

/// The state of the file of that name. The hash is taken of regular files up to 4 MiB.
[[nodiscard]] FileState stateOfFile(const QString &path, bool withHash);

} // namespace palmer
