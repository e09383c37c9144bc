// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/headings.h"

#include "document/place.h"
#include "import/layouts/sections.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace palmer {

namespace {

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// The words of a folded text: sequences of letters.
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

/// Finds "G2", "Radius (G03)", but not "G21" or "DG2".
bool hasCode(std::string_view text, std::string_view code) {
    const auto isPart = [](char c) { return isLetter(c) || (c >= '0' && c <= '9'); };
    for (std::size_t at = text.find(code); at != std::string_view::npos; at = text.find(code, at + 1)) {
        const std::size_t end = at + code.size();
        if ((at == 0 || !isPart(text[at - 1])) && (end == text.size() || !isPart(text[end])))
            return true;
    }
    return false;
}

/// A side of a difference, also abbreviated: "nom", "mis", "T".
Meaning sideOf(std::string_view words) {
    const std::string word = '|' + std::string(withoutBlanks(words)) + '|';
    const auto isIn = [&](std::string_view list) { return list.find(word) != std::string_view::npos; };
    if (isIn("|nom|t|th|theo|n|c|"))
        return Meaning::target;
    if (isIn("|act|mes|mis|a|m|"))
        return Meaning::actual;
    const HeadingWords side = readHeading(words);
    const bool isActual = side.meaning == Meaning::actual || side.meaning == Meaning::reading;
    return side.unknownWords > 0             ? Meaning::unknown
           : isActual                        ? Meaning::actual
           : side.meaning == Meaning::target ? Meaning::target
                                             : Meaning::unknown;
}

/// "soll - ist": one side of the minus is the target, the other the measured value.
std::string signOfDifference(std::string_view left, std::string_view right) {
    const Meaning from = sideOf(left);
    const Meaning to = sideOf(right);
    if (from == Meaning::actual && to == Meaning::target)
        return "actualMinusTarget";
    return from == Meaning::target && to == Meaning::actual ? "targetMinusActual" : "";
}

} // namespace

NamedSenses sensesIn(std::string_view text) {
    const std::string low = folded(text);
    const std::vector<std::string_view> words = wordsOf(low);
    // The number of words in a list, between bars.
    const auto count = [&](std::string_view list) {
        return std::ranges::count_if(words, [&](std::string_view word) {
            return list.find('|' + std::string(word) + '|') != std::string_view::npos;
        });
    };
    const auto has = [&](std::string_view list) { return count(list) > 0; };
    // "Gegen den Uhrzeigersinn", "sens inverse des aiguilles d'une montre": a clock with a word for against.
    const auto clocks =
        count("|clockwise|horaire|orario|oraria|horario|horaria|uhrzeigersinn|uhrzeigers|uzs|aiguilles|"
              "lancette|agujas|часовой|");
    const bool isAgainst =
        has("|gegen|entgegen|anti|counter|inverse|inverso|contraire|contrario|contro|contra|против|");
    if (clocks > 0 && isAgainst)
        return {clocks > 1 || has("|cw|"), true};
    // "Sens trigonométrique": the mathematical sense of angles.
    if (has("|trigo|trigonometrique|trigonometrico|trigonometrica|"))
        return {isAgainst || clocks > 0, !isAgainst};
    // Chinese and Japanese have no blanks; "反時計回り" contains its opposite.
    const auto contains = [&](std::initializer_list<std::string_view> signs) {
        return std::ranges::any_of(
            signs, [&](std::string_view sign) { return low.find(sign) != std::string::npos; });
    };
    if (contains({"逆时针", "逆時針", "反時計"}))
        return {contains({"顺时针", "順時針"}), true};
    if (contains({"顺时针", "順時針", "時計回り"}))
        return {true, false};
    return {clocks > 0 || has("|cw|sh|rechtsdrehend|rechtslauf|rechtsherum|rechtskreis|⟳|↻|") ||
                hasCode(low, "g2") || hasCode(low, "g02"),
            has("|ccw|counterclockwise|anticlockwise|antihoraire|acw|sah|antiorario|antioraria|antihorario|"
                "antihoraria|guzs|gegenuhrzeigersinn|linksdrehend|linkslauf|linksherum|linkskreis|⟲|↺|") ||
                hasCode(low, "g3") || hasCode(low, "g03") || low == "⟲"};
}

std::optional<Sense> senseIn(std::string_view text) {
    const auto [clockwise, counterclockwise] = sensesIn(text);
    if (clockwise == counterclockwise)
        return {};
    return clockwise ? Sense::clockwise : Sense::counterclockwise;
}

std::optional<double> clockTime(std::string_view text) {
    constexpr double noon = 43'200;
    for (const std::string_view half : {"am", "pm"}) { // "1:30 PM"
        const std::string_view clock =
            withoutBlanks(text.substr(0, text.size() - std::min<std::size_t>(text.size(), 2)));
        if (text.size() < 2 || !sameWord(text.substr(text.size() - 2), half))
            continue;
        const auto time = clockTime(clock);
        return time ? std::optional(std::fmod(*time, noon) + (half == "pm" ? noon : 0)) : std::nullopt;
    }
    // The last blank-separated part, or what follows the T of ISO 8601.
    const std::size_t blank = text.find_last_of(" T");
    std::string_view clock = blank == std::string_view::npos ? text : text.substr(blank + 1);
    if (clock.ends_with('Z'))
        clock.remove_suffix(1);
    double seconds = 0;
    int parts = 0;
    while (parts < 3) {
        const std::size_t colon = clock.find(':');
        const std::string_view part = clock.substr(0, colon);
        const LeadingNumber number = leadingNumber(part, decimalMarkIn(part));
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

SaidSign saidSign(std::string_view text) {
    constexpr std::size_t longest = 300;
    constexpr std::array<std::string_view, 6> minus{" - ", "-", " minus ", " moins ", " meno ", " menos "};
    constexpr std::string_view ends = "=:;,()[]{}";
    const std::string low = folded(text.substr(0, longest));
    const std::string_view line = low;
    for (const std::string_view sign : minus) {
        for (std::size_t at = line.find(sign); at != std::string_view::npos; at = line.find(sign, at + 1)) {
            const std::size_t before = at == 0 ? std::string_view::npos : line.find_last_of(ends, at - 1);
            const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
            const std::size_t end = std::min(line.find_first_of(ends, at), line.size());
            const bool isMarked = before != std::string_view::npos &&
                                  std::string_view("=([{").find(line[before]) != std::string_view::npos;
            if (sign == "-" && !isMarked)
                continue;
            const std::string_view left = line.substr(begin, at - begin);
            const std::string_view right = line.substr(at + sign.size(), end - at - sign.size());
            if (std::string found = signOfDifference(left, right); !found.empty())
                return {std::move(found), excerpt(withoutBlanks(line.substr(begin, end - begin)))};
        }
    }
    return {};
}

std::string unclearDifference(std::string_view heading) {
    const std::string low = folded(withoutUnit(heading.substr(0, 300)));
    const std::string_view line = low;
    const auto isPart = [](char c) { return isLetter(c) || c == '_'; };
    for (std::size_t at = line.find_first_of("-/"); at != std::string_view::npos;
         at = line.find_first_of("-/", at + 1)) {
        std::size_t begin = at;
        while (begin > 0 && isPart(line[begin - 1]))
            --begin;
        std::size_t end = at + 1;
        while (end < line.size() && isPart(line[end]))
            ++end;
        const std::string_view left = line.substr(begin, at - begin);
        const std::string_view right = line.substr(at + 1, end - at - 1);
        const bool goesOn = end + 1 < line.size() && line[end] == '-' && isPart(line[end + 1]);
        if (left.size() > 2 && right.size() > 2 && !goesOn && !signOfDifference(left, right).empty())
            return excerpt(line.substr(begin, end - begin));
    }
    return {};
}

} // namespace palmer
