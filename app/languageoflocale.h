// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "system/process.h"

namespace palmer {

inline Language languageOfLocale() {
    const QString locale = localeOfUser();
    return locale.isEmpty() ? Language(Language::Id::english) : Language::fromLocale(locale);
}

} // namespace palmer
