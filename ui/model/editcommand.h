// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/keptdocument.h"
#include "ui/model/documentmodel.h"

#include <QUndoCommand>

namespace palmer::ui {

/// The one step of the undo stack: the document at its other end, kept beside the current one.
class EditCommand : public QUndoCommand {
public:
    EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey);
    /// A step that is done already, for a stack that is made anew.
    EditCommand(DocumentModel &model, const QString &text, KeptDocument before);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand *other) override;

    [[nodiscard]] const KeptDocument &kept() const { return m_kept; }

private:
    DocumentModel &m_model;
    KeptDocument m_kept;   ///< the document before a step that is done, after one that was undone
    DocumentPointer m_new; ///< the document after it until it is done for the first time
    bool m_done = false;
    QString m_mergeKey;
};

} // namespace palmer::ui
