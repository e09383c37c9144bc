// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guards.h"

#include "ui/sizeonscreen.h"

#include <QAbstractButton>
#include <QAbstractItemDelegate>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QToolButton>

namespace palmer::ui {

namespace {

/// The wheel does not change unfocused fields but scrolls the area around them.
class WheelGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override {
        if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish)
            return false;
        auto *widget = qobject_cast<QWidget *>(watched);
        const bool field =
            qobject_cast<const QComboBox *>(widget) || qobject_cast<const QTabBar *>(widget) ||
            qobject_cast<const QAbstractSpinBox *>(widget) ||
            (qobject_cast<const QAbstractSlider *>(widget) && !qobject_cast<const QScrollBar *>(widget));
        if (!field)
            return false;
        if (event->type() == QEvent::Polish) {
            if (widget->focusPolicy() == Qt::WheelFocus)
                widget->setFocusPolicy(Qt::StrongFocus); // otherwise Qt focuses it before the wheel event
            return false;
        }
        if (widget->hasFocus())
            return false;
        event->ignore(); // passed on to the parent
        return true;
    }
};

/// Enter presses a button or checks a box as Space does, where no dialog has a default button for it.
class EnterGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override {
        auto *button = event->type() == QEvent::KeyPress ? qobject_cast<QAbstractButton *>(watched) : nullptr;
        if (!button || qobject_cast<QDialog *>(button->window()))
            return false;
        const auto *press = static_cast<QKeyEvent *>(event);
        const bool isEnter = press->key() == Qt::Key_Return || press->key() == Qt::Key_Enter;
        const auto *tool = qobject_cast<QToolButton *>(button);
        if (!isEnter || press->modifiers() & ~Qt::KeypadModifier || !button->isEnabled() ||
            (tool && tool->menu()))
            return false;
        button->click();
        return true;
    }
};

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

/// A shortcut, a click outside the cell and closing the window call commitTyping first, so that nothing is
/// saved, printed, exported or closed without a number visible on screen.
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

QString nameOf(QDialogButtonBox::StandardButton button) {
    const auto say = [](const char *text) {
        return QCoreApplication::translate("palmer::ui::StandardButtons", text);
    };
    switch (button) {
    case QDialogButtonBox::Ok:
        return say(QT_TRANSLATE_NOOP("palmer::ui::StandardButtons", "&OK"));
    case QDialogButtonBox::Save:
        return say(QT_TRANSLATE_NOOP("palmer::ui::StandardButtons", "&Save"));
    case QDialogButtonBox::Discard:
        return say(QT_TRANSLATE_NOOP("palmer::ui::StandardButtons", "&Discard"));
    case QDialogButtonBox::Cancel:
        return say(QT_TRANSLATE_NOOP("palmer::ui::StandardButtons", "&Cancel"));
    default:
        return {};
    }
}

constexpr int leastWidth = 380; ///< of a box, px

/// Qt makes a box as narrow as its shortest text: a sentence took six lines and a name was cut off.
void widen(QWidget &box) {
    if (auto *grid = qobject_cast<QGridLayout *>(box.layout())) // of a message box
        grid->addItem(new QSpacerItem(leastWidth, 0), grid->rowCount(), 0, 1, grid->columnCount());
    else if (auto *typed = box.findChild<QLineEdit *>()) // the dialog takes the width of its layout
        typed->setMinimumWidth(leastWidth);
}

/// Gives the standard buttons of message boxes and input dialogs the program's texts, with mnemonics. Qt's
/// own have none here, and its French text of Discard differs.
class BoxGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override {
        if (event->type() != QEvent::Polish)
            return false;
        if (qobject_cast<QMessageBox *>(watched) || qobject_cast<QInputDialog *>(watched))
            widen(*static_cast<QWidget *>(watched));
        auto *button = qobject_cast<QPushButton *>(watched);
        auto *box = button ? qobject_cast<QDialogButtonBox *>(button->parentWidget()) : nullptr;
        if (!box || button->property("named").toBool() ||
            (!qobject_cast<QMessageBox *>(box->window()) && !qobject_cast<QInputDialog *>(box->window())))
            return false;
        const QString name = nameOf(box->standardButton(button));
        if (!name.isEmpty())
            button->setText(name);
        return false;
    }
};

} // namespace

void commitTyping() {
    commit(openEditor(QApplication::focusWidget()));
}

void guardWidgets(QApplication &application) {
    for (QObject *guard :
         std::initializer_list<QObject *>{new WheelGuard(&application), new EnterGuard(&application),
                                          new BoxGuard(&application), new TypingGuard(&application)})
        application.installEventFilter(guard);
    guardDialogs(application);
}

} // namespace palmer::ui
