// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/editcommand.h"

namespace palmer::ui {

namespace {

constexpr int mergeable = 1;
constexpr std::size_t largeTest = 20'000; ///< readings; a step of less needs no thrift

} // namespace

EditCommand::EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey)
    : QUndoCommand(QString::fromUtf8(text))
    , m_model(model)
    , m_before(model.document())
    , m_after(std::move(after))
    , m_mergeKey(std::move(mergeKey)) {
    m_readings = changedReadings(*m_before, *m_after, largeTest);
    if (m_readings)
        m_before.reset();
}

void EditCommand::undo() {
    m_model.put(m_readings
                    ? std::make_shared<const Document>(withReadingsBefore(*m_model.document(), *m_readings))
                    : m_before);
}

void EditCommand::redo() {
    m_model.put(m_after
                    ? m_after
                    : std::make_shared<const Document>(withReadingsAfter(*m_model.document(), *m_readings)));
    if (m_readings)
        m_after.reset();
}

int EditCommand::id() const {
    return m_mergeKey.isEmpty() || m_readings ? -1 : mergeable;
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
