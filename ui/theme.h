// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QString>

class QPainter;
class QToolButton;
class QWidget;

namespace palmer {
enum class Medium;
}

namespace palmer::ui {

/// Colours without a palette role, each with a light and a dark value.
enum class Token {
    ok, ///< conforms
    okGround,
    bad, ///< nonconforming
    badGround,
    unsure, ///< not proven, or required statement
    unsureGround,
    explanation,
    accent,
    secondaryText,
    line,
    lineStrong, ///< below the rows of one run
    hover,      ///< background under the pointer
    up,         ///< ↑ lines and text
    down,       ///< ↓ lines
    downText,   ///< ↓ as text, which needs more contrast
};

/// True if the palette is dark: its text lighter than its background.
[[nodiscard]] bool isDark(const QPalette &palette);

/// Screen medium, light or dark according to the palette.
[[nodiscard]] Medium screenMedium(const QPalette &palette);

[[nodiscard]] QColor token(Token token, const QPalette &palette);

/// Background of selected or current items.
[[nodiscard]] QColor selectedGround(const QPalette &palette);

/// Text sizes as factors of the system font.
enum class TextSize { base, small, tiny, head, title };

/// The system font in one of the sizes; heads and titles are semi-bold.
[[nodiscard]] QFont themeFont(TextSize size);

/// The line icon `:/icons/<name>.svg` in the palette's current colour for `role`; enabled and disabled, sharp
/// at any pixel ratio.
[[nodiscard]] QIcon lineIcon(const QString &name, QPalette::ColorRole role = QPalette::WindowText);

/// An icon-only button that takes the keyboard focus.
[[nodiscard]] QToolButton *iconButton(QWidget *parent, const QString &objectName, const QString &icon);

/// Draws a line icon centred in `area`, in 16 × 16.
void drawLineIcon(QPainter &painter, const QRect &area, const QString &name, const QColor &colour);

/// Theme of the windows: the system's, or the program's light or dark one. Kept in the user's settings.
enum class ThemeChoice { system, light, dark };
[[nodiscard]] ThemeChoice themeChoice();
/// Takes effect at once.
void setThemeChoice(ThemeChoice choice);

/// Size of all texts of the windows, in steps of a tenth of the system's, −2 … 5. Kept in the user's
/// settings.
[[nodiscard]] int textSizeStep();
/// Takes effect at once; beyond the ends, the nearest.
void setTextSizeStep(int step);

/// Sets a widget property used by the style sheet.
void setStyled(QWidget &widget, const char *property, bool value);

/// Fills the application's style sheet from its palette, now and whenever the palette changes; the palette
/// follows the chosen theme. Call once.
void installTheme();

} // namespace palmer::ui
