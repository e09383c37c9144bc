// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/encoding.h"

#include <algorithm>
#include <windows.h>

namespace palmer {

namespace {

QString decoded(unsigned codePage, std::string_view line) {
    const auto size = static_cast<int>(line.size());
    std::wstring wide(line.size(), L'\0'); // never longer
    const int length =
        MultiByteToWideChar(codePage, MB_ERR_INVALID_CHARS, line.data(), size, wide.data(), size);
    return length > 0 || line.empty() ? QString::fromWCharArray(wide.data(), length)
                                      : QString(QChar::ReplacementCharacter);
}

} // namespace

std::optional<QString> decodedGb18030(std::string_view bytes) {
    constexpr unsigned gb18030 = 54936;
    constexpr unsigned gbk = 936;
    const unsigned codePage = IsValidCodePage(gb18030) ? gb18030 : gbk;
    if (!IsValidCodePage(codePage))
        return std::nullopt;
    QString text;
    for (std::size_t from = 0; from < bytes.size();) { // no character holds the byte of a line break
        const std::size_t end = std::min(bytes.find('\n', from), bytes.size() - 1) + 1;
        text += decoded(codePage, bytes.substr(from, end - from));
        from = end;
    }
    return text;
}

} // namespace palmer
