// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/endofsession.h"

#include "ui/window/mainwindow.h"

#include <QApplication>
#include <QSocketNotifier>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace palmer::ui {

namespace {

// A signal may come at any time: its handler may only write to a pipe.
std::array<int, 2> &signalPipe() {
    static std::array<int, 2> pipe{-1, -1};
    return pipe;
}

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): all that the handler of a signal has
int pipeToWrite = -1;

void tell(int number) {
    const auto byte = static_cast<char>(number);
    [[maybe_unused]] const auto written = ::write(pipeToWrite, &byte, 1);
}

void endBySignal() {
    char number = 0;
    if (::read(signalPipe()[0], &number, 1) != 1)
        return;
    keepCopiesOfAllWindows();
    std::signal(number, SIG_DFL);
    std::raise(number); // destroying a window would discard its copy
}

} // namespace

void keepCopiesOfAllWindows() {
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (auto *window = qobject_cast<MainWindow *>(widget))
            window->keepCopy();
    }
}

void keepCopiesAtEnd(QGuiApplication &application) {
    QObject::connect(&application, &QGuiApplication::commitDataRequest, &application,
                     [](QSessionManager &) { keepCopiesOfAllWindows(); });
    if (::pipe2(signalPipe().data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return;
    pipeToWrite = signalPipe()[1];
    auto *notifier = new QSocketNotifier(signalPipe()[0], QSocketNotifier::Read, &application);
    QObject::connect(notifier, &QSocketNotifier::activated, &application, endBySignal);
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        std::signal(number, tell);
}

} // namespace palmer::ui
