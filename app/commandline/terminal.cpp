// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/terminal.h"

#include "report/blocks/plaintext.h"

#include <QtGlobal>
#include <algorithm>
#include <sys/ioctl.h>
#include <unistd.h>

namespace palmer {

namespace {

constexpr int fewest = 40; ///< tables need at least this width
constexpr int most = 1000;

std::optional<int> found() {
    bool isNumber = false;
    if (const int columns = qEnvironmentVariableIntValue("COLUMNS", &isNumber); isNumber && columns > 0)
        return std::clamp(columns, fewest, most);
    winsize size{};
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): so POSIX declares it
    if (::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return std::clamp(static_cast<int>(size.ws_col), fewest, most);
    return {};
}

} // namespace

std::optional<int> terminalColumns() {
    static const std::optional<int> columns = found();
    return columns;
}

int textColumns() {
    return terminalColumns().value_or(terminalWidth);
}

} // namespace palmer
