// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/instruments/datanumbers.h"

#include "import/layouts/sections.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <string>

namespace palmer {

namespace {

/// "1,234" with its mark at `at`: one to three digits, without a leading zero, and three behind.
bool couldBeThousands(std::string_view word, std::size_t at) {
    const std::size_t first = std::min(word.find_first_of("123456789"), at);
    return at - first >= 1 && at - first <= 3 && word.substr(0, first).find('0') == std::string_view::npos &&
           word.size() == at + 4 && std::ranges::all_of(word.substr(at + 1), isDigit);
}

} // namespace

DataNumbers::DataNumbers(std::string_view text, Choices &choices)
    : m_choices(choices) {
    for (std::size_t at = text.find_first_of(".,", 1); at < text.size() && !m_hasDecimals;
         at = text.find_first_of(".,", at + 1))
        m_hasDecimals = isDigit(text[at - 1]) && at + 1 < text.size() && isDigit(text[at + 1]);
}

std::optional<double> DataNumbers::one(std::string_view word, std::size_t line) {
    const auto number = numberIn(word);
    const std::size_t at = word.find_first_of(".,");
    if (!number || at == std::string_view::npos)
        return number;
    if (at + 1 == word.size() && m_hasDecimals)
        return {};
    const bool isComma = word[at] == ',';
    Marked &marked = m_marked[isComma ? 1 : 0];
    ++marked.count;
    if (!couldBeThousands(word, at))
        return number;
    if (marked.ambiguous == 0)
        marked.ambiguous = line;
    const std::string_view chosen = m_choices.chosen("decimalMark");
    return !chosen.empty() && (chosen == "comma") != isComma ? *number * 1000 : number;
}

std::optional<std::vector<double>> DataNumbers::in(std::string_view text, std::size_t line) {
    std::vector<double> numbers;
    for (text = withoutBlanks(text); !text.empty(); text = withoutBlanks(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        const auto number = one(text.substr(0, end), line);
        if (!number)
            return {};
        numbers.push_back(*number);
        text.remove_prefix(end);
    }
    return numbers;
}

void DataNumbers::remark(Remarks &remarks) {
    const bool commaIsRare = m_marked[1].count < m_marked[0].count;
    const Marked &rare = m_marked[commaIsRare ? 1 : 0];
    if (rare.count == 0 || rare.ambiguous == 0)
        return;
    const auto mark = m_choices.resolve("decimalMark", commaIsRare ? "comma" : "point", Origin::guessed);
    if (mark.origin == Origin::guessed)
        remarks.problem({"decimalMark", rare.ambiguous},
                        mark.value == "comma"
                            ? REPORT_TEXT("report", "Decimal mark: the numbers can be read in several ways; "
                                                    "the comma is taken as decimal mark.")
                            : REPORT_TEXT("report", "Decimal mark: the numbers can be read in several ways; "
                                                    "the point is taken as decimal mark."));
}

} // namespace palmer
