// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "tables/choice.h"

#include <QByteArrayView>
#include <optional>
#include <string>

namespace palmer {

enum class Encoding { utf8, utf16LittleEndian, utf16BigEndian, windows1252, gb18030 };

/// A text file as UTF-8, without byte order mark.
struct DecodedText {
    std::string text;
    Choice<Encoding> encoding;
};

/// Decodes bytes: UTF-16 by its byte order mark; UTF-8 if valid; otherwise a guess: GB18030 (GBK) if all
/// non-ASCII bytes are pairs of Chinese characters and signs, or Windows-1252. `chosen` overrides this.
/// Throws Error for no data, binary data (with line and column), bytes invalid in the chosen encoding, and
/// more than 1 GiB.
[[nodiscard]] DecodedText decodeText(QByteArrayView bytes, std::optional<Encoding> chosen = {});

/// `line:column` of a byte in a text, both from 1; columns count characters.
[[nodiscard]] std::string lineAndColumn(std::string_view text, std::size_t at);

} // namespace palmer
