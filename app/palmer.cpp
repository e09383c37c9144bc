// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "windowoptions.h"

#include "document/windowthread.h"
#include "environment.h"
#include "system/memory.h"
#include "system/process.h"
#include "ui/application.h"
#include "ui/guards.h"
#include "ui/model/settings.h"
#include "ui/sizeonscreen.h"
#include "ui/theme.h"
#include "ui/window/endofsession.h"
#include "ui/window/mainwindow.h"
#include "ui/window/openregister.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QHashSeed>
#include <QIcon>

int main(int argc, char *argv[]) {
    using namespace palmer::ui;
    palmer::returnMemoryEarly();
    QHashSeed::setDeterministicGlobalSeed(); // first of all, so that the same report has the same bytes
    palmer::reportFilesTooLarge();
    palmer::reportBrokenPipes();
    if (const auto code = palmer::answeredWithoutWindow(palmer::wordsOf(argc, argv)))
        return *code;
    palmer::useOwnFontConfiguration();
    const auto application = makeApplication(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("palmer"));
    QCoreApplication::setOrganizationName(QStringLiteral("palmer"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PALMER_VERSION));
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Palmer"));
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.palmer_metrology.Palmer"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/palmer.svg")));
    useSafeSettings();
    restoreWindowLanguage();
    installTheme();
    keepCopiesAtEnd(*application);
    guardWidgets(*application);

    auto *window = new MainWindow; // deletes itself when it is closed
    window->show();
    for (const QString &file : palmer::filesOf(palmer::wordsOf(argc, argv))) // without Qt's options
        window->openFile(file);
    window->offerRecoveries();
    startRegister();
    const palmer::WindowThread thisThread;
    return QApplication::exec();
}
