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

/// The document of one window, the file it belongs to and its undo stack. `edit` is the one door: nothing
/// else changes a document that is shown.
class DocumentModel : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(DocumentModel)

public:
    explicit DocumentModel(QObject *parent = nullptr);
    ~DocumentModel() override;

    /// Never null; empty before anything was opened.
    [[nodiscard]] const DocumentPointer &document() const { return m_document; }
    /// Absolute path of the file; empty when the document has none yet.
    [[nodiscard]] QString path() const { return m_path; }
    [[nodiscard]] bool isModified() const;
    [[nodiscard]] QUndoStack *undoStack() { return m_stack; }

    /// Puts another document in place, as opened from `path` (empty: from no file of the user's). Nothing of
    /// the former can be undone. `modified`: the file, if there is one, does not say the same.
    void setDocument(Document document, const QString &path, bool modified = false);

    /// Lets `change` alter a copy of the document and makes it the current one, as one step to undo. `text`
    /// names the step, as editName reads it. A change that changes nothing is dropped; steps in succession
    /// with the same `mergeKey` (not empty) become one.
    void edit(const char *text, const std::function<void(Document &)> &change, const QString &mergeKey = {});

    /// Writes the file and takes its path. Throws Error and changes nothing when that fails.
    void save(const QString &path);

signals:
    /// The document is another one: edited, undone, redone or replaced.
    void changed();
    /// Path or modified mark are others.
    void fileChanged();

private:
    friend class EditCommand;
    void put(DocumentPointer document);
    void boundSteps();

    DocumentPointer m_document;
    QString m_path;
    QUndoStack *m_stack;
    QTimer *m_rest; ///< since the last change
};

} // namespace palmer::ui
