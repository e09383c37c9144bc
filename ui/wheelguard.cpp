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
        if (field && event->type() == QEvent::Polish && widget->focusPolicy() == Qt::WheelFocus)
            widget->setFocusPolicy(Qt::StrongFocus); // Qt would give it the focus first, then the wheel
        if (!field || event->type() == QEvent::Polish || widget->hasFocus())
            return false;
        event->ignore(); // goes on to the parent
        return true;
    }
};

} // namespace

void guardWheel(QApplication &application) {
    application.installEventFilter(new WheelGuard(&application));
}

} // namespace palmer::ui
