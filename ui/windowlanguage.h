// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"

#include <QString>

namespace palmer::ui {

/// The language of the windows, which is not that of the reports. English before the first of the functions
/// below was called.
[[nodiscard]] const Language &windowLanguage();

/// Lets all windows speak that language from now on: installs the texts of the program and those of Qt, sets
/// the locale of new widgets and remembers the choice. Every widget gets QEvent::LanguageChange.
void setWindowLanguage(Language::Id id);

/// The text of a count with the digits of the count in groups: "1 000 001 lines".
[[nodiscard]] QString withGroups(QString text, int count);

/// The units numbers are shown and typed in, in all windows from now on; remembered. Data and reports stay as
/// they are. Every widget gets QEvent::LanguageChange, as for another language.
void setWindowUnits(const DisplayUnits &units);

/// At start: language and units chosen last; else the language of the system.
void restoreWindowLanguage();

} // namespace palmer::ui
