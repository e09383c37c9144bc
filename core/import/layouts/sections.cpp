// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/sections.h"

#include <algorithm>

namespace palmer {

std::vector<TextLine> linesOf(std::string_view text) {
    std::vector<TextLine> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        lines.push_back({text.substr(at, end - at), lines.size() + 1});
        at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    }
    return lines;
}

std::optional<std::string_view> Section::value(std::string_view key) const {
    const auto found =
        std::ranges::find_if(lines, [&](const SectionLine &each) { return sameWord(each.key, key); });
    return found == lines.end() ? std::nullopt : std::optional(found->value);
}

std::vector<Section> sectionsOf(std::string_view text) {
    std::vector<Section> sections;
    for (const auto &[whole, line] : linesOf(text)) {
        const std::string_view content = withoutBlanks(whole);
        if (content.empty())
            continue;
        if (content.size() > 2 && content.ends_with("::")) {
            sections.push_back({withoutBlanks(content.substr(0, content.size() - 2)), line, {}});
            continue;
        }
        if (sections.empty()) // lines above the first
            sections.push_back({{}, line, {}});
        const std::size_t colon = content.find(':');
        if (colon == std::string_view::npos)
            sections.back().lines.push_back({line, {}, content});
        else
            sections.back().lines.push_back(
                {line, withoutBlanks(content.substr(0, colon)), withoutBlanks(content.substr(colon + 1))});
    }
    return sections;
}

const Section *findSection(const std::vector<Section> &sections, std::string_view name) {
    const auto found =
        std::ranges::find_if(sections, [&](const Section &each) { return sameWord(each.name, name); });
    return found == sections.end() ? nullptr : &*found;
}

std::string_view valueIn(const std::vector<Section> &sections, std::string_view name, std::string_view key) {
    const Section *section = findSection(sections, name);
    return section ? section->value(key).value_or(std::string_view()) : std::string_view();
}

bool containsWord(std::string_view text, std::string_view word) {
    for (std::size_t i = 0; i + word.size() <= text.size(); ++i) {
        if (sameWord(text.substr(i, word.size()), word))
            return true;
    }
    return false;
}

std::optional<double> numberIn(std::string_view text) {
    const CellValue value = readCell(text, decimalMarkIn(text));
    return value.kind == CellKind::number ? std::optional(value.value) : std::nullopt;
}

std::optional<std::vector<double>> numbersIn(std::string_view text) {
    std::vector<double> numbers;
    for (text = withoutBlanks(text); !text.empty(); text = withoutBlanks(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        const auto number = numberIn(text.substr(0, end));
        if (!number)
            return {};
        numbers.push_back(*number);
        text.remove_prefix(end);
    }
    return numbers;
}

} // namespace palmer
