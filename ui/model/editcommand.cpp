// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/editcommand.h"

#include <utility>

namespace palmer::ui {

namespace {

constexpr int mergeable = 1;
constexpr std::size_t largeTest = 2000; ///< readings; smaller tests are kept whole

} // namespace

EditCommand::EditCommand(DocumentModel &model, const char *text, DocumentPointer after, QString mergeKey)
    : QUndoCommand(QString::fromUtf8(text))
    , m_model(model)
    , m_kept(*model.document(), *after, largeTest)
    , m_new(std::move(after))
    , m_mergeKey(std::move(mergeKey)) {}

EditCommand::EditCommand(DocumentModel &model, const QString &text, KeptDocument before)
    : QUndoCommand(text)
    , m_model(model)
    , m_kept(std::move(before))
    , m_done(true) {}

void EditCommand::undo() {
    const DocumentPointer from = m_model.document();
    auto to = std::make_shared<const Document>(m_kept.with(*from));
    m_kept = KeptDocument(*from, *to, largeTest);
    m_model.put(std::move(to));
}

void EditCommand::redo() {
    if (m_new)
        m_model.put(std::exchange(m_new, nullptr));
    else if (!std::exchange(m_done, false))
        undo(); // swaps back to the other end
}

int EditCommand::id() const {
    return m_mergeKey.isEmpty() ? -1 : mergeable;
}

bool EditCommand::mergeWith(const QUndoCommand *other) {
    const auto *next = static_cast<const EditCommand *>(other); // same id: the only class of this stack
    if (next->m_mergeKey != m_mergeKey)
        return false;
    const Document &after = *m_model.document(); // `other` was done already
    const Document before = m_kept.with(next->m_kept.with(after));
    m_kept = KeptDocument(before, after, largeTest);
    setObsolete(before == after);
    return true;
}

} // namespace palmer::ui
