// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::ui {

// Sizes shared by pages, dialogs, forms, tables and the register, in pixels at 96 dpi.
inline constexpr int pageMargin = 16;
inline constexpr int pageBarHeight = 44;  ///< above a page, with its tools or title
inline constexpr int fieldHeight = 28;    ///< one line
inline constexpr int tableRowHeight = 26; ///< in tables to read and type in
inline constexpr int tablePadding = 6;    ///< left and right of the text in quiet tables

} // namespace palmer::ui
