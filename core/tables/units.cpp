// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/units.h"

#include "tables/numbercell.h"

#include <QRegularExpression>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace palmer {

namespace {

struct Spelling {
    std::string_view text;
    const char *word = nullptr;
    bool bracketsOnly = false;
};

// After µ and its likes have become u.
constexpr std::array spellings{
    Spelling{"mm", "mm"},           Spelling{"millimetre", "mm"},  Spelling{"millimeter", "mm"},
    Spelling{"um", "um"},           Spelling{"micron", "um"},      Spelling{"microns", "um"},
    Spelling{"micrometre", "um"},   Spelling{"micrometer", "um"},  Spelling{"micromètre", "um"},
    Spelling{"nm", "nm"},           Spelling{"m", "m", true},      Spelling{"in", "in", true},
    Spelling{"inch", "in"},         Spelling{"inches", "in"},      Spelling{"uin", "uin"},
    Spelling{"uinch", "uin"},       Spelling{"deg", "deg"},        Spelling{"degree", "deg"},
    Spelling{"degrees", "deg"},     Spelling{"degrés", "deg"},     Spelling{"grad", "deg", true},
    Spelling{"°", "deg"},           Spelling{"arcmin", "arcmin"},  Spelling{"arcsec", "arcsec"},
    Spelling{"arc-sec", "arcsec"},  Spelling{"arcsecs", "arcsec"}, Spelling{"″", "arcsec"},
    Spelling{"\"", "arcsec", true}, Spelling{"''", "arcsec"},      Spelling{"’’", "arcsec"},
    Spelling{"′′", "arcsec"},       Spelling{"′", "arcmin"},       Spelling{"rad", "rad"},
    Spelling{"mrad", "mrad"},       Spelling{"urad", "urad"},      Spelling{"s", "s", true},
    Spelling{"sec", "s"},           Spelling{"seconds", "s"},      Spelling{"secondes", "s"},
    Spelling{"min", "min", true},   Spelling{"minutes", "min"},    Spelling{"h", "h", true},
    Spelling{"heures", "h"},        Spelling{"hours", "h"},        Spelling{"ms", "ms"},
    Spelling{"c", "C", true},       Spelling{"°c", "C"},           Spelling{"degc", "C"},
    Spelling{"deg c", "C", true},
};

std::string plain(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        bool micro = false;
        for (const std::string_view sign : {"Âµ", "µ", "μ"}) {
            if (!micro && text.substr(i).starts_with(sign)) {
                result += 'u';
                i += sign.size();
                micro = true;
            }
        }
        if (!micro)
            result += text[i++];
    }
    return result;
}

const Unit *spelled(std::string_view text, bool inBrackets) {
    for (const Spelling &row : spellings) {
        if ((inBrackets || !row.bracketsOnly) && sameWord(row.text, text))
            return unitOf(row.word);
    }
    return nullptr;
}

constexpr std::string_view openings = "([{";
constexpr std::string_view closings = ")]}";

/// What stands in the first brackets, from opening to closing; empty if there is none.
std::string_view bracketed(std::string_view text) {
    const std::size_t open = text.find_first_of(openings);
    if (open == std::string_view::npos)
        return {};
    const std::size_t close = text.find_first_of(closings, open);
    return close == std::string_view::npos ? std::string_view() : text.substr(open, close - open + 1);
}

} // namespace

namespace {

/// "1/1000 mm", "0,001 mm", "10^-3 mm", "10⁻³ mm": a part of the unit that stands behind it, where a number
/// of runs or a feed does not. Nothing: no such part; null: a unit that is not known here.
std::optional<const Unit *> partOfUnit(const std::string &text) {
    static const QRegularExpression part(QStringLiteral(
        R"((?:1\s*/\s*(10+)|0[.,](0*)1|10\s*(?:\^|\*\*)?\s*[-−⁻]\s*([1-9¹²³⁴⁵⁶⁷⁸⁹]))\s*(mm|um|m|in|inch|deg|°)\b)"));
    const auto found = part.match(QString::fromStdString(text));
    if (!found.hasMatch())
        return {};
    qsizetype decimals = found.captured(1).size() - 1;
    if (found.capturedLength(2) > 0 || found.captured(1).isEmpty())
        decimals = found.captured(2).size() + 1;
    if (!found.captured(3).isEmpty())
        decimals = QStringLiteral("0123456789⁰¹²³⁴⁵⁶⁷⁸⁹").indexOf(found.captured(3)) % 10;
    if (found.captured(4) != QLatin1StringView("mm"))
        return nullptr;
    return decimals == 3 ? unitOf("um") : decimals == 6 ? unitOf("nm") : nullptr;
}

/// Whether a heading makes another unit of the one it names: "tenths of µm", "µm/m", "µm x 10", "mm/min",
/// "E-3 mm". What it makes is not known here.
bool isScaled(const std::string &text) {
    constexpr std::size_t shortest = 4; // "um/m"
    if (text.size() < shortest)
        return false;
    constexpr auto flags =
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption;
    static const QRegularExpression scale(
        QStringLiteral(
            R"(\b(?:tenths?|hundredths?|thousandths?|zehntel|hundertstel|tausendstel|(?:dix|cent|mill)i[eè]mes?|)"
            R"((?:dec|centes|milles)im[oi]|d[eé]cimas?|(?:cent|mil)[eé]simas?)\b|)"
            R"(\b1?e\s*[-−]\s*\d+\s*(?:mm|um|m|in|inch|deg|°)\b|)"
            R"((?:\b(?:mm|um|nm|m|in|inch|deg|rad|arcsec)|°)\s*[)\]]?\s*[(\[]?(?:[x×*·]\s*\d|/\s*(?:\d|(?:m|mm|min|s|h|in|inch|ft)\b)))"),
        flags);
    return scale.match(QString::fromStdString(text)).hasMatch();
}

} // namespace

const Unit *unitIn(std::string_view text) {
    const std::string bare = plain(text.substr(0, 500));
    if (bare.find_first_of("01") != std::string::npos) {
        if (const auto part = partOfUnit(bare))
            return *part;
    }
    for (std::string_view rest = bare;;) {
        const std::string_view inside = bracketed(rest);
        if (inside.empty())
            break;
        if (const Unit *unit = spelled(withoutBlanks(inside.substr(1, inside.size() - 2)), true))
            return isScaled(bare) ? nullptr : unit;
        rest = rest.substr(static_cast<std::size_t>(inside.data() - rest.data()) + 1);
    }
    const Unit *last = nullptr;
    constexpr std::string_view separators = " \t:=;,/_()[]{}|";
    for (std::size_t begin = 0; begin < bare.size();) {
        const std::size_t end = std::min(bare.find_first_of(separators, begin), bare.size());
        if (end > begin) {
            if (const Unit *unit = spelled(std::string_view(bare).substr(begin, end - begin), false))
                last = unit;
        }
        begin = end + 1;
    }
    return last && isScaled(bare) ? nullptr : last;
}

std::string withoutUnit(std::string_view text) {
    const std::string_view inside = bracketed(text);
    if (inside.empty() || !unitIn(inside))
        return std::string(withoutBlanks(text));
    const auto at = static_cast<std::size_t>(inside.data() - text.data());
    std::string result(text.substr(0, at));
    result += text.substr(at + inside.size());
    return std::string(withoutBlanks(result));
}

} // namespace palmer
