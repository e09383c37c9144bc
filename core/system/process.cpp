// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/process.h"

namespace palmer {

QString localeOfUser() {
    for (const char *variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        QString locale = qEnvironmentVariable(variable);
        if (!locale.isEmpty())
            return locale;
    }
    return localeOfSystem();
}

} // namespace palmer
