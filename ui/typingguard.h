// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// Puts in what is being typed into a cell of a table, as leaving the cell does; a text that cannot be taken
/// stays where it was typed, with the reason. Fields of forms take every letter as it is typed.
void commitTyping();

/// From now on whatever the user does elsewhere comes after the typing: a shortcut, a press beside the cell
/// and the closing of the window first do what commitTyping does. So nothing is saved, printed, exported or
/// closed without a number that can be read on the screen.
void guardTyping(QApplication &application);

} // namespace palmer::ui
