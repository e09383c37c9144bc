// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// From now on the wheel does not change unfocused fields but scrolls the area around them.
void guardWheel(QApplication &application);

} // namespace palmer::ui
