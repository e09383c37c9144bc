// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/jsonprinter.h"

#include "document/documenterror.h"
#include "language/visibletext.h"
#include "system/memory.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace palmer {

void JsonPrinter::number(double value, const Place &place) {
    if (!std::isfinite(value))
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "a file cannot hold a number that is not finite"), {}, {}},
                    place.text());
    constexpr std::size_t longest = 64;
    char *const begin = room(longest);
    const double size = std::abs(value);
    if (value == 0)
        value = 0; // without a sign
    // Positions and deviations as people write them; an exponent only beyond.
    const bool plain = value == 0 || (size >= 1e-7 && size < 1e15);
    const char *const end = std::to_chars(begin, begin + longest, value,
                                          plain ? std::chars_format::fixed : std::chars_format::scientific)
                                .ptr;
    m_size += static_cast<std::size_t>(end - begin);
}

void JsonPrinter::expect(std::size_t characters) {
    const qsizetype size = std::max(m_text.size(), static_cast<qsizetype>(m_size + characters));
    m_text.reserve(size); // resize() rounds up to a power of two
    m_text.resize(size);
    useHugePages(m_text.constData(), static_cast<std::size_t>(m_text.size()));
}

void JsonPrinter::text(std::string_view utf8) {
    const bool isPlain =
        std::ranges::all_of(utf8, [](char c) { return c >= ' ' && c < '\x7F' && c != '"' && c != '\\'; });
    if (!isPlain) {
        append(withJsonEscapes(
            nlohmann::json(utf8).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
        return;
    }
    append('"');
    append(utf8);
    append('"');
}

void JsonPrinter::object(std::span<const JsonMember> members, const Place &place) {
    const bool isSmall = m_indent > 0 && std::ranges::all_of(members, &JsonMember::isSmall);
    if ((m_oneLine || isSmall || members.empty()) && printOnThisLine(members, place))
        return;
    open('{');
    for (const JsonMember &member : members) {
        if (&member != &members.front()) {
            append(',');
            newLine();
        }
        text(member.key);
        append(": ");
        member.print(*this, Place(place, member.key));
    }
    close('}');
}

bool JsonPrinter::printOnThisLine(std::span<const JsonMember> members, const Place &place) {
    const std::size_t begin = m_size;
    const bool whole = std::exchange(m_oneLine, true);
    append('{');
    for (const JsonMember &member : members) {
        append(&member != &members.front() ? ", " : "");
        text(member.key);
        append(": ");
        member.print(*this, Place(place, member.key));
    }
    append('}');
    m_oneLine = whole;
    if (whole || members.empty() || column() < lineLength)
        return true;
    m_size = begin;
    return false;
}

/// Replaces a character; the text after it moves behind the indentation of the next line.
void JsonPrinter::breakLine(std::size_t at) {
    char *const end = room(m_indent);
    char *const next = m_text.data() + at;
    std::copy_backward(next + 1, end, end + m_indent);
    *next = '\n';
    std::fill_n(next + 1, m_indent, ' ');
    m_size += m_indent;
    m_lineBegin = at + 1;
}

void JsonPrinter::newLine() {
    append('\n');
    m_lineBegin = size();
    std::fill_n(room(m_indent), m_indent, ' ');
    m_size += m_indent;
}

void JsonPrinter::open(char bracket) {
    append(bracket);
    m_indent += indentation;
    newLine();
}

void JsonPrinter::close(char bracket) {
    m_indent -= indentation;
    newLine();
    append(bracket);
}

} // namespace palmer
