// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/streams.h"

#include "system/windows/worker.h"

#include <cstdio>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace palmer {

void prepareStreams() {
    prepareAsWorker();
    for (std::FILE *stream : {stdin, stdout, stderr})
        ::_setmode(::_fileno(stream), _O_BINARY);
    ::SetConsoleOutputCP(CP_UTF8);
    DWORD mode = 0;
    HANDLE console = ::GetStdHandle(STD_ERROR_HANDLE);
    if (::GetConsoleMode(console, &mode) != 0) // the line of progress is cleared by a sequence
        ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

std::optional<int> columnsOfTerminal() {
    CONSOLE_SCREEN_BUFFER_INFO screen{};
    if (::GetConsoleScreenBufferInfo(::GetStdHandle(STD_OUTPUT_HANDLE), &screen) == 0)
        return {};
    return screen.srWindow.Right - screen.srWindow.Left + 1;
}

bool errorsGoToTerminal() {
    DWORD mode = 0;
    return ::GetConsoleMode(::GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

QuietErrors::QuietErrors()
    : m_before(::_dup(::_fileno(stderr))) {
    const int nowhere = ::_open("NUL", _O_WRONLY);
    if (m_before >= 0 && nowhere >= 0)
        ::_dup2(nowhere, ::_fileno(stderr));
    if (nowhere >= 0)
        ::_close(nowhere);
}

QuietErrors::~QuietErrors() {
    if (m_before < 0)
        return;
    ::_dup2(m_before, ::_fileno(stderr));
    ::_close(m_before);
}

std::optional<OpenPipe> openPipe(const QString &) {
    return {};
}

} // namespace palmer
