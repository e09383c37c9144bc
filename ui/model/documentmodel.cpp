// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/documentmodel.h"

#include "document/savedocument.h"
#include "kernel/measurement/testfacts.h"
#include "ui/model/editcommand.h"

#include <QFileInfo>
#include <QUndoStack>
#include <algorithm>
#include <variant>

namespace palmer::ui {

namespace {

constexpr std::size_t mostMemory = std::size_t{256} * 1024 * 1024; ///< of all steps together, about
constexpr std::size_t readingSize = 24; ///< bytes a reading takes in a test that is copied
constexpr int leastSteps = 10;
constexpr int mostSteps = 1000;

/// A step holds the test it changed anew; the other tests of the file are shared.
int stepsFor(const Document &document) {
    std::size_t most = 1;
    for (const TestPointer &test : document.tests)
        most = std::max(most, readingsOf(*test));
    const std::size_t steps = mostMemory / (most * readingSize);
    return std::clamp(static_cast<int>(std::min<std::size_t>(steps, mostSteps)), leastSteps, mostSteps);
}

} // namespace

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
    m_stack->setUndoLimit(stepsFor(*m_document)); // of an empty stack only
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
