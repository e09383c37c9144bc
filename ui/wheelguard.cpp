// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/wheelguard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QTabBar>

namespace palmer::ui {

namespace {

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

} // namespace

void guardWheel(QApplication &application) {
    application.installEventFilter(new WheelGuard(&application));
}

} // namespace palmer::ui
