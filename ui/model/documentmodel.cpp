#include "ui/model/documentmodel.h"

#include "document/savedocument.h"
#include "ui/model/editcommand.h"

#include <QFileInfo>
#include <QUndoStack>

namespace palmer::ui {

DocumentModel::DocumentModel(QObject *parent)
    : QObject(parent)
    , m_document(std::make_shared<const Document>())
    , m_stack(new QUndoStack(this)) {
    connect(m_stack, &QUndoStack::cleanChanged, this, &DocumentModel::fileChanged);
}

DocumentModel::~DocumentModel() {
    m_stack->disconnect(this); // its destructor clears it, which emits
}

bool DocumentModel::isModified() const {
    return !m_stack->isClean();
}

void DocumentModel::setDocument(Document document, const QString &path, bool modified) {
    m_path = path.isEmpty() ? QString() : QFileInfo(path).absoluteFilePath();
    m_document = std::make_shared<const Document>(std::move(document));
    m_stack->clear();
    if (modified)
        m_stack->resetClean();
    emit changed();
    emit fileChanged();
}

void DocumentModel::edit(const char *text, const std::function<void(Document &)> &change,
                         const QString &mergeKey) {
    auto after = std::make_shared<Document>(*m_document);
    change(*after);
    if (*after == *m_document)
        return;
    m_stack->push(new EditCommand(*this, text, std::move(after), mergeKey));
}

void DocumentModel::save(const QString &path) {
    saveDocument(*m_document, path);
    m_path = QFileInfo(path).absoluteFilePath();
    m_stack->setClean();
    emit fileChanged();
}

void DocumentModel::put(DocumentPointer document) {
    m_document = std::move(document);
    emit changed();
}

} // namespace palmer::ui
