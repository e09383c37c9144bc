// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnrole.h"

#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace palmer {

namespace {

constexpr std::array<std::string_view, 15> columnRoleWords{
    // in the order of ColumnRole
    "ignored", "target", "actual", "deviation", "run",         "direction", "number",   "angle",
    "radius",  "x",      "y",      "time",      "temperature", "nominal",   "statistic"};

std::optional<ImportColumn> columnNamed(std::string_view word) {
    const std::size_t bare = std::min(word.find_first_of("+-0123456789"), word.size());
    const auto *const found = std::ranges::find_if(
        columnRoleWords, [&](std::string_view role) { return sameWord(role, word.substr(0, bare)); });
    if (found == columnRoleWords.end())
        return {};
    ImportColumn column{static_cast<ColumnRole>(found - columnRoleWords.begin())};
    word.remove_prefix(bare);
    if (!word.empty() && !column.canHaveDirection())
        return {};
    if (!word.empty() && (word.front() == '+' || word.front() == '-')) {
        column.direction = word.front() == '+' ? Direction::positive : Direction::negative;
        word.remove_prefix(1);
    }
    if (word.empty())
        return column;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), column.number);
    return read.ec == std::errc() && read.ptr == word.data() + word.size() ? std::optional(column)
                                                                           : std::nullopt;
}

} // namespace

std::string wordOf(const std::vector<ImportColumn> &columns) {
    std::string text;
    for (const ImportColumn &column : columns) {
        text +=
            (text.empty() ? "" : ",") + std::string(columnRoleWords[static_cast<std::size_t>(column.role)]);
        if (column.direction)
            text += *column.direction == Direction::positive ? '+' : '-';
        if (column.number > 0)
            text += std::to_string(column.number);
    }
    return text;
}

std::optional<std::vector<ImportColumn>> columnsOf(std::string_view text, std::string *unknown) {
    std::vector<ImportColumn> columns;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view word = withoutBlanks(text.substr(begin, end - begin));
        const auto column = columnNamed(word);
        if (!column) {
            if (unknown)
                *unknown = word;
            return {};
        }
        columns.push_back(*column);
        begin = end + 1;
    }
    return columns;
}

std::string roleWords() {
    std::string list;
    for (const std::string_view word : columnRoleWords)
        list += (list.empty() ? "" : ", ") + std::string(word);
    return list + ", run+, run-, run+1 …, radius+, radius- …";
}

} // namespace palmer
