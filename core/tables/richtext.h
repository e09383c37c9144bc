// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace palmer {

/// The text of a Rich Text Format document in UTF-8: a line per paragraph and table row, tabs between cells.
/// Formats, pictures, fields and notes are ignored. Never fails: anything that is not RTF gives no text.
/// (Microsoft, Rich Text Format Specification, version 1.9.1)
[[nodiscard]] std::string textOfRtf(std::string_view rtf);

/// The text of a source of LaTeX with tables: tabs between their cells, no rules and commands around them;
/// lines keep their numbers. Other text is returned as it is.
[[nodiscard]] std::string textOfLatex(std::string text);

} // namespace palmer
