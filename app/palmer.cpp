// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "windowoptions.h"

#include "document/filename.h"
#include "ui/application.h"
#include "ui/register/openregister.h"
#include "ui/settings.h"
#include "ui/sizeonscreen.h"
#include "ui/standardbuttons.h"
#include "ui/taborder.h"
#include "ui/theme.h"
#include "ui/typingguard.h"
#include "ui/wheelguard.h"
#include "ui/window/endofsession.h"
#include "ui/window/mainwindow.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QHashSeed>
#include <QIcon>
#include <csignal>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

/// The copies of a large test that edits make come and go in small pieces: what is free goes back to the
/// system, for the sixty edits of a million readings kept 120 MB otherwise.
void giveMemoryBack() {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
    mallopt(M_MMAP_THRESHOLD,
            4 << 20); // as it is by itself after a while; the former would hold it at 128 KiB
#endif
}

} // namespace

int main(int argc, char *argv[]) {
    using namespace palmer::ui;
    giveMemoryBack();
    QHashSeed::setDeterministicGlobalSeed(); // before all else: the same report is the same bytes
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow and a pipe that nobody reads are errors with a
    std::signal(SIGPIPE, SIG_IGN); // sentence
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << palmer::fileNameOf(argv[i]);
    if (const auto code = palmer::answeredWithoutWindow(words))
        return *code;
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
    guardWheel(*application);
    nameStandardButtons(*application);
    keepCopiesAtEnd(*application);
    guardTyping(*application);
    keepDialogsOnScreen(*application);
    orderTabsOfDialogs(*application);

    auto *window = new MainWindow; // deletes itself when it is closed
    window->show();
    QStringList rest; // without the options of Qt
    for (int i = 1; i < argc; ++i)
        rest << palmer::fileNameOf(argv[i]);
    for (const QString &file : palmer::filesOf(rest))
        window->openFile(file);
    window->offerRecoveries();
    startRegister();
    return QApplication::exec();
}
