// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"

namespace palmer {

/// Language of the locale: the first of these variables that is set, as in POSIX.
inline Language languageOfLocale() {
    for (const char *variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const QString locale = qEnvironmentVariable(variable);
        if (!locale.isEmpty())
            return Language::fromLocale(locale);
    }
    return Language(Language::Id::english);
}

} // namespace palmer
