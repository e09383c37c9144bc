// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <memory>

class QApplication;

namespace palmer::ui {

/// By how much the whole window is enlarged for fonts of that many pixels: by 1 for what desktops come with,
/// in quarters for fonts that someone made larger, as long as a screen of that size has room for the window.
/// Fields, rows and icons grow with the letters then.
[[nodiscard]] double scaleForFont(double pixels, QSize screen);

/// The application in the style of the program, enlarged as its font wants it. Nothing else of Qt may exist
/// yet. `argc` and `argv` have to outlive it.
[[nodiscard]] std::unique_ptr<QApplication> makeApplication(int &argc, char **argv);

/// Where the whole is enlarged, menus and tools have the font of the rest: those of the desktop come back
/// with every change of the style. Nothing where it is not.
void useOneFont();

} // namespace palmer::ui
