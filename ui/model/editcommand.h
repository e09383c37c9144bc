// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/changedreadings.h"
#include "ui/model/documentmodel.h"

#include <QUndoCommand>
#include <optional>

namespace palmer::ui {

/// The one step of the undo stack: the document before and after. Documents share their tests, so both are
/// cheap; of a few readings in a large test it keeps these alone.
class EditCommand : public QUndoCommand {
public:
    EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand *other) override;

private:
    DocumentModel &m_model;
    std::optional<ChangedReadings> m_readings;
    DocumentPointer m_before; ///< null where the readings say it
    DocumentPointer m_after;  ///< the same, once it was put for the first time
    QString m_mergeKey;
};

} // namespace palmer::ui
