// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/filestate.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>

namespace palmer::ui {

/// Notices when another program changes a document's file. Only the content counts: a file that was touched
/// or rewritten with the same bytes is unchanged.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject *parent = nullptr);

    /// Takes the current state of the file as known; an empty path stops watching.
    void watch(const QString &path);
    /// Takes `known`, which may be an earlier state of the file, as known.
    void watch(const QString &path, const FileState &known);

    [[nodiscard]] const FileState &known() const { return m_known; }

    /// True if the file differs from the known state or is gone. Reads the disk.
    [[nodiscard]] bool isChanged();

signals:
    /// Emitted once for every unknown state of the file.
    void changed();

private:
    void look();

    QFileSystemWatcher m_watcher;
    QString m_path;
    FileState m_known;
    FileState m_told; ///< the state last reported
};

} // namespace palmer::ui
