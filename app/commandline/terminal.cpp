// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/terminal.h"

#include "report/blocks/plaintext.h"
#include "system/streams.h"

#include <QtGlobal>
#include <algorithm>

namespace palmer {

namespace {

constexpr int fewest = 40; ///< tables need at least this width
constexpr int most = 1000;

std::optional<int> found() {
    bool isNumber = false;
    if (const int columns = qEnvironmentVariableIntValue("COLUMNS", &isNumber); isNumber && columns > 0)
        return std::clamp(columns, fewest, most);
    const std::optional<int> columns = columnsOfTerminal();
    return columns ? std::optional(std::clamp(*columns, fewest, most)) : std::nullopt;
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
