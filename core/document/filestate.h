// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

namespace palmer {

/// Identifies a state of a file. The content decides: a touched file is the same.
struct FileState {
    bool exists = false;
    qint64 size = 0;
    QDateTime modified;
    QByteArray hash; ///< of the content; empty: not computed, size and time are used

    /// True if a file has the content described by `before`.
    [[nodiscard]] bool isSameContent(const FileState &before) const;
};

/// Returns the state of a file. The hash is computed for regular files up to 4 MiB.
[[nodiscard]] FileState stateOfFile(const QString &path, bool withHash);

} // namespace palmer
