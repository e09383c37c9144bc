// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// Commits the text being typed into a table cell, as leaving the cell does; a text that cannot be accepted
/// stays in the cell with the reason. Form fields commit every letter as it is typed.
void commitTyping();

/// From now on the wheel changes focused fields only, typing is committed before anything is done with the
/// document, standard buttons have the program's texts, and dialogs fit their screen and their tab order.
void guardWidgets(QApplication &application);

} // namespace palmer::ui
