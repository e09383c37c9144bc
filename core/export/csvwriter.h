// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace palmer {

/// Rows of a CSV file in UTF-8: cells parted by `;` where the decimal mark is a comma, else by `,`; texts in
/// quotation marks where they have to be, numbers with all their digits, missing ones empty.
class CsvWriter {
public:
    explicit CsvWriter(char mark)
        : m_mark(mark)
        , m_delimiter(mark == ',' ? ';' : ',') {}

    void comment(const std::string &text) {
        std::string line = text;
        std::ranges::replace_if(
            line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
        if (!line.empty())
            m_text += "# " + line + '\n';
    }
    void text(const std::string &cell) {
        begin();
        const bool quote = cell.find_first_of("\"\r\n;,") != std::string::npos;
        if (!quote) {
            m_text += cell;
            return;
        }
        m_text += '"';
        for (const char c : cell)
            m_text += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
        m_text += '"';
    }
    void number(std::optional<double> value) {
        begin();
        if (!value || !std::isfinite(*value))
            return;
        // 0.0002 rather than 2e-04, which spreadsheets take for text under a comma.
        const double size = std::abs(*value);
        const bool plain = size == 0 || (size > 1e-12 && size < 1e15);
        std::array<char, 64> digits{};
        char *const end = std::to_chars(digits.data(), digits.data() + digits.size(), *value,
                                        plain ? std::chars_format::fixed : std::chars_format::general)
                              .ptr;
        std::replace(digits.data(), end, '.', m_mark);
        m_text.append(digits.data(), end);
    }
    void endRow() {
        m_text += '\n';
        m_first = true;
    }
    [[nodiscard]] QByteArray bytes() const { return QByteArray::fromStdString(m_text); }

private:
    void begin() {
        if (!m_first)
            m_text += m_delimiter;
        m_first = false;
    }

    std::string m_text;
    char m_mark;
    char m_delimiter;
    bool m_first = true;
};

} // namespace palmer
