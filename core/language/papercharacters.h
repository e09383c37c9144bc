// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace palmer {

/// Whether the font of paper (Liberation Sans) has the character; signs that are not seen count as had. What
/// it lacks is drawn from another font where one is installed: what a page says and where it breaks its lines
/// does not depend on that.
[[nodiscard]] bool isOnPaper(char32_t character);

/// The characters of a text that the font of paper lacks, each once, ascending.
[[nodiscard]] std::vector<char32_t> notOnPaper(const QString &text);

/// How wide such a character is set, in sizes of the text.
[[nodiscard]] double foreignWidth(char32_t character);

} // namespace palmer
