// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/typingguard.h"

#include <QAbstractItemDelegate>
#include <QAbstractItemView>
#include <QApplication>
#include <QEvent>
#include <QScrollBar>

namespace palmer::ui {

namespace {

/// The editor of a cell, with its table.
struct OpenEditor {
    QAbstractItemView *view = nullptr;
    QWidget *editor = nullptr;
};

OpenEditor openEditor(QWidget *focused) {
    for (QWidget *part = focused; part && part->parentWidget(); part = part->parentWidget()) {
        auto *view = qobject_cast<QAbstractItemView *>(part->parentWidget()->parentWidget());
        if (view && view->viewport() == part->parentWidget())
            return {view, part};
    }
    return {};
}

void commit(const OpenEditor &open) {
    if (!open.editor)
        return;
    QAbstractItemDelegate *delegate = open.view->itemDelegate();
    emit delegate->commitData(open.editor);
    emit delegate->closeEditor(open.editor);
}

/// True if a click there belongs to the typing: in the editor, its own menu or a scroll bar.
bool belongsTo(const QWidget *pressed, const QWidget *editor) {
    for (const QWidget *part = pressed; part; part = part->parentWidget()) {
        if (part == editor)
            return true;
    }
    return qobject_cast<const QScrollBar *>(pressed);
}

class TypingGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override {
        auto *widget = qobject_cast<QWidget *>(watched);
        if (event->type() == QEvent::Shortcut) {
            commitTyping();
        } else if (event->type() == QEvent::Close && widget) {
            commit(openEditor(widget->window()->focusWidget()));
        } else if (event->type() == QEvent::MouseButtonPress && widget) {
            const OpenEditor open = openEditor(QApplication::focusWidget());
            if (open.editor && !belongsTo(widget, open.editor))
                commit(open);
        }
        return false;
    }
};

} // namespace

void commitTyping() {
    commit(openEditor(QApplication::focusWidget()));
}

void guardTyping(QApplication &application) {
    application.installEventFilter(new TypingGuard(&application));
}

} // namespace palmer::ui
