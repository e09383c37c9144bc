// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// Gives the standard buttons of message boxes and input dialogs the program's texts, with mnemonics. Qt's
/// own have none here, and its French text of Discard differs.
void nameStandardButtons(QApplication &application);

} // namespace palmer::ui
