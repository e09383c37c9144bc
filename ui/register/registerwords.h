// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace palmer::ui {

/// A translated text of %n, with that number grouped in thousands as in the window's language.
[[nodiscard]] QString counted(QString text, int number);

} // namespace palmer::ui
