// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/fonts.h"
#include "ui/guards.h"
#include "ui/theme.h"
#include "ui/window/mainwindow.h"
#include "ui/window/workplace.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QLabel>
#include <QPointer>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>
#include <memory>

/// Prepares a test program as main() prepares the window's, with settings of its own.
inline void prepareApplication() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("palmer-test"));
    QCoreApplication::setApplicationName(
        QStringLiteral("palmer-test-%1").arg(QCoreApplication::applicationPid()));
    QSettings().clear();
    QApplication::setStyle(QStringLiteral("fusion"));
    palmer::loadFonts();
    palmer::ui::installTheme();
    palmer::ui::guardWidgets(*qApp);
}

/// A real window, shown; it deletes itself when it is closed.
struct ShownWindow {
    explicit ShownWindow(const QString &file = {}, QSize size = {1280, 800})
        : window(new palmer::ui::MainWindow) {
        QTest::failOnWarning(
            QRegularExpression(QStringLiteral("^Q[A-Z]\\w+::"))); // what Qt says of wrong calls
        window->resize(size);
        window->show();
        if (file.isEmpty())
            return;
        window->openFile(file);
        const auto *state = find<QLabel>("statusState");
        while (state->text().contains(QFileInfo(file).fileName())) // it is read in the background
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    ~ShownWindow() { delete window; }
    ShownWindow(const ShownWindow &) = delete;
    ShownWindow &operator=(const ShownWindow &) = delete;

    template <typename Widget = QWidget>
    [[nodiscard]] Widget *find(const char *name) const {
        auto *found = window->findChild<Widget *>(QLatin1StringView(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }

    QPointer<palmer::ui::MainWindow> window;
};

inline QString examplePath(const char *name) {
    return QStringLiteral(":/examples/%1.palmer").arg(QLatin1StringView(name));
}
