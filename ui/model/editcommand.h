// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/documentmodel.h"

#include <QUndoCommand>

namespace palmer::ui {

/// The one step of the undo stack: the document before and after. Documents share their tests, so both are
/// cheap.
class EditCommand : public QUndoCommand {
public:
    EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand *other) override;

private:
    DocumentModel &m_model;
    DocumentPointer m_before;
    DocumentPointer m_after;
    QString m_mergeKey;
};

} // namespace palmer::ui
