// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/documentmodel.h"

#include "document/savedocument.h"
#include "kernel/measurement/testfacts.h"
#include "system/memory.h"
#include "ui/model/background.h"
#include "ui/model/editcommand.h"

#include <QFileInfo>
#include <QSignalBlocker>
#include <QTimer>
#include <QUndoStack>
#include <algorithm>
#include <vector>

namespace palmer::ui {

namespace {

constexpr int mostSteps = 1000;
constexpr std::size_t mostReadings = 6'000'000; ///< in large tests, over all steps: about 100 MB

constexpr int untilRest = 1000;             ///< ms without a change
constexpr std::size_t muchMemory = 100'000; ///< readings

const KeptDocument &keptAt(const QUndoStack &stack, int index) {
    return static_cast<const EditCommand *>(stack.command(index))->kept();
}

} // namespace

DocumentModel::DocumentModel(QObject *parent)
    : QObject(parent)
    , m_document(std::make_shared<const Document>())
    , m_stack(new QUndoStack(this))
    , m_rest(new QTimer(this)) {
    m_rest->setSingleShot(true);
    m_rest->setInterval(untilRest);
    connect(m_rest, &QTimer::timeout, this, [] { returnFreeMemory(); });
    m_stack->setUndoLimit(mostSteps);
    connect(m_stack, &QUndoStack::cleanChanged, this, &DocumentModel::fileChanged);
}

DocumentModel::~DocumentModel() {
    m_stack->disconnect(); // its destructor clears it and would signal a destroyed model
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
    boundSteps();
}

/// Limits the steps by memory. QUndoStack limits only their number, so it is refilled with the steps to keep.
void DocumentModel::boundSteps() {
    int first = m_stack->count() - 1; // the last step is kept whatever its size
    std::size_t readings = first < 0 ? 0 : keptAt(*m_stack, first).readings();
    while (first > 0 && readings + keptAt(*m_stack, first - 1).readings() <= mostReadings)
        readings += keptAt(*m_stack, --first).readings();
    if (first <= 0)
        return;
    const QSignalBlocker quiet(m_stack); // neither the next undo step nor the modified state changes
    const int clean = m_stack->cleanIndex() - first;
    std::vector<EditCommand *> kept;
    for (int i = first; i < m_stack->count(); ++i)
        kept.push_back(new EditCommand(*this, m_stack->text(i), keptAt(*m_stack, i)));
    m_stack->clear();
    if (clean != 0)
        m_stack->resetClean();
    for (EditCommand *command : kept) {
        m_stack->push(command);
        if (m_stack->index() == clean)
            m_stack->setClean();
    }
}

void DocumentModel::save(const QString &path) {
    const DocumentPointer saved = m_document;
    awaited([&] { saveDocument(*saved, path); });
    m_path = QFileInfo(path).absoluteFilePath();
    if (m_document == saved) // a field that lost the focus may have changed it
        m_stack->setClean();
    emit fileChanged();
}

void DocumentModel::put(DocumentPointer document) {
    m_document = std::move(document);
    if (std::ranges::any_of(m_document->tests,
                            [](const TestPointer &test) { return readingsOf(*test) >= muchMemory; }))
        m_rest->start();
    emit changed();
}

} // namespace palmer::ui
