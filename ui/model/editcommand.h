// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/keptdocument.h"
#include "ui/model/documentmodel.h"

#include <QUndoCommand>

namespace palmer::ui {

/// The only command of the undo stack: keeps the document at the other end of the step.
class EditCommand : public QUndoCommand {
public:
    EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey);
    /// A step already done, for refilling a stack.
    EditCommand(DocumentModel &model, const QString &text, KeptDocument before);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand *other) override;

    [[nodiscard]] const KeptDocument &kept() const { return m_kept; }

private:
    DocumentModel &m_model;
    KeptDocument m_kept;   ///< the document before a step that is done, or after one that was undone
    DocumentPointer m_new; ///< the document after the step, until it is first done
    bool m_done = false;
    QString m_mergeKey;
};

} // namespace palmer::ui
