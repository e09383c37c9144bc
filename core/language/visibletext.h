// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace palmer {

// A text in a file may contain characters that control a terminal or reverse the order of the text around
// them: control characters and the directional marks of Unicode (UAX #9). No output contains them raw.

/// Returns the text with invisible characters shown: "‹U+001B›". Keeps line breaks, tabs become blanks.
[[nodiscard]] QString visibleText(const QString &text);

/// The same for UTF-8.
[[nodiscard]] QByteArray visibleText(const QByteArray &utf8);

/// Returns the text for a cell, visible and on one line, that no spreadsheet takes for a formula: a text that
/// looks like one gets an apostrophe in front, numbers are unchanged.
[[nodiscard]] QString cellText(const QString &text);

/// Returns JSON in UTF-8 with these characters as escapes: "\u202e".
[[nodiscard]] std::string withJsonEscapes(std::string json);

} // namespace palmer
