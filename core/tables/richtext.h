// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace palmer {

/// The text of a document in Rich Text Format, in UTF-8: a line for each paragraph and row of a table, tabs
/// between cells. Formats, pictures, fields and notes say nothing. Never fails: what is no RTF has no text.
/// (Microsoft, Rich Text Format Specification, version 1.9.1)
[[nodiscard]] std::string textOfRtf(std::string_view rtf);

} // namespace palmer
