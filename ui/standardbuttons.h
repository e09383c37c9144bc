// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// Gives the standard buttons of message boxes and of boxes that ask for a text our words, with a letter for
/// the keyboard. Qt's own have none here, and its French says otherwise what Discard does.
void nameStandardButtons(QApplication &application);

} // namespace palmer::ui
