// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/documenterror.h"
#include "document/json.h"
#include "document/place.h"
#include "document/readinglists.h"
#include "kernel/words/characters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace palmer {

namespace {

using nlohmann::json;

constexpr std::size_t depthLimit = 64;
constexpr std::size_t readingLimit = 10'000'000;
// Limits for memory besides the readings: values of any kind (angles or targets accompany readings), and
// keys, which cost ten times as much.
constexpr std::size_t valueLimit = 30'000'000;
constexpr std::size_t keyLimit = 5'000'000;

// If digits and power of ten are exact doubles, their quotient is the double nearest to the number, without
// the slower std::from_chars.
constexpr std::uint64_t largestExact = std::uint64_t{1} << 53U;
constexpr std::ptrdiff_t mostDigits = 19; // more might overflow
constexpr std::array powersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

// Whole blocks with narrow sums, so that the compiler vectorises.
std::size_t commasIn(std::string_view list) {
    constexpr std::size_t block = 64;
    std::size_t commas = 0;
    for (; list.size() >= block; list.remove_prefix(block)) {
        std::uint8_t here = 0;
        for (std::size_t i = 0; i < block; ++i)
            here = static_cast<std::uint8_t>(here + (list[i] == ',' ? 1 : 0));
        commas += here;
    }
    return commas + static_cast<std::size_t>(std::count(list.begin(), list.end(), ','));
}

// Returns the length of the UTF-8 character at the start (Unicode 15, table 3-7); 0: invalid.
std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto continues = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xBF; };
    const unsigned lead = byte(0);
    if (lead < 0x80)
        return 1;
    if (lead >= 0xC2 && lead <= 0xDF)
        return continues(1) ? 2 : 0;
    if (lead >= 0xE0 && lead <= 0xEF) {
        const bool right = (lead != 0xE0 || byte(1) >= 0xA0) && (lead != 0xED || byte(1) <= 0x9F);
        return right && continues(1) && continues(2) ? 3 : 0;
    }
    if (lead >= 0xF0 && lead <= 0xF4) {
        const bool right = (lead != 0xF0 || byte(1) >= 0x90) && (lead != 0xF4 || byte(1) <= 0x8F);
        return right && continues(1) && continues(2) && continues(3) ? 4 : 0;
    }
    return 0;
}

void appendUtf8(std::string &text, unsigned code) {
    const auto append = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        append(code);
    } else if (code < 0x800) {
        append(0xC0U | (code >> 6U));
        append(0x80U | (code & 0x3FU));
    } else if (code < 0x10000) {
        append(0xE0U | (code >> 12U));
        append(0x80U | ((code >> 6U) & 0x3FU));
        append(0x80U | (code & 0x3FU));
    } else {
        append(0xF0U | (code >> 18U));
        append(0x80U | ((code >> 12U) & 0x3FU));
        append(0x80U | ((code >> 6U) & 0x3FU));
        append(0x80U | (code & 0x3FU));
    }
}

// True if a number outside the range of double is too large, false if too close to zero.
bool isLarge(std::string_view number) {
    const std::size_t mark = number.find_first_of("eE");
    const std::string_view mantissa = number.substr(0, mark);
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos)
        return false;
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    long long exponent = 0;
    if (mark != std::string_view::npos) {
        std::string_view digits = number.substr(mark + 1);
        const bool negative = digits.front() == '-';
        if (negative || digits.front() == '+')
            digits.remove_prefix(1);
        constexpr long long beyond = 1'000'000'000'000; // more digits than a file can have
        if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec != std::errc() ||
            exponent > beyond)
            exponent = beyond;
        if (negative)
            exponent = -exponent;
    }
    return static_cast<long long>(point) - static_cast<long long>(first) + exponent > 0;
}

// The grammar of RFC 8259 with the limits of a test file. Own implementation for error places, duplicate keys
// and speed: ten million readings are a legal file.
class Parser {
public:
    explicit Parser(std::string_view text)
        : m_text(text) {
        if (m_text.substr(0, byteOrderMark.size()) == byteOrderMark)
            m_text.remove_prefix(byteOrderMark.size());
    }

    json parse() {
        json root;
        skipSpace();
        if (current() != '{')
            refuseToken(REPORT_TEXT("report", "“{”"));
        parseValue(root, {}, 0, false);
        skipSpace();
        if (m_at < m_text.size())
            refuseToken(REPORT_TEXT("report", "the end of the file"));
        return root;
    }

private:
    // Returns NUL at the end, as no token begins with it.
    [[nodiscard]] char current() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

    void skipSpace() {
        while (m_at < m_text.size() &&
               (m_text[m_at] == ' ' || m_text[m_at] == '\n' || m_text[m_at] == '\r' || m_text[m_at] == '\t'))
            ++m_at;
    }

    void parseValue(json &value, const Place &place, std::size_t depth, bool readings) {
        if (++m_values > valueLimit)
            refuse(Error::Kind::tooLarge, place,
                   REPORT_TEXT("report", "more values than a test file can have"));
        switch (current()) {
        case '{':
            return parseObject(value, place, depth);
        case '[':
            return parseArray(value, place, depth, readings);
        case '"':
            value = parseString();
            return;
        case 't':
            value = true;
            return parseWord("true");
        case 'f':
            value = false;
            return parseWord("false");
        case 'n':
            return parseWord("null"); // initial value
        default:
            parseNumber(value, place);
        }
    }

    void parseObject(json &value, const Place &place, std::size_t depth) {
        requireDepth(depth, place);
        value = json::object();
        auto &object = value.get_ref<json::object_t &>();
        ++m_at;
        skipSpace();
        if (current() == '}') {
            ++m_at;
            return;
        }
        for (bool first = true;; first = false) {
            skipSpace();
            if (current() != '"')
                refuseToken(first ? REPORT_TEXT("report", "a key in quotation marks or “}”")
                                  : REPORT_TEXT("report", "a key in quotation marks"));
            const auto [member, isNew] = object.emplace(parseString(), nullptr);
            const Place inner(place, member->first);
            if (!isNew)
                refuse(Error::Kind::content, inner,
                       REPORT_TEXT("report", "this key stands here twice; expected it once"));
            if (++m_keys > keyLimit)
                refuse(Error::Kind::tooLarge, inner,
                       REPORT_TEXT("report", "more keys than a test file can have"));
            skipSpace();
            if (current() != ':')
                refuseToken(REPORT_TEXT("report", "“:”"));
            ++m_at;
            skipSpace();
            parseValue(member->second, inner, depth + 1, isListOfReadings(member->first));
            skipSpace();
            if (current() != ',' && current() != '}')
                refuseToken(REPORT_TEXT("report", "“,” or “}”"));
            if (m_text[m_at++] == '}')
                return;
        }
    }

    void parseArray(json &value, const Place &place, std::size_t depth, bool readings) {
        requireDepth(depth, place);
        value = json::array();
        auto &array = value.get_ref<json::array_t &>();
        ++m_at;
        skipSpace();
        if (current() == ']') {
            ++m_at;
            return;
        }
        reserve(array, place, readings);
        for (;;) {
            skipSpace();
            const Place inner(place, array.size());
            if (readings && ++m_readings > readingLimit)
                refuseReadings(inner);
            parseValue(array.emplace_back(), inner, depth + 1, false);
            skipSpace();
            if (current() != ',' && current() != ']')
                refuseToken(REPORT_TEXT("report", "“,” or “]”"));
            if (m_text[m_at++] == ']')
                return;
        }
    }

    // Lists of numbers are counted by their commas: memory is exact, and a list beyond the limit allocates
    // none.
    void reserve(json::array_t &array, const Place &place, bool readings) const {
        if (!isDigit(current()) && current() != '-' && current() != 'n')
            return;
        const std::string_view list = m_text.substr(m_at, m_text.find(']', m_at) - m_at);
        const std::size_t size = commasIn(list) + 1;
        if (readings && size > readingLimit - m_readings)
            refuseReadings(Place(place, readingLimit - m_readings));
        array.reserve(std::min(size, valueLimit - m_values));
    }

    [[noreturn]] static void refuseReadings(const Place &place) {
        refuse(Error::Kind::tooLarge, place,
               REPORT_TEXT("report", "more than 10 000 000 readings or points"));
    }

    static void requireDepth(std::size_t depth, const Place &place) {
        if (depth == depthLimit)
            refuse(Error::Kind::content, place,
                   REPORT_TEXT("report", "nested deeper than a test file can be"));
    }

    void parseWord(std::string_view word) {
        if (tokenLength() != word.size() || m_text.substr(m_at, word.size()) != word)
            refuseToken(REPORT_TEXT("report", "a value"));
        m_at += word.size();
    }

    void parseNumber(json &value, const Place &place) {
        const char *const first = m_text.data() + m_at;
        const char *const end = m_text.data() + m_text.size();
        const char *at = first;
        std::uint64_t digits = 0; // without the point
        const auto stands = [&](char c) { return at < end && *at == c; };
        const auto skipDigits = [&] {
            if (at == end || !isDigit(*at))
                refuseToken(REPORT_TEXT("report", "a value"));
            for (; at < end && isDigit(*at); ++at)
                digits = digits * 10 + static_cast<unsigned>(*at - '0');
        };
        const bool negative = stands('-');
        if (negative)
            ++at;
        if (stands('0'))
            ++at;
        else
            skipDigits();
        const char *const point = at;
        if (stands('.')) {
            ++at;
            skipDigits();
        }
        const bool hasExponent = stands('e') || stands('E');
        // The point but no sign: one more than digits.
        if (!hasExponent && at != point && at - first - (negative ? 1 : 0) <= mostDigits + 1 &&
            digits <= largestExact) {
            const auto decimals = static_cast<std::size_t>(at - point - 1);
            const double size = static_cast<double>(digits) / powersOfTen[decimals];
            value = negative ? -size : size;
        } else {
            if (hasExponent) {
                ++at;
                if (stands('+') || stands('-'))
                    ++at;
                skipDigits();
            }
            convert(value, place, {first, at}, at == point);
        }
        m_at += static_cast<std::size_t>(at - first);
    }

    static void convert(json &value, const Place &place, std::string_view text, bool whole) {
        const char *const first = text.data();
        const char *const last = first + text.size();
        if (whole &&
            (parseWhole<std::int64_t>(value, first, last) || parseWhole<std::uint64_t>(value, first, last)))
            return;
        double number = 0;
        const std::errc error = std::from_chars(first, last, number).ec;
        if (error == std::errc::result_out_of_range || !std::isfinite(number)) {
            if (isLarge(text))
                refuse(Error::Kind::content, place,
                       REPORT_TEXT("report", "this number is too large; expected a finite number"));
            number = 0;
        }
        value = number;
    }

    template <class Whole>
    static bool parseWhole(json &value, const char *first, const char *last) {
        Whole whole = 0;
        if (std::from_chars(first, last, whole).ec != std::errc())
            return false;
        value = whole;
        return true;
    }

    std::string parseString() {
        std::string text;
        const std::size_t begin = m_at++;
        for (std::size_t plain = m_at;;) {
            const char c = current();
            if (m_at >= m_text.size()) {
                m_at = begin;
                refuseHere(
                    REPORT_TEXT("report", "the file ends inside this text; expected a quotation mark"));
            }
            if (c == '"') {
                text.append(m_text, plain, m_at - plain);
                ++m_at;
                return text;
            }
            if (c == '\\') {
                text.append(m_text, plain, m_at - plain);
                appendUtf8(text, parseEscape());
                plain = m_at;
                continue;
            }
            const std::size_t length =
                static_cast<unsigned char>(c) < 0x20 ? 0 : utf8Length(m_text.substr(m_at));
            if (length == 0)
                refuseHere(REPORT_TEXT("report",
                                       "a text cannot hold this character; expected UTF-8 without line "
                                       "breaks and control characters"));
            m_at += length;
        }
    }

    // Parses the character of an escape and moves past it.
    unsigned parseEscape() {
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view characters = "\"\\/\b\f\n\r\t";
        const char letter = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
        const std::size_t simple = letters.find(letter);
        if (simple != std::string_view::npos) {
            m_at += 2;
            return static_cast<unsigned char>(characters[simple]);
        }
        const unsigned high = parseCodeUnit(m_at);
        if (high < 0xD800 || high > 0xDFFF) {
            m_at += 6;
            return high;
        }
        const unsigned low = high < 0xDC00 ? parseCodeUnit(m_at + 6) : 0;
        if (low < 0xDC00 || low > 0xDFFF)
            refuseEscape();
        m_at += 12;
        return 0x10000U + ((high - 0xD800U) << 10U) + (low - 0xDC00U);
    }

    [[nodiscard]] unsigned parseCodeUnit(std::size_t at) const {
        constexpr std::size_t length = 6; // \uXXXX
        const std::string_view escape = m_text.substr(std::min(at, m_text.size()), length);
        unsigned unit = 0;
        if (escape.size() < length || escape.substr(0, 2) != "\\u" ||
            std::from_chars(escape.data() + 2, escape.data() + length, unit, 16).ptr !=
                escape.data() + length)
            refuseEscape();
        return unit;
    }

    [[noreturn]] void refuseEscape() const {
        refuseHere(REPORT_TEXT("report", "unknown escape in a text; expected one that JSON knows"));
    }

    [[noreturn]] static void refuse(Error::Kind kind, const Place &place, Text text) {
        throw Error(kind, {text, {}, {}}, place.text());
    }

    [[noreturn]] void refuseHere(Text text) const {
        throw Error(Error::Kind::syntax, {text, {}, {}}, lineAndColumn());
    }

    [[noreturn]] void refuseToken(Text expected) const {
        if (m_at >= m_text.size())
            throw Error(Error::Kind::syntax,
                        {REPORT_TEXT("report", "the file ends here; expected %1"), {expected}, {}},
                        lineAndColumn());
        if (utf8Length(m_text.substr(m_at)) == 0)
            refuseHere(REPORT_TEXT("report", "this is no character of UTF-8; expected a test file in UTF-8"));
        throw Error(Error::Kind::syntax,
                    {REPORT_TEXT("report", "found “%1”; expected %2"),
                     {excerpt(m_text.substr(m_at, tokenLength())), expected},
                     {}},
                    lineAndColumn());
    }

    // Returns the length of the current token: a mark, or whole characters up to the next mark or space.
    [[nodiscard]] std::size_t tokenLength() const {
        constexpr std::string_view ends = " \t\r\n{}[]:,\"";
        const std::size_t end = std::min(m_text.find_first_of(ends, m_at), m_text.size());
        std::size_t length = 0;
        while (m_at + length < end) {
            const std::size_t character = utf8Length(m_text.substr(m_at + length));
            if (character == 0)
                break;
            length += character;
        }
        return std::max<std::size_t>(length, 1);
    }

    // Returns line:column, both counted from 1, columns in characters.
    [[nodiscard]] std::string lineAndColumn() const {
        std::string_view upTo = m_text.substr(0, m_at);
        const auto line = 1 + std::count(upTo.begin(), upTo.end(), '\n');
        upTo.remove_prefix(upTo.rfind('\n') + 1); // npos + 1 is 0
        const auto column = 1 + std::count_if(upTo.begin(), upTo.end(), [](char c) {
                                return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
                            });
        return std::to_string(line) + ':' + std::to_string(column);
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_values = 0;
    std::size_t m_keys = 0;
    std::size_t m_readings = 0;
};

} // namespace

json parseJson(std::string_view text) {
    return Parser(text).parse();
}

} // namespace palmer
