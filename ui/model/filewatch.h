// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/filestate.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>

namespace palmer::ui {

/// Notices when another program changes the file of a document. What counts is the content: a file that was
/// touched, or written anew with the same bytes, has not changed.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject *parent = nullptr);

    /// Takes the file as it is now for known; an empty path watches nothing.
    void watch(const QString &path);
    /// Takes what the file once was for known, which it may be no longer.
    void watch(const QString &path, const FileState &known);

    /// The state that is known.
    [[nodiscard]] const FileState &known() const { return m_known; }

    /// Whether the file is another than the one known, or gone. Looks at the disk.
    [[nodiscard]] bool isChanged();

signals:
    /// Told once for every state of the file that is not known.
    void changed();

private:
    void look();

    QFileSystemWatcher m_watcher;
    QString m_path;
    FileState m_known;
    FileState m_told; ///< the state told last
};

} // namespace palmer::ui
