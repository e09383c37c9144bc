// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace palmer::ui {

/// Shows the window of the register; tests that are opened there go to a window of their own.
void showRegister();

/// Starts to keep the register of the user, where folders were chosen, in step with them.
void startRegister();

/// A file was saved: it stands in the register at once, if it lies in its folders.
void noteSavedFile(const QString &path);

} // namespace palmer::ui
