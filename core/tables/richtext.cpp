// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/richtext.h"

#include "tables/decodetext.h"

#include <QString>
#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace palmer {

namespace {

/// Control words that represent text.
struct ControlWord {
    std::string_view word;
    const char *text = nullptr;
};
constexpr std::array controlWords{
    ControlWord{"par", "\n"},
    ControlWord{"row", "\n"},
    ControlWord{"nestrow", "\n"},
    ControlWord{"line", " "},
    ControlWord{"sect", "\n"},
    ControlWord{"page", "\n"},
    ControlWord{"cell", "\t"},
    ControlWord{"nestcell", "\t"},
    ControlWord{"tab", "\t"},
    ControlWord{"emdash", "\u2014"},
    ControlWord{"endash", "\u2013"},
    ControlWord{"bullet", "\u2022"},
    ControlWord{"lquote", "\u2018"},
    ControlWord{"rquote", "\u2019"},
    ControlWord{"ldblquote", "\u201C"},
    ControlWord{"rdblquote", "\u201D"},
    ControlWord{"~", "\u00A0"},
    ControlWord{"_", "-"},
    ControlWord{"{", "{"},
    ControlWord{"}", "}"},
    ControlWord{"\\", "\\"},
    ControlWord{"\n", "\n"},
    ControlWord{"\r", "\n"},
};

constexpr std::array<std::string_view, 10> silentGroups{
    "fonttbl", "colortbl", "stylesheet", "info", "pict", "header", "footer", "footnote", "object", "fldinst"};

class Rtf {
public:
    explicit Rtf(std::string_view rtf)
        : m_rtf(rtf) {}

    std::string text() {
        if (!m_rtf.starts_with("{\\rtf"))
            return {};
        while (m_at < m_rtf.size())
            step();
        flush();
        return std::move(m_text);
    }

private:
    struct Group {
        bool isSilent = false;
        int skipped = 1; ///< characters after each \u that replace it in older programs
    };

    void step() {
        const char c = m_rtf[m_at++];
        switch (c) {
        case '{':
            m_groups.push_back(m_group);
            break;
        case '}':
            if (!m_groups.empty()) {
                m_group = m_groups.back();
                m_groups.pop_back();
            }
            break;
        case '\\':
            control();
            break;
        case '\r':
        case '\n':
            break;
        default:
            put(c);
        }
    }

    void control() {
        if (m_at >= m_rtf.size())
            return;
        if (m_rtf[m_at] == '\'') {
            unsigned code = 0;
            const std::string_view hex = m_rtf.substr(m_at + 1, 2);
            std::from_chars(hex.data(), hex.data() + hex.size(), code, 16);
            m_at = std::min(m_at + 3, m_rtf.size());
            if (hex.size() == 2)
                put(static_cast<char>(code));
            return;
        }
        const std::size_t begin = m_at;
        while (m_at < m_rtf.size() && m_rtf[m_at] >= 'a' && m_rtf[m_at] <= 'z')
            ++m_at;
        const bool isWord = m_at > begin;
        if (!isWord)
            ++m_at; // a control symbol, without parameter
        const std::string_view word = m_rtf.substr(begin, m_at - begin);
        int number = 0;
        const auto [end, error] = std::from_chars(m_rtf.data() + m_at, m_rtf.data() + m_rtf.size(), number);
        if (isWord && error == std::errc())
            m_at = static_cast<std::size_t>(end - m_rtf.data());
        if (isWord && m_at < m_rtf.size() && m_rtf[m_at] == ' ')
            ++m_at;
        obey(word, number);
    }

    void obey(std::string_view word, int number) {
        if (word == "*" || std::ranges::find(silentGroups, word) != silentGroups.end()) {
            m_group.isSilent = true;
        } else if (word == "uc") {
            m_group.skipped = std::clamp(number, 0, 9);
        } else if (word == "u") {
            flush();
            if (!m_group.isSilent)
                m_utf16 += QChar(static_cast<char16_t>(number));
            m_toSkip = m_group.skipped;
        } else if (word == "bin") {
            m_at = std::min(m_at + static_cast<std::size_t>(std::max(number, 0)), m_rtf.size());
        } else if (const auto *sign = std::ranges::find(controlWords, word, &ControlWord::word);
                   sign != controlWords.end()) {
            m_toSkip = 0;
            if (m_group.isSilent)
                return;
            flush();
            if (word.ends_with("row") && m_text.ends_with('\t'))
                m_text.pop_back(); // after the last cell
            m_text += sign->text;
        }
    }

    void put(char c) {
        if (m_toSkip > 0) {
            --m_toSkip;
        } else if (!m_group.isSilent) {
            if (!m_utf16.isEmpty())
                flush();
            m_bytes += c;
        }
    }

    void flush() {
        if (!m_bytes.empty()) {
            try {
                m_text += decodeText(m_bytes, Encoding::windows1252).text;
            } catch (const Error &) { // ignores bytes that are not characters
            }
            m_bytes.clear();
        }
        m_text += m_utf16.toStdString();
        m_utf16.clear();
    }

    std::string_view m_rtf;
    std::size_t m_at = 0;
    Group m_group;
    std::vector<Group> m_groups;
    int m_toSkip = 0;
    std::string m_bytes; ///< in Windows-1252, not yet appended
    QString m_utf16;     ///< not yet appended
    std::string m_text;
};

} // namespace

std::string textOfRtf(std::string_view rtf) {
    return Rtf(rtf).text();
}

namespace {

/// A command and what it prints; empty for one that only forms.
struct LatexCommand {
    std::string_view name;
    std::string_view text;
};

constexpr std::array latexCommands{
    LatexCommand{"mu", "µ"},          LatexCommand{"micro", "µ"},
    LatexCommand{"textmu", "µ"},      LatexCommand{"milli", "m"},
    LatexCommand{"metre", "m"},       LatexCommand{"meter", "m"},
    LatexCommand{"degree", "°"},      LatexCommand{"circ", "°"},
    LatexCommand{"textminus", "-"},   LatexCommand{"uparrow", "↑"},
    LatexCommand{"downarrow", "↓"},   LatexCommand{"textuparrow", "↑"},
    LatexCommand{"quad", " "},        LatexCommand{"textdownarrow", "↓"},
    LatexCommand{"textbf", ""},       LatexCommand{"textit", ""},
    LatexCommand{"emph", ""},         LatexCommand{"text", ""},
    LatexCommand{"mathrm", ""},       LatexCommand{"mathbf", ""},
    LatexCommand{"num", ""},          LatexCommand{"SI", ""},
    LatexCommand{"si", ""},           LatexCommand{"qty", ""},
    LatexCommand{"unit", ""},         LatexCommand{"bf", ""},
    LatexCommand{"bfseries", ""},     LatexCommand{"small", ""},
    LatexCommand{"footnotesize", ""}, LatexCommand{"centering", ""},
};

/// "$-0.5$", "\\textbf{Run 1}", "10\\,\\%": the words of a cell without their commands.
std::string wordsOfLatex(std::string_view cell) {
    std::string words;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const char c = cell[i];
        if (c != '\\') {
            if (c != '$' && c != '{' && c != '}')
                words += c == '~' ? ' ' : c;
            continue;
        }
        const std::size_t end =
            std::min(cell.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", i + 1),
                     cell.size());
        const std::string_view command = cell.substr(i + 1, end - i - 1);
        if (command.empty() && end < cell.size()) {
            words += cell[end] == ',' ? ' ' : cell[end]; // "\\%", a thin space
            i = end;
        } else {
            const auto *const known = std::ranges::find(latexCommands, command, &LatexCommand::name);
            // "\\pm 0.5" is no 0.5: what is not known stays, and the cell no number.
            words += known == latexCommands.end() ? '\\' + std::string(command) : std::string(known->text);
            i = std::min(cell.find_first_not_of(' ', end), cell.size()) - 1; // blanks behind it only end it
        }
    }
    return words;
}

/// A line of a table, its cells parted by tabs; "\\multicolumn{2}{c}{Run 1}" fills two.
std::string lineOfLatex(std::string_view line) {
    constexpr std::string_view spanning = "\\multicolumn{";
    std::string cells;
    for (;;) {
        std::size_t end = 0;
        do // not "\\&"
            end = std::min(line.find('&', end == 0 ? 0 : end + 1), line.size());
        while (end < line.size() && end > 0 && line[end - 1] == '\\');
        std::string_view cell = line.substr(0, end);
        std::size_t spans = 1;
        if (const std::size_t at = cell.find(spanning); at != std::string_view::npos) {
            const std::string_view rest = cell.substr(at + spanning.size());
            spans =
                rest.empty() || rest[0] < '1' || rest[0] > '9' ? 1 : static_cast<std::size_t>(rest[0] - '0');
            const std::size_t text = rest.find('{', rest.find('}', rest.find('{')));
            cell = text == std::string_view::npos ? std::string_view() : rest.substr(text);
        }
        cells += wordsOfLatex(cell);
        cells.append(spans - 1, '\t');
        if (end == line.size())
            return cells;
        cells += '\t';
        line.remove_prefix(end + 1);
    }
}

} // namespace

std::string textOfLatex(std::string text) {
    if (text.find("\\begin{tab") == std::string::npos && text.find("\\begin{longtab") == std::string::npos)
        return text;
    std::string result;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t size = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, size);
        const bool isEnded = size < rest.size();
        rest.remove_prefix(std::min(size + 1, rest.size()));
        for (const std::string_view rule : {"\\hline", "\\toprule", "\\midrule", "\\bottomrule"}) {
            while (line.starts_with(rule) || line.starts_with(' '))
                line.remove_prefix(line.starts_with(' ') ? 1 : rule.size());
        }
        const std::size_t last = line.rfind("\\\\");
        const bool isRow = last != std::string_view::npos || line.find('&') != std::string_view::npos;
        const bool isCommand = line.starts_with('\\') && !isRow;
        if (isRow || !isCommand)
            result += isRow ? lineOfLatex(line.substr(0, last)) : std::string(line);
        if (isEnded) // else the file may have been cut
            result += '\n';
    }
    return result;
}

} // namespace palmer
