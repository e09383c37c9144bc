// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/visibletext.h"

#include <QByteArray>
#include <QStringList>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace palmer {

/// Writes rows of a CSV file in UTF-8: cells separated by `;` if the decimal mark is a comma, otherwise by
/// `,`; texts quoted if necessary, numbers with all their digits, missing ones empty.
class CsvWriter {
public:
    explicit CsvWriter(char mark)
        : m_mark(mark)
        , m_delimiter(mark == ',' ? ';' : ',') {}

    /// Text after a separator would be a cell of its own in a spreadsheet.
    void comment(const std::string &text) {
        QStringList cells =
            visibleText(QString::fromStdString(text)).replace(u'\n', u' ').split(QLatin1Char(m_delimiter));
        for (qsizetype i = 1; i < cells.size(); ++i)
            cells[i] = cellText(cells[i]);
        if (!text.empty())
            m_text += "# " + cells.join(QLatin1Char(m_delimiter)).toStdString() + '\n';
    }
    /// A line with a key and its value: a number, otherwise a text or a JSON literal.
    void statement(const std::string &key, const std::string &value, std::optional<double> numeric = {}) {
        text("# " + key);
        if (numeric)
            number(numeric);
        else
            text(value);
        endRow();
    }
    void text(const std::string &cell) {
        begin();
        QString text = cellText(QString::fromStdString(cell));
        if (text.contains(u'"') || text.contains(u',') || text.contains(u';'))
            text = u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
        m_text += text.toStdString();
    }
    void number(std::optional<double> value) {
        begin();
        if (!value || !std::isfinite(*value))
            return;
        // 0.0002 rather than 2e-04, which spreadsheets take for text if the decimal mark is a comma.
        const double size = std::abs(*value);
        const bool plain = size == 0 || (size > 1e-12 && size < 1e15);
        std::array<char, 64> digits{};
        char *const end = std::to_chars(digits.data(), digits.data() + digits.size(), *value,
                                        plain ? std::chars_format::fixed : std::chars_format::general)
                              .ptr;
        std::replace(digits.data(), end, '.', m_mark);
        m_text.append(digits.data(), end);
    }
    /// Texts and numbers, in their order.
    template <class... Cells>
    void cells(const Cells &...values) {
        (cell(values), ...);
    }
    template <class... Cells>
    void row(const Cells &...values) {
        cells(values...);
        endRow();
    }
    void endRow() {
        m_text += '\n';
        m_first = true;
    }
    [[nodiscard]] QByteArray bytes() const { return QByteArray::fromStdString(m_text); }

private:
    void cell(const std::string &value) { text(value); }
    void cell(std::optional<double> value) { number(value); }
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
