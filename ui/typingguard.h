// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// Commits the text being typed into a table cell, as leaving the cell does; a text that cannot be accepted
/// stays in the cell with the reason. Form fields commit every letter as it is typed.
void commitTyping();

/// From now on a shortcut, a click outside the cell and closing the window call commitTyping first, so that
/// nothing is saved, printed, exported or closed without a number visible on screen.
void guardTyping(QApplication &application);

} // namespace palmer::ui
