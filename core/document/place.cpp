// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/place.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace palmer {

namespace {

constexpr std::size_t excerptLength = 60; // of a key or word
constexpr std::size_t placeLength = 200;

bool continuesCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// Never splits a UTF-8 character.
void cut(std::string &text, std::size_t length) {
    if (text.size() <= length)
        return;
    while (length > 0 && continuesCharacter(text[length]))
        --length;
    text.resize(length);
    text += "…";
}

bool isIdentifier(std::string_view key) {
    return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

} // namespace

void Place::append(std::string &text) const {
    if (!m_parent)
        return;
    m_parent->append(text);
    if (m_index != noIndex)
        text += '[' + std::to_string(m_index) + ']';
    else if (!isIdentifier(m_key))
        text += "[\"" + excerpt(m_key) + "\"]";
    else
        text += (text.empty() ? "" : ".") + excerpt(m_key);
}

std::string Place::text() const {
    std::string text;
    append(text);
    cut(text, placeLength);
    return text;
}

std::string excerpt(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, std::min(text.size(), 2 * excerptLength))) {
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) {
            constexpr std::string_view digits = "0123456789abcdef";
            const auto code = static_cast<unsigned char>(c);
            result += "\\u00";
            result += digits[code >> 4U];
            result += digits[code & 0xFU];
        } else {
            result += c;
        }
    }
    cut(result, excerptLength);
    return result;
}

} // namespace palmer
