// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/decodetext.h"

#include "system/encoding.h"
#include "system/memory.h"
#include "tables/contenterror.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace palmer {

namespace {

constexpr qsizetype sizeLimit = qsizetype(1) << 30;
constexpr std::string_view utf8Mark = "\xEF\xBB\xBF";

// 0x80 … 0x9F; 0: unused.
constexpr std::array<char16_t, 32> windows1252{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append(std::string &text, unsigned code) {
    const auto byte = [&](unsigned value) { text += static_cast<char>(value); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0U | (code >> 6U));
        byte(0x80U | (code & 0x3FU));
    } else if (code < 0x10000) {
        byte(0xE0U | (code >> 12U));
        byte(0x80U | ((code >> 6U) & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    } else {
        byte(0xF0U | (code >> 18U));
        byte(0x80U | ((code >> 12U) & 0x3FU));
        byte(0x80U | ((code >> 6U) & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    }
}

// The first byte that is not UTF-8, or npos.
std::size_t firstInvalid(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    for (std::size_t i = 0; i < text.size();) {
        // Eight bytes at once while plain ASCII.
        std::uint64_t block = 0;
        while (i + sizeof block <= text.size()) {
            std::memcpy(&block, text.data() + i, sizeof block);
            if (block & 0x8080808080808080U)
                break;
            i += sizeof block;
        }
        if (i >= text.size())
            break;
        const unsigned lead = byte(i);
        if (lead < 0x80) {
            ++i;
        } else if (lead >= 0xC2 && lead <= 0xDF && continues(i + 1)) {
            i += 2;
        } else if (lead >= 0xE0 && lead <= 0xEF && (lead != 0xE0 || byte(i + 1) >= 0xA0) &&
                   (lead != 0xED || byte(i + 1) <= 0x9F) && continues(i + 1) && continues(i + 2)) {
            i += 3;
        } else if (lead >= 0xF0 && lead <= 0xF4 && (lead != 0xF0 || byte(i + 1) >= 0x90) &&
                   (lead != 0xF4 || byte(i + 1) <= 0x8F) && continues(i + 1) && continues(i + 2) &&
                   continues(i + 3)) {
            i += 4;
        } else {
            return i;
        }
    }
    return std::string_view::npos;
}

[[noreturn]] void refuse(Text text, std::string_view file, std::size_t at) {
    throw Error(Error::Kind::syntax, {text}, lineAndColumn(file, at));
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
    const auto unit = [&](std::size_t i) {
        const unsigned a = static_cast<unsigned char>(bytes[i]);
        const unsigned b = static_cast<unsigned char>(bytes[i + 1]);
        return bigEndian ? a << 8U | b : b << 8U | a;
    };
    std::string text;
    text.reserve(bytes.size() / 2 + bytes.size() / 16);
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        const unsigned high = i + 1 < bytes.size() ? unit(i) : 0xD800U;
        if (high < 0xD800 || high > 0xDFFF) {
            append(text, high);
            continue;
        }
        const unsigned low = high < 0xDC00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
        if (low < 0xDC00 || low > 0xDFFF)
            refuse(REPORT_TEXT("report", "this is no character of UTF-16; expected a text file"), text,
                   text.size());
        append(text, 0x10000U + ((high - 0xD800U) << 10U) + (low - 0xDC00U));
        i += 2;
    }
    return text;
}

std::string fromWindows1252(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const unsigned code = byte >= 0x80 && byte <= 0x9F ? windows1252[byte - 0x80U] : byte;
        if (code == 0 && byte != 0)
            refuse(REPORT_TEXT("report",
                               "this is no character of UTF-8 nor of Windows-1252; expected a text file"),
                   text, text.size());
        append(text, code);
    }
    return text;
}

// Chinese text: non-ASCII bytes are pairs of GB2312, which has the characters of all common words and units.
// In Western text such letters are usually single, so one pair proves nothing.
bool looksChinese(std::string_view bytes) {
    constexpr std::size_t fewest = 2;
    const auto within = [&](std::size_t i, unsigned low, unsigned high) {
        const auto byte = i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
        return byte >= low && byte <= high;
    };
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (static_cast<unsigned char>(bytes[i]) < 0x80)
            continue;
        if (!within(i, 0xA1, 0xF7) || !within(i + 1, 0xA1, 0xFE))
            return false;
        ++pairs;
        ++i;
    }
    return pairs >= fewest;
}

std::string fromGb18030(std::string_view bytes) {
    const std::optional<QString> text = decodedGb18030(bytes);
    if (!text)
        refuseContent(
            REPORT_TEXT("report", "this system does not know the encoding GB18030; save the text as UTF-8"));
    std::string utf8 = text->toStdString();
    if (const std::size_t wrong = utf8.find("\xEF\xBF\xBD"); wrong != std::string::npos)
        refuse(REPORT_TEXT("report", "this is no character of GB18030; expected a text file"), utf8, wrong);
    return utf8;
}

// Allows no control characters but tab, line breaks, form feed, and at the end the end mark of old systems.
void requireText(std::string &text) {
    if (text.ends_with('\x1A'))
        text.pop_back();
    constexpr unsigned allowed = 1U << '\t' | 1U << '\n' | 1U << '\r' | 1U << '\f';
    const auto isControl = [](char c) {
        const unsigned byte = static_cast<unsigned char>(c);
        return byte < 0x20 && (allowed >> byte & 1U) == 0;
    };
    auto found = text.begin();
    for (std::uint64_t block = 0; text.end() - found >= static_cast<std::ptrdiff_t>(sizeof block);
         found += sizeof block) {
        std::memcpy(&block, &*found, sizeof block);
        // True if one of eight bytes is below 0x20, possibly with false positives, so they are examined.
        const bool suspicious = (block - 0x2020202020202020U) & ~block & 0x8080808080808080U;
        if (suspicious && std::any_of(found, found + sizeof block, isControl))
            break;
    }
    found = std::find_if(found, text.end(), isControl);
    if (found != text.end())
        refuse(REPORT_TEXT("report", "this is binary data; expected a text file, a workbook or an instrument "
                                     "file that can be read"),
               text, static_cast<std::size_t>(found - text.begin()));
}

} // namespace

std::string lineAndColumn(std::string_view text, std::size_t at) {
    at = std::min(at, text.size());
    std::size_t line = 1;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < at; ++i) {
        const bool carriage = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
        if (text[i] == '\n' || carriage) {
            ++line;
            begin = i + 1;
        }
    }
    const auto characters = std::count_if(
        text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(at),
        [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return std::to_string(line) + ':' + std::to_string(characters + 1);
}

DecodedText decodeText(QByteArrayView bytes, std::optional<Encoding> chosen) {
    if (bytes.size() > sizeLimit)
        throw Error(Error::Kind::tooLarge, {REPORT_TEXT("report", "the file is larger than 1 GiB")});
    std::string_view data(bytes.data(), static_cast<std::size_t>(bytes.size()));
    const bool marked8 = data.starts_with(utf8Mark);
    const bool little = data.starts_with("\xFF\xFE");
    const bool big = data.starts_with("\xFE\xFF");
    Choice<Encoding> encoding;
    std::size_t invalid = std::string_view::npos;
    if (little || big) {
        encoding.value = little ? Encoding::utf16LittleEndian : Encoding::utf16BigEndian;
    } else {
        invalid = firstInvalid(data);
        if (invalid != std::string_view::npos)
            encoding = {looksChinese(data) ? Encoding::gb18030 : Encoding::windows1252, Origin::guessed};
    }
    if (chosen)
        encoding = {*chosen, Origin::chosen};
    DecodedText result{{}, encoding};
    switch (encoding.value) {
    case Encoding::utf8:
        data.remove_prefix(marked8 ? utf8Mark.size() : 0);
        if (little || big)
            invalid = 0;
        if (invalid != std::string_view::npos)
            refuse(REPORT_TEXT("report", "this is no character of UTF-8; expected a text file in UTF-8"),
                   data, invalid);
        result.text.reserve(data.size());
        useHugePages(result.text.data(), result.text.capacity());
        result.text = data;
        break;
    case Encoding::utf16LittleEndian:
    case Encoding::utf16BigEndian:
        data.remove_prefix(little || big ? 2 : 0);
        result.text = fromUtf16(data, encoding.value == Encoding::utf16BigEndian);
        break;
    case Encoding::windows1252:
        result.text = fromWindows1252(data);
        break;
    case Encoding::gb18030:
        result.text = fromGb18030(data);
        break;
    }
    requireText(result.text);
    if (withoutBlanks(result.text).empty())
        refuseContent(REPORT_TEXT(
            "report", "the file is empty; expected a table of readings or the file of an instrument"));
    return result;
}

} // namespace palmer
