// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/remark.h"

#include "document/place.h"
#include "tables/numbercell.h"

#include <algorithm>

namespace palmer {

void QuotedLines::add(std::size_t line, std::string_view text, std::string_view sheet) {
    constexpr std::size_t longest = 16'000; // bytes of all
    ++m_count;
    if (m_quoted.size() > longest)
        return;
    m_quoted += m_count > 1 ? "; " : "";
    if (!sheet.empty())
        m_quoted += excerpt(sheet) + ' ';
    std::string shown(withoutBlanks(text));
    std::ranges::replace_if(
        shown, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
    m_quoted += std::to_string(line) + ": " + shown;
    if (m_quoted.size() > longest)
        m_quoted += "; …";
}

void QuotedLines::remarkUsed(Remarks &remarks) const {
    if (m_count > 0)
        remarks.note({}, REPORT_TEXT("report", "Statements that were read: %1 (%2)."), counted(m_count),
                     m_quoted);
}

void QuotedLines::remarkUnused(Remarks &remarks) const {
    if (m_count > 0)
        remarks.note({}, REPORT_TEXT("report", "Lines of text that were not used: %1 (%2)."),
                     counted(m_count), m_quoted);
}

} // namespace palmer
