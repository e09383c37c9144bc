// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/streams.h"

#include "system/filename.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace palmer {

// NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): so POSIX declares open, fcntl and ioctl

void prepareStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0)
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    }
}

std::optional<int> columnsOfTerminal() {
    winsize size{};
    if (::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    return {};
}

bool errorsGoToTerminal() {
    const char *const terminal = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) == 1 && !(terminal && std::string_view(terminal) == "dumb");
}

QuietErrors::QuietErrors()
    : m_before(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (m_before >= 0 && nowhere >= 0)
        ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0)
        ::close(nowhere);
}

QuietErrors::~QuietErrors() {
    if (m_before < 0)
        return;
    ::dup2(m_before, STDERR_FILENO);
    ::close(m_before);
}

std::optional<OpenPipe> openPipe(const QString &file) {
    struct stat about {};
    const QByteArray name = nativeFileName(file);
    if (::stat(name.constData(), &about) != 0 || !S_ISFIFO(about.st_mode))
        return {};
    const int pipe = ::open(name.constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    constexpr std::chrono::milliseconds pause(20);
    constexpr int pauses = 100;
    for (int waited = 0; pipe >= 0 && waited < pauses; ++waited) {
        char first = 0;
        const ssize_t size = ::read(pipe, &first, 1);
        if (size > 0 || (size < 0 && errno == EAGAIN)) { // there is a writer
            ::fcntl(pipe, F_SETFL, 0);
            return OpenPipe{pipe, size > 0 ? QByteArray(1, first) : QByteArray()};
        }
        std::this_thread::sleep_for(pause);
    }
    if (pipe >= 0)
        ::close(pipe);
    return OpenPipe{};
}

// NOLINTEND(cppcoreguidelines-pro-type-vararg)

} // namespace palmer
