// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/numbercell.h"

#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>

namespace palmer {

namespace {

// Exact in double: an integer below 2^53 multiplied or divided by one of these is rounded once.
constexpr std::array powersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t exactWhole = std::uint64_t(1) << 53U;
constexpr std::ptrdiff_t mostScale = powersOfTen.size() - 1;
constexpr std::ptrdiff_t mostDigits = 18; // always fit into 64 bits
constexpr std::size_t longestNumber = 400;

// U+2212 minus, en dash, hyphens, and their small and full-width forms.
constexpr std::array<std::string_view, 6> minusSigns{"\u2212", "\u2013", "\u2010",
                                                     "\u2011", "\uFE63", "\uFF0D"};

// No-break space, narrow no-break space, thin space, figure space.
constexpr std::array<std::string_view, 4> wideBlanks{"\u00A0", "\u202F", "\u2009", "\u2007"};

constexpr std::array<std::string_view, 23> missingWords{
    "na",     "n/a",    "n.a.",   "null", "none", "nil", "missing", "manquant", "-",   "--",  "---", "\u2013",
    "\u2014", "\u2212", "\u2026", "...",  "*",    "?",   "x",       "#n/a",     "#nv", "#na", "void"};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::size_t signLength(std::string_view text, bool &negative) {
    negative = false;
    if (text.empty())
        return 0;
    if (text[0] == '-' || text[0] == '+') {
        negative = text[0] == '-';
        return 1;
    }
    if (static_cast<unsigned char>(text[0]) < 0x80)
        return 0;
    for (const std::string_view sign : minusSigns) {
        if (text.starts_with(sign)) {
            negative = true;
            return sign.size();
        }
    }
    return 0;
}

// True if a text that is not a value consists of characters of numbers.
bool looksLikeNumber(std::string_view text) {
    bool digit = false;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (isDigit(c)) {
            digit = true;
            ++i;
        } else if (c == '.' || c == ',' || c == '\'' || c == ' ' || c == '+' || c == '-' ||
                   ((c == 'e' || c == 'E') && digit)) {
            ++i;
        } else {
            const std::string_view rest = text.substr(i);
            const auto begins = [&](std::string_view sign) { return rest.starts_with(sign); };
            const auto *const sign = std::ranges::find_if(minusSigns, begins);
            const auto *const blank = std::ranges::find_if(wideBlanks, begins);
            if (sign == minusSigns.end() && blank == wideBlanks.end())
                return false;
            i += sign != minusSigns.end() ? sign->size() : blank->size();
        }
    }
    return digit;
}

// Digits in groups of three, or a number with the other mark, which another convention would read.
bool isGrouped(std::string_view text, DecimalMark mark) {
    const DecimalMark other = mark == DecimalMark::point ? DecimalMark::comma : DecimalMark::point;
    if (leadingNumber(text, other).size == text.size())
        return true;
    std::string joined;
    std::size_t groups = 0;
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view rest = text.substr(i);
        const auto *const blank =
            std::ranges::find_if(wideBlanks, [&](std::string_view wide) { return rest.starts_with(wide); });
        const std::size_t separator = blank != wideBlanks.end() ? blank->size()
                                      : std::string_view(".,' ").find(rest[0]) != std::string_view::npos ? 1
                                                                                                         : 0;
        const bool group = separator > 0 && rest.size() >= separator + 3 && !joined.empty() &&
                           isDigit(joined.back()) &&
                           std::all_of(rest.begin() + static_cast<std::ptrdiff_t>(separator),
                                       rest.begin() + static_cast<std::ptrdiff_t>(separator) + 3, isDigit) &&
                           (rest.size() == separator + 3 || !isDigit(rest[separator + 3]));
        if (group) {
            joined.append(rest.substr(separator, 3));
            i += separator + 3;
            ++groups;
        } else {
            joined += rest[0];
            ++i;
        }
    }
    if (groups == 0)
        return false;
    return leadingNumber(joined, mark).size == joined.size() ||
           leadingNumber(joined, other).size == joined.size();
}

/// The number without the signs between its thousands: "1 000,5", "1'000", with both marks "1.000,5"; empty
/// if they do not stand so.
std::string withoutThousands(std::string_view text, DecimalMark mark) {
    const char point = mark == DecimalMark::point ? '.' : ',';
    const char comma = mark == DecimalMark::point ? ',' : '.';
    const bool hasBoth = text.find(point) != std::string_view::npos;
    std::string joined;
    std::size_t digits = 0; // since the last blank
    std::size_t blanks = 0;
    bool isWhole = true;
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view rest = text.substr(i);
        const auto *const wide =
            std::ranges::find_if(wideBlanks, [&](std::string_view each) { return rest.starts_with(each); });
        const bool isSign = rest[0] == ' ' || rest[0] == '\'' || (hasBoth && rest[0] == comma);
        const std::size_t blank = wide != wideBlanks.end() ? wide->size() : isSign ? 1 : 0;
        if (blank > 0) {
            if (digits == 0 || digits > 3 || (blanks > 0 && digits != 3) || !isWhole)
                return {};
            ++blanks;
            digits = 0;
            i += blank;
            continue;
        }
        if (isWhole && isDigit(rest[0]))
            ++digits;
        else if (digits > 0) {
            if (blanks > 0 && digits != 3)
                return {};
            isWhole = false;
        }
        joined += rest[0];
        ++i;
    }
    const std::size_t first = joined.find_first_of("0123456789");
    const bool isGroupedWell = blanks > 0 && (!isWhole || digits == 3) && first != std::string::npos;
    return isGroupedWell && joined[first] != '0' ? joined : std::string();
}

} // namespace

std::string lowerCase(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), lower);
    return result;
}

std::string upperCase(std::string_view text) {
    std::string result(text);
    for (char &c : result)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return result;
}

bool sameWord(std::string_view a, std::string_view b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view withoutBlanks(std::string_view text) {
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    for (bool again = true; again;) {
        again = false;
        while (!text.empty() && isBlank(text.front()))
            text.remove_prefix(1);
        while (!text.empty() && isBlank(text.back()))
            text.remove_suffix(1);
        if (text.empty() || (static_cast<unsigned char>(text.front()) < 0x80 &&
                             static_cast<unsigned char>(text.back()) < 0x80))
            return text;
        for (const std::string_view blank : wideBlanks) {
            if (text.starts_with(blank)) {
                text.remove_prefix(blank.size());
                again = true;
            }
            if (text.ends_with(blank)) {
                text.remove_suffix(blank.size());
                again = true;
            }
        }
    }
    return text;
}

namespace {

// Parses a number of any length whose syntax has been checked. NaN outside the range of double.
double valueOf(std::string_view number, char point, bool large) {
    std::array<char, longestNumber> plain{};
    std::size_t size = 0;
    for (std::size_t i = 0; i < number.size();) {
        bool minus = false;
        const std::size_t sign = signLength(number.substr(i), minus);
        if (sign > 0) { // of the exponent
            if (minus)
                plain[size++] = '-';
            i += sign;
        } else {
            plain[size++] = number[i] == point ? '.' : number[i];
            ++i;
        }
    }
    double value = 0;
    const auto read = std::from_chars(plain.data(), plain.data() + size, value);
    if (read.ec == std::errc() && std::isfinite(value))
        return value;
    // Underflow gives zero.
    return read.ec == std::errc::result_out_of_range && !large ? 0 : std::nan("");
}

inline void consumeDigits(const char *&at, const char *end, std::uint64_t &number) {
    for (; at != end && isDigit(*at); ++at)
        number = number * 10 + static_cast<std::uint64_t>(*at - '0');
}

/// Reads "e-3" there; 0 without advancing if there is none.
inline std::ptrdiff_t consumeExponent(const char *&at, const char *end) {
    if (at == end || (*at != 'e' && *at != 'E'))
        return 0;
    bool down = false;
    const char *digit = at + 1;
    digit += signLength({digit, static_cast<std::size_t>(end - digit)}, down);
    if (digit == end || !isDigit(*digit))
        return 0;
    std::ptrdiff_t exponent = 0;
    for (at = digit; at != end && isDigit(*at); ++at)
        exponent = std::min<std::ptrdiff_t>(exponent * 10 + (*at - '0'), 100'000);
    return down ? -exponent : exponent;
}

} // namespace

LeadingNumber leadingNumber(std::string_view text, DecimalMark mark) {
    const char point = mark == DecimalMark::point ? '.' : ',';
    const char *const begin = text.data();
    const char *const end = begin + text.size();
    const char *at = begin;
    bool negative = false;
    if (at != end && !isDigit(*at))
        at += signLength(text, negative);
    const char *const first = at;
    std::uint64_t whole = 0; // unused after an overflow
    consumeDigits(at, end, whole);
    std::ptrdiff_t digits = at - first;
    const std::ptrdiff_t wholes = digits;
    std::ptrdiff_t decimals = 0;
    if (at != end && *at == point) {
        const char *const firstDecimal = ++at;
        consumeDigits(at, end, whole);
        decimals = at - firstDecimal;
        digits += decimals;
    }
    if (digits == 0)
        return {};
    const std::ptrdiff_t exponent = consumeExponent(at, end);
    const std::ptrdiff_t scale = exponent - decimals;
    double value = 0;
    if (digits <= mostDigits && whole <= exactWhole && scale <= mostScale && scale >= -mostScale) {
        value = static_cast<double>(whole);
        value = scale < 0 ? value / powersOfTen[static_cast<std::size_t>(-scale)]
                          : value * powersOfTen[static_cast<std::size_t>(scale)];
    } else {
        if (at - first > static_cast<std::ptrdiff_t>(longestNumber))
            return {};
        value = valueOf({first, static_cast<std::size_t>(at - first)}, point, exponent + wholes > 0);
        if (std::isnan(value))
            return {};
    }
    return {negative ? -value : value, static_cast<std::size_t>(at - begin)};
}

CellValue readCell(std::string_view cell, DecimalMark mark) {
    cell = withoutBlanks(cell);
    if (cell.empty())
        return {CellKind::empty};
    const LeadingNumber number = leadingNumber(cell, mark);
    if (number.size == cell.size())
        return {CellKind::number, number.value};
    if (std::ranges::any_of(missingWords, [&](std::string_view word) { return sameWord(cell, word); }))
        return {CellKind::missing};
    if (cell.starts_with('-') && cell.find_first_not_of("-.") == std::string_view::npos) // "--.-"
        return {CellKind::missing};
    // "#DIV/0!" of a spreadsheet; "****", "####" where a number is wider than its column.
    if ((cell.size() > 2 && cell.front() == '#' && (cell.back() == '!' || cell.back() == '?')) ||
        (cell.size() > 1 && cell.find_first_not_of(cell.front()) == std::string_view::npos &&
         (cell.front() == '*' || cell.front() == '#')))
        return {CellKind::broken};
    for (const std::string_view word :
         {"nan", "-nan", "inf", "-inf", "+inf", "infinity", "-infinity", "\u221E", "-\u221E"}) {
        if (sameWord(cell, word))
            return {CellKind::broken};
    }
    if (!looksLikeNumber(cell))
        return {CellKind::text};
    if (const std::string joined = withoutThousands(cell, mark); !joined.empty()) {
        const LeadingNumber whole = leadingNumber(joined, mark);
        if (whole.size == joined.size())
            return {CellKind::number, whole.value};
    }
    return {isGrouped(cell, mark) ? CellKind::grouped : CellKind::broken};
}

} // namespace palmer
