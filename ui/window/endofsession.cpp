// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/endofsession.h"

#include "system/process.h"
#include "ui/window/mainwindow.h"

#include <QApplication>

namespace palmer::ui {

void keepCopiesOfAllWindows() {
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (auto *window = qobject_cast<MainWindow *>(widget))
            window->keepCopy();
    }
}

void keepCopiesAtEnd(QGuiApplication &application) {
    QObject::connect(&application, &QGuiApplication::commitDataRequest, &application,
                     [](QSessionManager &) { keepCopiesOfAllWindows(); });
    onEnd(application, keepCopiesOfAllWindows); // destroying a window would discard its copy
}

} // namespace palmer::ui
