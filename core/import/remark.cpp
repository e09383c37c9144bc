// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/remark.h"

#include "document/place.h"
#include "tables/numbercell.h"

namespace palmer {

void QuotedLines::add(std::size_t line, std::string_view text) {
    constexpr std::size_t mostQuoted = 5;
    constexpr std::size_t longest = 40; // bytes, shortened to whole characters
    if (++m_count > mostQuoted + 1)
        return;
    m_quoted += m_count > 1 ? "; " : "";
    if (m_count > mostQuoted) {
        m_quoted += "…";
        return;
    }
    std::string quoted = excerpt(withoutBlanks(text));
    if (quoted.size() > longest) {
        std::size_t end = longest;
        while ((static_cast<unsigned char>(quoted[end]) & 0xC0U) == 0x80U)
            --end;
        quoted.resize(end);
        quoted += "…";
    }
    m_quoted += std::to_string(line) + ": " + quoted;
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
