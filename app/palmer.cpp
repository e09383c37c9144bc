// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "windowoptions.h"

#include "document/filename.h"
#include "ownfonts.h"
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
#include <csignal>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

/// Edits copy large tests in many small blocks: return free memory to the system, as sixty edits of a million
/// readings kept 120 MB otherwise.
void giveMemoryBack() {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
    mallopt(M_MMAP_THRESHOLD,
            4 << 20); // glibc's adaptive value; setting the other threshold would fix it at 128 KiB
#endif
}

} // namespace

int main(int argc, char *argv[]) {
    using namespace palmer::ui;
    giveMemoryBack();
    QHashSeed::setDeterministicGlobalSeed(); // first of all, so that the same report has the same bytes
    std::signal(SIGXFSZ, SIG_IGN);           // a file over its size limit is reported as an error
    std::signal(SIGPIPE, SIG_IGN);           // so is a pipe without reader
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << palmer::fileNameOf(argv[i]);
    if (const auto code = palmer::answeredWithoutWindow(words))
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
    QStringList rest; // without Qt's options
    for (int i = 1; i < argc; ++i)
        rest << palmer::fileNameOf(argv[i]);
    for (const QString &file : palmer::filesOf(rest))
        window->openFile(file);
    window->offerRecoveries();
    startRegister();
    return QApplication::exec();
}
