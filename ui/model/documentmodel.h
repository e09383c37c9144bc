// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

class QTimer;
class QUndoStack;

namespace palmer::ui {

using DocumentPointer = std::shared_ptr<const Document>;

/// The document of a window, its file and its undo stack. A document that is shown changes only with `edit`.
class DocumentModel : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(DocumentModel)

public:
    explicit DocumentModel(QObject *parent = nullptr);
    ~DocumentModel() override;

    /// Never null; an empty document until one is opened.
    [[nodiscard]] const DocumentPointer &document() const { return m_document; }
    /// Absolute path of the file; empty if the document has none yet.
    [[nodiscard]] QString path() const { return m_path; }
    [[nodiscard]] bool isModified() const;
    [[nodiscard]] QUndoStack *undoStack() { return m_stack; }

    /// Replaces the document by one opened from `path` (empty: not from a user file) and clears the undo
    /// stack. `modified`: it differs from the file, or there is no file.
    void setDocument(Document document, const QString &path, bool modified = false);

    /// Applies `change` to a copy of the document and makes it current, as one undo step. `text` names the
    /// step for editName. Drops changes without effect; merges successive steps with the same non-empty
    /// `mergeKey`.
    void edit(const char *text, const std::function<void(Document &)> &change, const QString &mergeKey = {});

    /// Writes the file and adopts its path. Throws Error and changes nothing on failure.
    void save(const QString &path);

signals:
    /// The document was edited, undone, redone or replaced.
    void changed();
    /// The path or the modified flag changed.
    void fileChanged();

private:
    friend class EditCommand;
    void put(DocumentPointer document);
    void boundSteps();

    DocumentPointer m_document;
    QString m_path;
    QUndoStack *m_stack;
    QTimer *m_rest; ///< fires when no change has been made for a while
};

} // namespace palmer::ui
