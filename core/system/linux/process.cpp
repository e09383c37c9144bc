// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.h"

#include "system/filename.h"

#include <QFile>
#include <QRegularExpression>
#include <QSocketNotifier>
#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace palmer {

QStringList wordsOf(int argc, const char *const *argv) {
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << fileNameOf(QByteArrayView(argv[i]));
    return words;
}

QString localeOfSystem() {
    return {};
}

void reportFilesTooLarge() {
    std::signal(SIGXFSZ, SIG_IGN);
}

void reportBrokenPipes() {
    std::signal(SIGPIPE, SIG_IGN);
}

bool hasScreen() {
    return std::ranges::any_of(std::array{"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"},
                               [](const char *name) { return !qEnvironmentVariableIsEmpty(name); });
}

namespace {

// A signal may come at any time: its handler may only write to a pipe.
std::array<int, 2> &signalPipe() {
    static std::array<int, 2> pipe{-1, -1};
    return pipe;
}

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): all that the handler of a signal has
int pipeToWrite = -1;

void noteSignal(int number) {
    const auto byte = static_cast<char>(number);
    [[maybe_unused]] const auto written = ::write(pipeToWrite, &byte, 1);
}

} // namespace

void onEnd(QObject &context, std::function<void()> work) {
    if (::pipe2(signalPipe().data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return;
    pipeToWrite = signalPipe()[1];
    auto *notifier = new QSocketNotifier(signalPipe()[0], QSocketNotifier::Read, &context);
    QObject::connect(notifier, &QSocketNotifier::activated, &context, [work = std::move(work)] {
        char number = 0;
        if (::read(signalPipe()[0], &number, 1) != 1)
            return;
        work();
        std::signal(number, SIG_DFL);
        std::raise(number);
    });
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        std::signal(number, noteSignal);
}

QString processorName() {
    QFile file(QStringLiteral("/proc/cpuinfo"));
    const bool isOpen = file.open(QIODevice::ReadOnly);
    static const QRegularExpression name(QStringLiteral("model name\\s*: (.*)"));
    return name.match(isOpen ? QString::fromUtf8(file.readAll()) : QString()).captured(1);
}

} // namespace palmer
