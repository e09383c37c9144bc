// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tablepaste.h"

#include "document/documenterror.h"
#include "ui/model/documentmodel.h"
#include "ui/pastebar.h"
#include "ui/windowlanguage.h"

#include <QKeyEvent>
#include <QLayout>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QUndoStack>
#include <utility>

namespace palmer::ui {

namespace {

class TableKeys : public QObject {
public:
    TableKeys(QWidget &table, std::function<void()> paste, std::function<void()> remove)
        : QObject(&table)
        , m_paste(std::move(paste))
        , m_remove(std::move(remove)) {
        table.installEventFilter(this);
    }

    bool eventFilter(QObject *watched, QEvent *event) override {
        if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
            auto *key = static_cast<QKeyEvent *>(event);
            const bool pastes = key->matches(QKeySequence::Paste);
            if (pastes || key->matches(QKeySequence::Delete)) {
                if (event->type() == QEvent::ShortcutOverride)
                    event->accept();
                else
                    (pastes ? m_paste : m_remove)();
                return true;
            }
        }
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> m_paste;
    std::function<void()> m_remove;
};

} // namespace

void takeTableKeys(QWidget &table, std::function<void()> paste, std::function<void()> remove) {
    auto *shortcut = new QShortcut(QKeySequence::Paste, table.parentWidget(), paste);
    shortcut->setContext(Qt::WindowShortcut);
    new TableKeys(table, std::move(paste), std::move(remove));
}

TablePaste::TablePaste(DocumentModel &model, QWidget &page)
    : QObject(&page)
    , m_model(model)
    , m_page(page) {
    connect(m_model.undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        if (!m_isReading && index != m_index)
            end(); // its choices would paste once more
    });
}

/// Returns the bar, made at the first paste.
PasteBar &TablePaste::bar() {
    if (m_bar)
        return *m_bar;
    m_bar = new PasteBar(&m_page);
    m_page.layout()->addWidget(m_bar);
    connect(m_bar, &PasteBar::answered, this, [this](const QString &key, const QString &word) {
        const ImportOptions before = m_answers;
        m_answers[key.toStdString()] = word.toStdString();
        if (!read())
            m_answers = before;
    });
    connect(m_bar, &PasteBar::undoWanted, this, [this] {
        if (m_index == m_model.undoStack()->index())
            m_model.undoStack()->undo();
        end();
        emit undone();
    });
    return *m_bar;
}

void TablePaste::paste(Put put) {
    m_put = std::move(put);
    m_answers.clear();
    read();
}

/// Reads the table; after an answer, instead of what was put before. False if it is refused: then nothing is
/// put, and questions still wait for another answer.
bool TablePaste::read() {
    QUndoStack &stack = *m_model.undoStack();
    const bool isAgain = m_index == stack.index() && !m_answers.empty();
    m_index = -1;
    const QScopedValueRollback reading(m_isReading, true);
    if (isAgain)
        stack.undo();
    try {
        const int before = stack.index();
        const SaidPaste pasted = m_put(m_answers);
        m_index = stack.index() == before ? -1 : stack.index(); // what changes nothing is no step
        bar().say(pasted.summary, pasted, m_index > 0, pasted.motion);
        return true;
    } catch (const Error &error) {
        if (isAgain || m_answers.empty())
            end();
        emit refused(windowLanguage().sentence(error.message));
        return false;
    }
}

void TablePaste::end() {
    m_index = -1;
    if (m_bar)
        m_bar->hide();
}

} // namespace palmer::ui
