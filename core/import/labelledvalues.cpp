// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/labelledvalues.h"

#include "import/notelabels.h"
#include "kernel/words/characters.h"
#include "tables/units.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palmer {

namespace {

constexpr std::size_t longestLine = 500;
constexpr std::size_t longestLabel = 60; // bytes
constexpr std::string_view separators = ";|\t";
constexpr std::string_view ends = " \t;,|*"; // "**Machine:** VF2" of Markdown

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
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> wide{
        {{"：", ":"}, {"℃", "°C"}, {"℉", "°F"}}};
    for (const auto &[sign, plain] : wide) {
        if (const std::size_t at = text.find(sign); at != std::string::npos)
            text.replace(at, sign.size(), plain);
    }
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

    /// `isLabel`: by its place in the row.
    void add(const std::string &cell, bool isLabel) {
        std::vector<LabelledValue> inside = inCell(cell);
        if (std::ranges::all_of(inside, [](const LabelledValue &one) { return one.label.empty(); })) {
            addPlain(cell, isLabel);
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
    void addPlain(const std::string &cell, bool isLabel) {
        if (isLabel || factOf(cell).has_value() || (all.empty() && m_cells == 2)) {
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

namespace {

/// The text of a cell, and whether empty cells part it from those before.
struct PlacedText {
    std::string text;
    bool isApart = true;
    bool isNumber = false;
};

std::vector<PlacedText> placedTextsIn(const CellTable &table, const TableRow &row) {
    std::vector<PlacedText> texts;
    std::size_t end = 0;
    bool isApart = true;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.size == 0) {
            isApart = true;
            continue;
        }
        const std::string text = textOf(table, cell);
        const auto isLetter = [](char c) { return !isDigit(c) && c != '.' && c != '-' && c != '+'; };
        const bool isTorn = table.delimiter.value == Delimiter::comma && !texts.empty() &&
                            cell.begin == end + 1 && isDigit(text.front()) &&
                            isDigit(texts.back().text.back()) &&
                            std::ranges::any_of(texts.back().text, isLetter);
        if (isTorn)
            texts.back().text += ',' + text;
        else
            texts.push_back({text, std::exchange(isApart, false), cell.isNumber()});
        end = cell.begin + cell.size;
    }
    return texts;
}

/// "# Feed;1000;mm/min": the cells within a comment.
std::vector<PlacedText> partsOf(std::string_view text, std::string_view signs) {
    std::vector<PlacedText> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(signs, begin), text.size());
        const std::string_view part = trimmedOf(text.substr(begin, end - begin), " ");
        if (!part.empty())
            parts.push_back({std::string(part), parts.empty(), isDigit(part.front())});
        begin = end + 1;
    }
    return parts;
}

/// "Model; VF2; ; Location; Hall 3": of cells in pairs, or of those where each second one is a known label,
/// the first is a label. True for each of them.
std::vector<bool> labelsByPlace(const std::vector<PlacedText> &texts) {
    std::vector<bool> labels(texts.size());
    const auto isWord = [&](std::size_t i) { return !texts[i].isNumber && !isDigit(texts[i].text.front()); };
    bool isInTurn = texts.size() > 2 && texts.size() % 2 == 0;
    bool isAnyKnown = false;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const bool isLast = i + 2 == texts.size() || (i + 2 < texts.size() && texts[i + 2].isApart);
        labels[i] = texts.size() > 2 && texts[i].isApart && isWord(i) && isLast && !texts[i + 1].isApart;
        const bool isKnown = factOf(texts[i].text).has_value();
        isAnyKnown |= isKnown;
        isInTurn = isInTurn && (i % 2 == 0 ? isWord(i) : !isKnown);
    }
    for (std::size_t i = 0; isInTurn && isAnyKnown && i < texts.size(); i += 2)
        labels[i] = true;
    constexpr std::size_t withUnit = 3; // "Centre Y; -300; mm"
    if (texts.size() == withUnit && isWord(0) && texts[1].isNumber && unitIn('(' + texts[2].text + ')'))
        labels.front() = true;
    return labels;
}

} // namespace

std::vector<std::string> textsIn(const CellTable &table, const TableRow &row) {
    std::vector<std::string> texts;
    for (PlacedText &placed : placedTextsIn(table, row))
        texts.push_back(std::move(placed.text));
    return texts;
}

std::vector<LabelledValue> labelledValuesIn(const CellTable &table, const TableRow &row) {
    std::vector<PlacedText> texts = placedTextsIn(table, row);
    const auto cells = table.cells(row);
    if (!table.isPlaced && table.delimiter.value == Delimiter::blanks && texts.size() > 1) {
        // Empty cells of columns of fixed width stand nowhere in the text.
        const auto isFilled = [](const TableCell &cell) { return cell.size > 0; };
        const TableCell &first = *std::ranges::find_if(cells, isFilled);
        const TableCell &last = *std::ranges::find_if(cells.rbegin(), cells.rend(), isFilled);
        const std::string_view text =
            std::string_view(table.text())
                .substr(first.begin,
                        std::min<std::size_t>(last.begin + last.size - first.begin, longestLine));
        texts = {{std::string(text)}};
        // "Control        840D": a label and its value, where nothing else is so far apart.
        const std::size_t gap = text.find("  ");
        const std::size_t value = text.find_first_not_of(' ', std::min(gap, text.size()));
        if (value != std::string_view::npos && !isDigit(text.front()) &&
            text.find("  ", value) == std::string_view::npos &&
            text.substr(0, gap).find_first_of(":=") >= gap - 1)
            texts = {{std::string(text.substr(0, gap))}, {std::string(text.substr(value)), false}};
    }
    if (row.comment && texts.size() == 1) {
        std::vector<PlacedText> parts =
            partsOf(texts.front().text, table.delimiter.value == Delimiter::comma ? ",;|\t" : separators);
        if (parts.size() > 1 && factOf(parts.front().text))
            texts = std::move(parts);
    }
    LineParts result(!table.isPlaced && table.delimiter.value == Delimiter::comma, texts.size());
    const std::vector<bool> labels = labelsByPlace(texts);
    std::size_t size = 0;
    for (std::size_t i = 0; i < texts.size() && size <= longestLine; ++i) {
        size += texts[i].text.size();
        result.add(texts[i].text, labels[i]);
    }
    return std::move(result.all);
}

} // namespace palmer
