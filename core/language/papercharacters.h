// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace palmer {

/// True if the font of the report (Liberation Sans) has the character; invisible characters count as present.
/// Missing ones are drawn from another font if one is installed; text and line breaks of a page do not depend
/// on that.
[[nodiscard]] bool isOnPaper(char32_t character);

/// Returns the characters of a text missing in the font of the report, each once, ascending.
[[nodiscard]] std::vector<char32_t> notOnPaper(const QString &text);

/// Returns the width of such a character, relative to the text size.
[[nodiscard]] double foreignWidth(char32_t character);

} // namespace palmer
