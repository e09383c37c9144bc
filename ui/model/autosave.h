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

/// Keeps a copy of a document with unsaved changes, also of one that never had a file: written at most a few
/// seconds after the first change, on a thread of its own, and gone when the document is saved, undone to
/// what the file says, or closed. After a crash the copy is found by abandonedRecoveries.
class Autosave : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Autosave)

public:
    /// Folder of all copies of this user; made when needed.
    [[nodiscard]] static QString folder();

    explicit Autosave(DocumentModel &model, QObject *parent = nullptr);
    ~Autosave() override; ///< leaves no copy: who destroys a window knows what it holds

    /// Time from a change to its copy, ms.
    void setDelay(int milliseconds) { m_timer.setInterval(milliseconds); }

    /// What the file was when it was read or saved last: it stands in the copies, so that another one found
    /// in its place after a crash is not overwritten in silence.
    void setFileState(const FileState &state) { m_fileState = state; }

    /// Writes a copy now, of a document without changes too; true: it is on the disk.
    bool flush();

    /// The document was saved or given up: the copy goes.
    void discard();

signals:
    /// A copy of this document is on the disk.
    void saved(const palmer::ui::DocumentPointer &document);
    /// The copy could not be written; told once, until it works again.
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
    std::atomic<bool> m_kept = false; ///< the latest copy is on the disk
    bool m_failing = false;
};

} // namespace palmer::ui
