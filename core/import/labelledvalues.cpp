// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/labelledvalues.h"

#include "import/notelabels.h"
#include "kernel/words/characters.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr std::size_t longestLine = 500;
constexpr std::size_t longestLabel = 60; // bytes
constexpr std::string_view separators = ";|\t";
constexpr std::string_view ends = " \t;,|";

std::string_view trimmedOf(std::string_view text, std::string_view signs) {
    const std::size_t first = text.find_first_not_of(signs);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(signs) - first + 1);
}

std::string_view withoutQuotes(std::string_view value) {
    const bool isQuoted = value.size() > 2 && (value.front() == '"' || value.front() == '\'') &&
                          value.find(value.front(), 1) == value.size() - 1;
    return isQuoted ? value.substr(1, value.size() - 2) : value;
}

/// The text of a cell; a quoted one without its doubled quotation marks.
std::string textOf(const CellTable &table, const TableCell &cell) {
    std::string text(table.text(cell).substr(0, longestLine));
    const bool isQuoted = cell.begin > 0 && table.text()[cell.begin - 1] == '"';
    for (std::size_t at = text.find("\"\""); isQuoted && at != std::string::npos;
         at = text.find("\"\"", at + 1))
        text.erase(at, 1);
    constexpr std::string_view wideColon = "：";
    if (const std::size_t at = text.find(wideColon); at != std::string::npos)
        text.replace(at, wideColon.size(), ":");
    return text;
}

/// True for the colon of a label, not for that of "14:30" or "C:\data".
bool endsLabel(std::string_view text, std::size_t at) {
    if (text[at] != ':' && text[at] != '=')
        return false;
    const char next = at + 1 < text.size() ? text[at + 1] : ' ';
    const bool isClock = at > 0 && isDigit(text[at - 1]) && isDigit(next);
    return !isClock && next != '/' && next != '\\' && next != '=';
}

/// Where the label that ends at `end` begins: behind two blanks or at `from`; else the longest known label
/// that begins behind a blank. npos: there is none.
std::size_t beginOfLabel(std::string_view text, std::size_t from, std::size_t end, bool isFirst) {
    const std::string_view before = text.substr(from, end - from);
    if (isFirst)
        return before.size() <= longestLabel ? from : std::string_view::npos;
    if (const std::size_t wide = before.find_last_not_of(' ') == std::string_view::npos
                                     ? std::string_view::npos
                                     : before.substr(0, before.find_last_not_of(' ')).rfind("  ");
        wide != std::string_view::npos)
        return from + wide + 2;
    for (std::size_t at = 0; at < before.size(); ++at) {
        if (before[at] == ' ' && factOf(before.substr(at + 1)))
            return from + at + 1;
    }
    return std::string_view::npos;
}

/// "Date: 13/02/2026 Time: 14:30": the labels and values within a text without separators of cells.
void addFrom(std::string_view text, std::vector<LabelledValue> &all) {
    struct Label {
        std::size_t begin;
        std::size_t end;
    };
    std::vector<Label> labels;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!endsLabel(text, at))
            continue;
        const std::size_t from = labels.empty() ? 0 : labels.back().end + 1;
        if (const std::size_t begin = beginOfLabel(text, from, at, labels.empty());
            begin != std::string_view::npos)
            labels.push_back({begin, at});
    }
    if (labels.empty()) {
        all.push_back({{}, {std::string(text)}, std::string(text)});
        return;
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto &[begin, end] = labels[i];
        const std::size_t next = i + 1 < labels.size() ? labels[i + 1].begin : text.size();
        const std::string_view value = trimmedOf(text.substr(end + 1, next - end - 1), ends);
        LabelledValue one{std::string(trimmedOf(text.substr(begin, end - begin), ends)),
                          {},
                          std::string(trimmedOf(text.substr(begin, next - begin), ends))};
        if (!value.empty())
            one.values.emplace_back(withoutQuotes(value));
        all.push_back(std::move(one));
    }
}

std::vector<LabelledValue> inCell(std::string_view text) {
    std::vector<LabelledValue> all;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        if (const std::string_view part = trimmedOf(text.substr(begin, end - begin), " "); !part.empty())
            addFrom(part, all);
        begin = end + 1;
    }
    return all;
}

/// Puts the cells of a row together.
class LineParts {
public:
    LineParts(bool partsByCommas, std::size_t cells)
        : m_partsByCommas(partsByCommas)
        , m_cells(cells) {}

    void add(const std::string &cell) {
        std::vector<LabelledValue> inside = inCell(cell);
        if (std::ranges::all_of(inside, [](const LabelledValue &one) { return one.label.empty(); })) {
            addPlain(cell);
            return;
        }
        for (LabelledValue &one : inside) {
            m_isOpen = one.values.empty();
            m_isWithin = !m_isOpen;
            all.push_back(std::move(one));
        }
    }

    std::vector<LabelledValue> all;

private:
    void addPlain(const std::string &cell) {
        const bool isLabel = factOf(cell).has_value() || (all.empty() && m_cells == 2);
        if (isLabel) {
            all.push_back({cell, {}, cell});
            m_isOpen = true;
            m_isWithin = false;
        } else if (m_isOpen) {
            all.back().values.push_back(cell);
            all.back().text += ' ' + cell;
        } else if (m_isWithin && m_partsByCommas && !all.back().values.empty()) {
            all.back().values.back() += ", " + cell;
            all.back().text += ", " + cell;
        } else {
            all.push_back({{}, {cell}, cell});
        }
    }

    bool m_partsByCommas;
    std::size_t m_cells;
    bool m_isOpen = false;   ///< the last label has a cell of its own
    bool m_isWithin = false; ///< the last value is in the cell of its label
};

} // namespace

std::vector<std::string> textsIn(const CellTable &table, const TableRow &row) {
    std::vector<std::string> texts;
    std::size_t end = 0;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.size == 0)
            continue;
        const std::string text = textOf(table, cell);
        const auto isLetter = [](char c) { return !isDigit(c) && c != '.' && c != '-' && c != '+'; };
        const bool isTorn = table.delimiter.value == Delimiter::comma && !texts.empty() &&
                            cell.begin == end + 1 && isDigit(text.front()) && isDigit(texts.back().back()) &&
                            std::ranges::any_of(texts.back(), isLetter);
        if (isTorn)
            texts.back() += ',' + text;
        else
            texts.push_back(text);
        end = cell.begin + cell.size;
    }
    return texts;
}

std::vector<LabelledValue> labelledValuesIn(const CellTable &table, const TableRow &row) {
    std::vector<std::string> texts = textsIn(table, row);
    const auto cells = table.cells(row);
    if (!table.isPlaced && table.delimiter.value == Delimiter::blanks && texts.size() > 1) {
        const TableCell &last = cells.back();
        texts = {table.text().substr(
            cells.front().begin,
            std::min<std::size_t>(last.begin + last.size - cells.front().begin, longestLine))};
    }
    LineParts result(!table.isPlaced && table.delimiter.value == Delimiter::comma, texts.size());
    std::size_t size = 0;
    for (const std::string &text : texts) {
        if (size > longestLine)
            break;
        size += text.size();
        result.add(text);
    }
    return std::move(result.all);
}

} // namespace palmer
