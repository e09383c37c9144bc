// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/taborder.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>

namespace palmer::ui {

namespace {

class Walk {
public:
    [[nodiscard]] QWidget *first() const { return m_first; }
    void through(const QLayout &layout) {
        for (int i = 0; i < layout.count(); ++i) {
            QLayoutItem *item = layout.itemAt(i);
            if (QWidget *widget = item->widget())
                through(*widget);
            else if (const QLayout *inner = item->layout())
                through(*inner);
        }
    }

private:
    void through(QWidget &widget) {
        if (auto *area = qobject_cast<QScrollArea *>(&widget); area && area->widget()) {
            const QWidget *before = m_last;
            through(*area->widget());
            if (m_last != before) { // Tab goes to its content
                area->setFocusPolicy(Qt::NoFocus);
                return;
            }
        }
        if ((widget.focusPolicy() & Qt::TabFocus) && !widget.focusProxy()) {
            if (m_last)
                QWidget::setTabOrder(m_last, &widget);
            else
                m_first = &widget;
            m_last = &widget;
        }
        if (const auto *splitter = qobject_cast<QSplitter *>(&widget)) {
            for (int i = 0; i < splitter->count(); ++i)
                through(*splitter->widget(i));
        } else if (const auto *tabs = qobject_cast<QTabWidget *>(&widget)) {
            through(*tabs->tabBar());
            for (int i = 0; i < tabs->count(); ++i)
                through(*tabs->widget(i));
        } else if (const QLayout *layout = widget.layout()) {
            through(*layout);
        }
    }

    QWidget *m_first = nullptr;
    QWidget *m_last = nullptr;
};

QWidget *next(QWidget *widget) {
    return widget->nextInFocusChain();
}

QWidget *previous(QWidget *widget) {
    return widget->previousInFocusChain();
}

/// The focusable neighbour of the window in the focus chain; the window itself takes no focus.
QWidget *neighbour(QWidget &window, QWidget *(*step)(QWidget *)) {
    QWidget *widget = step(&window);
    while (widget != &window && widget->focusPolicy() == Qt::NoFocus)
        widget = step(widget);
    return widget;
}

/// Rotates the focus chain to begin with `first`: widgets before it go to the end.
void beginWith(QWidget &window, QWidget *first) {
    const QWidget *before = nullptr;
    for (QWidget *head = neighbour(window, next); head != first && head != before;
         head = neighbour(window, next)) {
        QWidget *last = neighbour(window, previous);
        QWidget::setTabOrder(first, head); // for Qt `head` already follows `last`, except for the window
        QWidget::setTabOrder(last, head);
        before = head;
    }
}

class ShownDialogs : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override {
        constexpr const char *done = "tabsInOrder";
        if (event->type() != QEvent::Show || !watched->isWidgetType())
            return false;
        auto *dialog = qobject_cast<QDialog *>(watched);
        const bool isOfQt = *watched->metaObject()->className() == 'Q'; // has its own order
        if (dialog && !isOfQt && dialog->isWindow() && dialog->layout() && !dialog->property(done).toBool()) {
            dialog->setProperty(done, true);
            orderTabs(*dialog);
        }
        return false;
    }
};

} // namespace

void orderTabs(QWidget &window) {
    Walk walk;
    walk.through(*window.layout());
    if (walk.first())
        beginWith(window, walk.first());
}

void orderTabsOfDialogs(QApplication &application) {
    application.installEventFilter(new ShownDialogs(&application));
}

} // namespace palmer::ui
