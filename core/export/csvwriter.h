// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/visibletext.h"

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
        std::string line;
        for (const char c : onOneLine(text)) {
            const bool beginsCell = line.ends_with(',') || line.ends_with(';');
            line += beginsCell && looksLikeFormula({c}) ? std::string{'\'', c} : std::string{c};
        }
        if (!line.empty())
            m_text += "# " + line + '\n';
    }
    /// A text that a spreadsheet would take for a formula gets an apostrophe in front.
    void text(const std::string &cell) {
        begin();
        m_text += quoted(looksLikeFormula(cell) ? '\'' + cell : cell);
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
    static bool looksLikeFormula(const std::string &cell) {
        double number = 0;
        const char *const end = cell.data() + cell.size();
        if (std::from_chars(cell.data(), end, number).ptr == end)
            return false; // a text that is a number stays one
        return cell.starts_with("\u2212") || cell.find_first_of("=+-@\t") == 0;
    }

    static std::string onOneLine(const std::string &text) {
        return visibleText(QString::fromStdString(text)).replace(u'\n', u' ').toStdString();
    }

    /// On one line, in quotation marks where it has to be.
    static std::string quoted(const std::string &cell) {
        const std::string line = onOneLine(cell);
        if (line.find_first_of("\";,") == std::string::npos)
            return line;
        std::string result = "\"";
        for (const char c : line)
            result += c == '"' ? std::string("\"\"") : std::string(1, c);
        return result + '"';
    }

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
