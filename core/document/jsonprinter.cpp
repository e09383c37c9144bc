// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/jsonprinter.h"

#include "document/documenterror.h"
#include "document/largepages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

/// The digits of a number with at most seven decimals, as those of readings, or null: a whole number of such
/// parts below 10¹⁵ is the shortest decimal that says the double nearest to it.
char *printParts(double size, char *text) {
    constexpr double parts = 1e7;
    constexpr std::ptrdiff_t decimals = 7;
    const double whole = std::nearbyint(size * parts);
    if (!(whole < 1e15) || whole / parts != size)
        return nullptr;
    std::array<char, 24> digits{};
    const char *const end =
        std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<std::uint64_t>(whole)).ptr;
    const std::ptrdiff_t zeros = std::max<std::ptrdiff_t>(decimals + 1 - (end - digits.data()), 0);
    char *at = std::fill_n(text, zeros, '0');
    at = std::copy(static_cast<const char *>(digits.data()), end, at);
    std::copy_backward(at - decimals, at, at + 1);
    at[-decimals] = '.';
    while (*at == '0')
        --at;
    return *at == '.' ? at : at + 1;
}

} // namespace

void JsonPrinter::number(double value, const Place &place) {
    if (!std::isfinite(value))
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "a file cannot hold a number that is not finite"), {}, {}},
                    place.text());
    std::array<char, 64> digits{};
    const double size = std::abs(value);
    if (char *const end = printParts(size, digits.data() + 1)) {
        digits[0] = '-';
        const std::ptrdiff_t first = value < 0 ? 0 : 1;
        append(digits.data() + first, end);
        return;
    }
    // Positions and deviations as people write them; an exponent only beyond.
    const bool plain = size >= 1e-7 && size < 1e15;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific);
    append(digits.data(), end.ptr);
}

void JsonPrinter::expect(std::size_t characters) {
    m_text.reserve(m_text.size() + static_cast<qsizetype>(characters));
    inLargePages(m_text.constData(), static_cast<std::size_t>(m_text.capacity()));
}

void JsonPrinter::text(std::string_view utf8) {
    const bool isPlain =
        std::ranges::all_of(utf8, [](char c) { return c >= ' ' && c < '\x7F' && c != '"' && c != '\\'; });
    if (!isPlain) {
        append(nlohmann::json(utf8).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
        return;
    }
    m_text += '"';
    append(utf8);
    m_text += '"';
}

void JsonPrinter::object(std::span<const JsonMember> members, const Place &place) {
    const bool isSmall = m_indent > 0 && std::ranges::all_of(members, &JsonMember::isSmall);
    if ((m_oneLine || isSmall || members.empty()) && printOnThisLine(members, place))
        return;
    open('{');
    for (const JsonMember &member : members) {
        if (&member != &members.front()) {
            m_text += ',';
            newLine();
        }
        text(member.key);
        append(": ");
        member.print(*this, Place(place, member.key));
    }
    close('}');
}

bool JsonPrinter::printOnThisLine(std::span<const JsonMember> members, const Place &place) {
    const qsizetype begin = m_text.size();
    const bool whole = std::exchange(m_oneLine, true);
    m_text += '{';
    for (const JsonMember &member : members) {
        append(&member != &members.front() ? ", " : "");
        text(member.key);
        append(": ");
        member.print(*this, Place(place, member.key));
    }
    m_text += '}';
    m_oneLine = whole;
    if (whole || members.empty() || column() < lineLength)
        return true;
    m_text.resize(begin);
    return false;
}

void JsonPrinter::newLine() {
    m_text += '\n';
    m_lineBegin = size();
    m_text.append(static_cast<qsizetype>(m_indent), ' ');
}

void JsonPrinter::open(char bracket) {
    m_text += bracket;
    m_indent += indentation;
    newLine();
}

void JsonPrinter::close(char bracket) {
    m_indent -= indentation;
    newLine();
    m_text += bracket;
}

} // namespace palmer
