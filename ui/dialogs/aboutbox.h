// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace palmer::ui {

/// Shows the program's description, version and licence in a box above the window `parent`.
void showAbout(QWidget *parent);

} // namespace palmer::ui
