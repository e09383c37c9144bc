// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"

#include <QString>

namespace palmer::ui {

/// The language of the windows, not of the reports. English until one of the functions below is called.
[[nodiscard]] const Language &windowLanguage();

/// Sets the language of all windows: installs the texts of the program and of Qt, sets the locale of new
/// widgets and remembers the choice. Every widget gets QEvent::LanguageChange.
void setWindowLanguage(Language::Id id);

/// Returns a text with the digits of its count grouped: "1 000 001 lines".
[[nodiscard]] QString withGroups(QString text, int count);

/// Sets the units in which all windows show and take numbers, and remembers them. Data and reports are
/// unchanged. Every widget gets QEvent::LanguageChange.
void setWindowUnits(const DisplayUnits &units);

/// At start: restores language and units; without a stored language takes the system's.
void restoreWindowLanguage();

} // namespace palmer::ui
