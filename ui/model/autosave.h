// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "document/filestate.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"

#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>

namespace palmer::ui {

/// Keeps a recovery copy of a document with unsaved changes, even if it was never saved: written on a
/// background thread at most a few seconds after the first change and removed when the document is saved,
/// undone to the saved state or closed. After a crash abandonedRecoveries finds the copy.
class Autosave : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Autosave)

public:
    /// Folder of this user's recovery copies.
    [[nodiscard]] static QString folder();

    explicit Autosave(DocumentModel &model, QObject *parent = nullptr);
    ~Autosave() override; ///< removes the copy: the owner of a window decides about its changes

    /// Delay from a change to its copy, ms.
    void setDelay(int milliseconds) { m_timer.setInterval(milliseconds); }

    /// State of the file when last read or saved. It is stored in the copies, so that a file changed since is
    /// not silently overwritten after a crash.
    void setFileState(const FileState &state) { m_fileState = state; }

    /// Writes a copy now, even without changes. True if it is on disk.
    bool flush();

    /// Removes the copy: the document was saved or discarded.
    void discard();

signals:
    /// A copy of this document is on disk.
    void saved(const palmer::ui::DocumentPointer &document);
    /// The copy could not be written; emitted once until writing succeeds again.
    void failed(const palmer::Error &error);

private:
    void follow();
    void write();
    void finish(const DocumentPointer &document, const std::optional<Error> &error);

    DocumentModel &m_model;
    QTimer m_timer;
    Background m_writer;
    QString m_file;
    FileState m_fileState;
    std::unique_ptr<QLockFile> m_lock;
    std::atomic<bool> m_kept = false; ///< the latest copy is on disk
    bool m_failing = false;
};

} // namespace palmer::ui
