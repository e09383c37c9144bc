// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/openregister.h"

#include "ui/register/registerservice.h"
#include "ui/register/registerwindow.h"
#include "ui/window/mainwindow.h"

#include <QApplication>
#include <QPointer>

namespace palmer::ui {

namespace {

/// Opens the test in an existing window, or a new one if all are closed.
void openFromRegister(const QString &path, std::size_t test) {
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (auto *window = qobject_cast<MainWindow *>(widget)) {
            window->openFile(path, test);
            return;
        }
    }
    auto *window = new MainWindow; // deletes itself on closing
    window->show();
    window->openFile(path, test);
}

} // namespace

void showRegister() {
    static QPointer<RegisterWindow> window;
    if (!window) {
        window = new RegisterWindow(RegisterService::instance());
        window->setAttribute(Qt::WA_DeleteOnClose);
        QObject::connect(window, &RegisterWindow::openAsked, window, &openFromRegister);
    }
    window->show();
    window->raise();
    window->activateWindow();
}

void startRegister() {
    (void)RegisterService::instance();
}

void noteSavedFile(const QString &path) {
    RegisterService::instance().fileSaved(path);
}

} // namespace palmer::ui
