// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace palmer::ui {

/// Shows the register window; tests opened there get their own window.
void showRegister();

/// Starts to keep the user's register up to date with its folders, if any.
void startRegister();

/// Updates the register at once after saving a file in its folders.
void noteSavedFile(const QString &path);

} // namespace palmer::ui
