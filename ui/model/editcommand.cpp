#include "ui/model/editcommand.h"

#include <QCoreApplication>

namespace palmer::ui {

namespace {

constexpr int mergeable = 1;
constexpr QChar countMark(u'\u001F'); ///< before the count: the stack keeps texts only

QString keptText(const EditName &name) {
    const QString text = QString::fromUtf8(name.text);
    return name.count < 0 ? text : text + countMark + QString::number(name.count);
}

} // namespace

QString editWords(const QString &undoText) {
    const QString count = undoText.section(countMark, 1);
    return QCoreApplication::translate("edits", undoText.section(countMark, 0, 0).toUtf8(), nullptr,
                                       count.isEmpty() ? -1 : count.toInt());
}

EditCommand::EditCommand(DocumentModel &model, const EditName &name, DocumentPointer after, QString mergeKey)
    : QUndoCommand(keptText(name))
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
