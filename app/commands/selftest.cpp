// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "report/blocks/plaintext.h"
#include "report/help/help.h"

#include <algorithm>

namespace palmer {

namespace {

int runSelftest(const Invocation &invocation) {
    const std::vector<SetValidation> sets = validateAll();
    printOut(plainText(composeValidation(sets, invocation.language), textColumns()));
    return std::ranges::all_of(sets, &SetValidation::agrees) ? done : difference;
}

} // namespace

Command selftestCommand() {
    return {"selftest",
            "",
            REPORT_TEXT("report", "evaluates the built-in reference data and compares with the known values"),
            {},
            runSelftest};
}

} // namespace palmer
