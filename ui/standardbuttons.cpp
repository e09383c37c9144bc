// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/standardbuttons.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>

namespace palmer::ui {

namespace {

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
        if (!box ||
            (!qobject_cast<QMessageBox *>(box->window()) && !qobject_cast<QInputDialog *>(box->window())))
            return false;
        const QString name = nameOf(box->standardButton(button));
        if (!name.isEmpty())
            button->setText(name);
        return false;
    }
};

} // namespace

void nameStandardButtons(QApplication &application) {
    application.installEventFilter(new BoxGuard(&application));
}

} // namespace palmer::ui
