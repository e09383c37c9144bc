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

/// The text that bytes stand for: UTF-16 by its byte order mark; UTF-8 where the bytes are valid UTF-8;
/// GB18030 (GBK) where all that is not ASCII are pairs of bytes of Chinese characters and signs, Windows-1252
/// else, which are guesses. `chosen` overrules the bytes. Throws Error: nothing there, binary
/// data (with line and column), bytes the chosen encoding does not know, more than 1 GiB.
[[nodiscard]] DecodedText decodeText(QByteArrayView bytes, std::optional<Encoding> chosen = {});

/// `line:column` of a byte of a text, both from 1; columns count characters.
[[nodiscard]] std::string lineAndColumn(std::string_view text, std::size_t at);

} // namespace palmer
