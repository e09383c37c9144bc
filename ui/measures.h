// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::ui {

// Of pages, forms and tables, in pixels of a screen of 96 dpi.

// What pages, dialogs and the register have alike, pixels.
inline constexpr int pageMargin = 16;
inline constexpr int pageBarHeight = 44;  ///< above a page
inline constexpr int fieldHeight = 28;    ///< of one line
inline constexpr int tableRowHeight = 26; ///< that is read and typed in
inline constexpr int tablePadding = 6;    ///< left and right of the text of a quiet table

} // namespace palmer::ui
