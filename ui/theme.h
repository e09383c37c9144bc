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

namespace palmer::ui {

/// Colours for which a palette has no role. Light and dark value each.
enum class Token {
    ok, ///< conforms
    okGround,
    bad, ///< does not conform
    badGround,
    unsure, ///< not proven; required statement
    unsureGround,
    explanation,
    accent,
    secondaryText,
    line,
    lineStrong, ///< below the rows of one run
    hover,      ///< ground of what is under the pointer
    up,         ///< ↑ lines and text
    down,       ///< ↓ lines
    downText,   ///< ↓ as text, which needs more contrast
};

/// Whether the palette is a dark one: its text lighter than its ground.
[[nodiscard]] bool isDark(const QPalette &palette);

[[nodiscard]] QColor token(Token token, const QPalette &palette);

/// The ground of what is selected or current.
[[nodiscard]] QColor selectedGround(const QPalette &palette);

/// Sizes of text as factors of the system font.
enum class TextSize { base, small, tiny, head, title };

/// The system's font in one of the sizes; heads and titles are semi-bold.
[[nodiscard]] QFont themeFont(TextSize size);

/// The line icon `:/icons/<name>.svg` in the colour the palette has for `role` at the time it is painted;
/// enabled and disabled, sharp at any device pixel ratio.
[[nodiscard]] QIcon lineIcon(const QString &name, QPalette::ColorRole role = QPalette::WindowText);

/// A button of that icon alone, which the keyboard reaches.
[[nodiscard]] QToolButton *iconButton(QWidget *parent, const QString &objectName, const QString &icon);

/// Draws a line icon centred in `area`, in 16 × 16.
void drawLineIcon(QPainter &painter, const QRect &area, const QString &name, const QColor &colour);

/// The look of the windows: the system's, or one of its own. Kept in the settings of the user.
enum class ThemeChoice { system, light, dark };
[[nodiscard]] ThemeChoice themeChoice();
/// Holds at once.
void setThemeChoice(ThemeChoice choice);

/// Gives a widget a property that the style sheet looks at.
void setStyled(QWidget &widget, const char *property, bool value);

/// Fills the application's one style sheet from its palette, now and whenever the palette changes; the
/// palette is that of the choice. Call once.
void installTheme();

} // namespace palmer::ui
