// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "system/process.h"

#include <QFile>
#include <QFileInfo>

namespace palmer {

/// The language of the user's locale; English if none is set.
inline Language languageOfLocale() {
    const QString locale = localeOfUser();
    return locale.isEmpty() ? Language(Language::Id::english) : Language::fromLocale(locale);
}

/// Names the configuration of fontconfig that is unpacked with the program (packaging/linux/build), where the
/// system has none; without any, fontconfig complains on stderr. To be called before QGuiApplication is made.
inline void useOwnFontConfiguration() {
    const QString own = QFileInfo(QStringLiteral("/proc/self/exe")).canonicalPath() +
                        QStringLiteral("/../share/palmer/fonts.conf");
    if (!qEnvironmentVariableIsSet("FONTCONFIG_FILE") &&
        !QFile::exists(QStringLiteral("/etc/fonts/fonts.conf")) && QFile::exists(own))
        qputenv("FONTCONFIG_FILE", QFile::encodeName(own));
}

} // namespace palmer
