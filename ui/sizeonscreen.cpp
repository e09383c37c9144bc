// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sizeonscreen.h"

#include "ui/madewidgets.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QLayout>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr QLatin1StringView placeName("beyondTheScreen");

/// True if the item is a row of buttons, not dialog content.
bool isRowOfButtons(QLayoutItem &item) {
    if (qobject_cast<QDialogButtonBox *>(item.widget()))
        return true;
    const auto *row = qobject_cast<QHBoxLayout *>(item.layout());
    if (!row || item.expandingDirections().testFlag(Qt::Vertical))
        return false;
    for (int i = 0; i < row->count(); ++i) {
        const QWidget *widget = row->itemAt(i)->widget();
        if (qobject_cast<const QPushButton *>(widget) || qobject_cast<const QDialogButtonBox *>(widget))
            return true;
    }
    return false;
}

/// Takes the button row at the end of a dialog's column out of its layout; null if there is none, or it is
/// too wide itself.
QLayoutItem *takeButtons(QLayout &whole, int room) {
    const auto *column = qobject_cast<QVBoxLayout *>(&whole);
    if (!column || column->count() < 2)
        return nullptr;
    QLayoutItem *last = column->itemAt(column->count() - 1);
    const QMargins margins = whole.contentsMargins();
    if (!isRowOfButtons(*last) || last->minimumSize().width() + margins.left() + margins.right() > room)
        return nullptr;
    return whole.takeAt(column->count() - 1);
}

void scroll(QDialog &dialog, QLayout &whole, int room) {
    const QPointer<QWidget> focused = dialog.focusWidget();
    const QMargins margins = whole.contentsMargins();
    QLayoutItem *buttons = takeButtons(whole, room);
    QScrollArea *area = scrolledPlace(&dialog);
    area->setObjectName(placeName);
    auto *inner = new QWidget(area->viewport());
    inner->setLayout(&whole); // takes the layout and its widgets from the dialog
    area->setWidget(inner);
    auto *column = inColumn(&dialog, noMargins, 0, {{area, 1}});
    if (buttons) {
        auto *foot = new QWidget(&dialog);
        auto *row = new QHBoxLayout(foot);
        row->setContentsMargins(margins.left(), margins.bottom() / 2, margins.right(), margins.bottom());
        if (QLayout *inRow = buttons->layout()) {
            inRow->setParent(nullptr);
            row->addLayout(inRow);
        } else {
            row->addWidget(buttons->widget());
            delete buttons;
        }
        column->addWidget(foot);
    }
    area->show();
    column->activate();
    dialog.resize(dialog.width() + area->verticalScrollBar()->sizeHint().width(), dialog.height());
    orderTabs(dialog); // reparenting moved widgets in the tab order
    if (focused)
        focused->setFocus();
}

class SizeGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override {
        // A dialog may grow while open, through its language or the user's choices.
        if (event->type() != QEvent::Show && event->type() != QEvent::LayoutRequest)
            return false;
        auto *dialog = qobject_cast<QDialog *>(watched);
        if (!dialog || !dialog->isWindow() || !dialog->isVisible() || !dialog->layout() ||
            qobject_cast<QMessageBox *>(dialog)) // message boxes size themselves
            return false;
        const QSize room = sizeOnScreen(*dialog, QSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX));
        const QSize least = dialog->layout()->totalMinimumSize();
        const bool isBeyond = least.width() > room.width() || least.height() > room.height();
        if (isBeyond && !dialog->findChild<QScrollArea *>(placeName))
            scroll(*dialog, *dialog->layout(), room.width());
        if (dialog->width() > room.width() || dialog->height() > room.height())
            dialog->resize(dialog->size().boundedTo(room));
        return false;
    }
};

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

QSize sizeOnScreen(const QWidget &window, QSize wished) {
    const QSize room = window.screen()->availableSize();
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &window);
    return wished.boundedTo({room.width(), room.height() - title});
}

void placeBeside(const QWidget &first, QWidget &window) {
    constexpr int step = 24;
    if (window.isMaximized() || window.isFullScreen())
        return;
    const bool fills = first.isMaximized() || first.isFullScreen();
    const QRect normal = first.normalGeometry();
    const QSize wished = !fills ? first.size() : normal.isValid() ? normal.size() : window.size();
    window.resize(sizeOnScreen(first, wished));
    const QRect room = first.screen()->availableGeometry();
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &window);
    const QPoint corner = (fills ? room.topLeft() : first.pos()) + QPoint(step, step);
    const QPoint last(room.right() + 1 - window.width(), room.bottom() + 1 - window.height() - title);
    window.move(std::max(room.left(), std::min(corner.x(), last.x())),
                std::max(room.top(), std::min(corner.y(), last.y())));
}

QScrollArea *scrolledPlace(QWidget *parent) {
    auto *area = new QScrollArea(parent);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    // Qt scrolls only on Tab, and not to all widgets Tab reaches; nothing may move under the mouse.
    QObject::connect(qApp, &QApplication::focusChanged, area, [area](const QWidget *, QWidget *now) {
        if (now && area->widget() && area->widget()->isAncestorOf(now) &&
            QGuiApplication::mouseButtons() == Qt::NoButton)
            area->ensureWidgetVisible(now);
    });
    return area;
}

void orderTabs(QWidget &window) {
    Walk walk;
    walk.through(*window.layout());
    if (walk.first())
        beginWith(window, walk.first());
}

void guardDialogs(QApplication &application) {
    application.installEventFilter(new SizeGuard(&application));
    application.installEventFilter(new ShownDialogs(&application));
}

} // namespace palmer::ui
