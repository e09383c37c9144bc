// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/editcommand.h"

namespace palmer::ui {

namespace {

constexpr int mergeable = 1;

} // namespace

EditCommand::EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey)
    : QUndoCommand(QString::fromUtf8(text))
    , m_model(model)
    , m_before(model.document())
    , m_after(std::move(after))
    , m_mergeKey(std::move(mergeKey)) {}

void EditCommand::undo() {
    m_model.put(m_before);
}

void EditCommand::redo() {
    m_model.put(m_after);
}

int EditCommand::id() const {
    return m_mergeKey.isEmpty() ? -1 : mergeable;
}

bool EditCommand::mergeWith(const QUndoCommand *other) {
    const auto *next = static_cast<const EditCommand *>(other); // same id: the only class of this stack
    if (next->m_mergeKey != m_mergeKey)
        return false;
    m_after = next->m_after;
    setObsolete(*m_after == *m_before);
    return true;
}

} // namespace palmer::ui
