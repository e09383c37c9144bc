// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace palmer::ui {

/// Opens what the program is, its version and its licence, above the window `parent`.
void showAbout(QWidget *parent);

} // namespace palmer::ui
