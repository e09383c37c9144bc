// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/headings.h"

#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <vector>

namespace palmer {

namespace {

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// The words of a folded text: letters together.
std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < text.size();) {
        if (!isLetter(text[i])) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && isLetter(text[end]))
            ++end;
        words.push_back(text.substr(i, end - i));
        i = end;
    }
    return words;
}

} // namespace

std::optional<Sense> senseIn(std::string_view text) {
    const std::string low = folded(text);
    const std::vector<std::string_view> words = wordsOf(low);
    const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
    if (has("ccw") || has("counterclockwise") || has("anticlockwise") || has("antihoraire") || has("acw") ||
        has("trigo") || has("antiorario") || has("antihorario") || has("gegenuhrzeigersinn") ||
        low.find("counter-clockwise") != std::string::npos ||
        low.find("anti-clockwise") != std::string::npos || low.find("anti-horaire") != std::string::npos ||
        low == "g3" || low == "g03" || low == "⟲" || has("⟲"))
        return Sense::counterclockwise;
    if (has("cw") || has("clockwise") || has("horaire") || has("orario") || has("horario") ||
        has("uhrzeigersinn") || low == "g2" || low == "g02" || has("⟳"))
        return Sense::clockwise;
    return {};
}

std::optional<double> clockTime(std::string_view text) {
    // The last blank-separated part, or what stands behind the T of ISO 8601.
    const std::size_t blank = text.find_last_of(" T");
    std::string_view clock = blank == std::string_view::npos ? text : text.substr(blank + 1);
    if (clock.ends_with('Z'))
        clock.remove_suffix(1);
    double seconds = 0;
    int parts = 0;
    while (parts < 3) {
        const std::size_t colon = clock.find(':');
        const std::string_view part = clock.substr(0, colon);
        const DecimalMark mark =
            part.find(',') == std::string_view::npos ? DecimalMark::point : DecimalMark::comma;
        const LeadingNumber number = leadingNumber(part, mark);
        const double most = parts == 0 ? 48 : 60;
        if (part.empty() || part.front() == '-' || part.front() == '+' || number.size != part.size() ||
            number.value >= most)
            return {};
        seconds += number.value * (parts == 0 ? 3600 : parts == 1 ? 60 : 1);
        ++parts;
        if (colon == std::string_view::npos)
            break;
        if (parts == 3)
            return {};
        clock.remove_prefix(colon + 1);
    }
    return parts >= 2 ? std::optional(seconds) : std::nullopt;
}

} // namespace palmer
