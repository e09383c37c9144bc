// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <memory>

class QApplication;

namespace palmer::ui {

/// Scale factor of the window for a font size in pixels: 1 for default desktop fonts, otherwise in steps of
/// 0.25, limited to what fits on a screen of that size. Fields, rows and icons then grow with the font.
[[nodiscard]] double scaleForFont(double pixels, QSize screen);

/// Makes the application with the program's style, scaled for its font. No other Qt object may exist yet.
/// `argc` and `argv` must outlive it.
[[nodiscard]] std::unique_ptr<QApplication> makeApplication(int &argc, char **argv);

/// If the window is scaled, gives menus and tools the font of the rest, as each style change restores the
/// desktop's fonts. Otherwise does nothing.
void useOneFont();

} // namespace palmer::ui
