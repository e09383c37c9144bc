#pragma once

#include "document/document.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

class QUndoStack;

namespace palmer::ui {

using DocumentPointer = std::shared_ptr<const Document>;

/// What a step of the undo stack is called: the English source of a text of the context "edits", written
/// after "Undo:"; with a count where it says "%n".
struct EditName {
    EditName(const char *source, int number = -1) // NOLINT: a literal is a name
        : text(source)
        , count(number) {}

    const char *text;
    int count;
};

/// The name in the window's language, of a step as the undo stack keeps it.
[[nodiscard]] QString editWords(const QString &undoText);

/// The document of one window, the file it belongs to and its undo stack. `edit` is the one door: nothing
/// else changes a document that is shown.
class DocumentModel : public QObject {
    Q_OBJECT

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

    /// Lets `change` alter a copy of the document and makes it the current one, as one step to undo. A
    /// change that changes nothing is dropped; steps in succession with the same `mergeKey` (not empty)
    /// become one.
    void edit(const EditName &name, const std::function<void(Document &)> &change,
              const QString &mergeKey = {});

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

    DocumentPointer m_document;
    QString m_path;
    QUndoStack *m_stack;
};

} // namespace palmer::ui
