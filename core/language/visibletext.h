// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace palmer {

// A text of a file may hold what steers a terminal or turns the order of the characters around it: control
// characters, and the marks of direction of Unicode (UAX #9). No output has them raw.

/// The text with what is not seen in it made seen: "‹U+001B›". Line breaks stay, tabulators are blanks.
[[nodiscard]] QString visibleText(const QString &text);

/// The same of UTF-8.
[[nodiscard]] QByteArray visibleText(const QByteArray &utf8);

/// The text of a cell, seen and on one line, that no spreadsheet takes for a formula: one that begins as such
/// gets an apostrophe in front, a number stays one.
[[nodiscard]] QString cellText(const QString &text);

/// JSON in UTF-8 with them as its escapes: "\u202e".
[[nodiscard]] std::string withJsonEscapes(std::string json);

} // namespace palmer
