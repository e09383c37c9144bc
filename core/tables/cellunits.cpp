// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/cellunits.h"

#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <string>

namespace palmer {

namespace {

constexpr std::size_t longestWithUnit = 60;

// Quotation marks are doubled in quoted cells; longer ones first.
constexpr std::array<std::string_view, 7> secondSigns{
    "\"\"", "\u2032\u2032", "\u2019\u2019", "''", "\u2033", "\u201D", "\""};
constexpr std::array<std::string_view, 3> minuteSigns{"\u2032", "\u2019", "'"};
constexpr std::string_view degreeSign = "°";

template <std::size_t size>
bool consumeSign(std::string_view &text, const std::array<std::string_view, size> &signs) {
    for (const std::string_view sign : signs) {
        if (text.starts_with(sign)) {
            text = withoutBlanks(text.substr(sign.size()));
            return true;
        }
    }
    return false;
}

/// The unsigned number at the beginning of a text; an integer unless `decimals`.
std::optional<double> consumeNumber(std::string_view &text, DecimalMark mark, bool decimals) {
    if (text.empty() || !isDigit(text.front()))
        return {};
    const LeadingNumber number = leadingNumber(text, mark);
    const std::string_view said = text.substr(0, number.size);
    if (number.size == 0 || (!decimals && !std::ranges::all_of(said, isDigit)) ||
        said.find_first_of("eE") != std::string_view::npos)
        return {};
    text = withoutBlanks(text.substr(number.size));
    return number.value;
}

/// "12°30′15.5″", "-0°0′2″", "12°30′": degrees, by one division of integers and seconds.
std::optional<double> degreesOf(std::string_view text, DecimalMark mark) {
    constexpr double sixty = 60;
    const LeadingNumber whole = leadingNumber(text, mark); // for its sign
    const bool minus = whole.size > 0 && !isDigit(text.front()) && text.front() != '+';
    while (!text.empty() && !isDigit(text.front()))
        text.remove_prefix(1);
    const auto degrees = consumeNumber(text, mark, false);
    if (whole.size == 0 || !degrees || !consumeSign(text, std::array{degreeSign}))
        return {};
    const auto minutes = consumeNumber(text, mark, true);
    if (!minutes || *minutes >= sixty || consumeSign(text, secondSigns) || !consumeSign(text, minuteSigns))
        return {};
    double seconds = 0;
    if (!text.empty()) {
        const auto number = consumeNumber(text, mark, true);
        if (!number || *number >= sixty || !consumeSign(text, secondSigns) || !text.empty())
            return {};
        seconds = *number;
    }
    const double size = ((*degrees * sixty + *minutes) * sixty + seconds) / (sixty * sixty);
    return minus ? -size : size;
}

/// A single word for a length, angle or temperature; single letters number or name something.
const Unit *unitBehind(std::string_view text) {
    const bool isLetter = text.size() == 1 && static_cast<unsigned char>(text.front()) < 0x80 && text != "\"";
    if (text.empty() || isLetter || text.find_first_of(" \t:=;,/_()[]{}|") != std::string_view::npos)
        return nullptr;
    const Unit *unit = unitIn('(' + std::string(text) + ')');
    return unit && unit->kind != UnitKind::time ? unit : nullptr;
}

/// For units that differ by powers of ten: the number of decimals relative to the largest.
std::optional<int> decimalsOf(const Unit &unit, const Unit &base) {
    struct Power {
        std::string_view word;
        std::string_view base;
        int decimals = 0;
    };
    constexpr std::array powers{Power{"m", "m", 0},      Power{"cm", "m", 2},    Power{"mm", "m", 3},
                                Power{"um", "m", 6},     Power{"nm", "m", 9},    Power{"in", "in", 0},
                                Power{"uin", "in", 6},   Power{"rad", "rad", 0}, Power{"mrad", "rad", 3},
                                Power{"urad", "rad", 6}, Power{"deg", "deg", 0}, Power{"mdeg", "deg", 3}};
    const auto rowOf = [&](const Unit &each) {
        return std::ranges::find(powers, std::string_view(each.word), &Power::word);
    };
    const auto *const one = rowOf(unit);
    const auto *const other = rowOf(base);
    if (one == powers.end() || other == powers.end() || one->base != other->base)
        return {};
    return other->decimals - one->decimals;
}

} // namespace

std::optional<CellWithUnit> cellWithUnit(std::string_view cell, DecimalMark mark) {
    cell = withoutBlanks(cell);
    if (cell.size() < 2 || cell.size() > longestWithUnit || isDigit(cell.back()))
        return {};
    const LeadingNumber number = leadingNumber(cell, mark);
    if (number.size == 0)
        return {};
    if (const auto degrees = degreesOf(cell, mark))
        return CellWithUnit{*degrees, unitOf("deg"), 0};
    const Unit *unit = unitBehind(withoutBlanks(cell.substr(number.size)));
    return unit ? std::optional(CellWithUnit{number.value, unit, number.size}) : std::nullopt;
}

std::optional<double> numberIn(const Unit &wanted, std::string_view cell, DecimalMark mark) {
    const auto read = cellWithUnit(cell, mark);
    if (!read)
        return {};
    if (read->unit == &wanted)
        return read->value;
    if (wanted.kind == UnitKind::angle && std::string_view(wanted.word) == "deg" &&
        read->unit->multiplier == 1)
        return read->unit->toBase(read->value);
    const auto decimals = decimalsOf(*read->unit, wanted);
    const std::string number(withoutBlanks(cell).substr(0, read->size));
    if (!decimals || number.find_first_of("eE") != std::string::npos)
        return {};
    const std::string moved = number + 'e' + std::to_string(*decimals);
    const LeadingNumber result = leadingNumber(moved, mark);
    return result.size == moved.size() ? std::optional(result.value) : std::nullopt;
}

bool isUnitSign(std::string_view text) {
    constexpr std::array<std::string_view, 9> signs{"mm", "µm", "μm", "um", "Âµm", "nm", "°", "″", "\""};
    return std::ranges::find(signs, text) != signs.end();
}

} // namespace palmer
