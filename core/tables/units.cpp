// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/units.h"

#include "tables/numbercell.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_map>
#include <utility>

namespace palmer {

namespace {

struct ForeignUnits {
    bool bracketsOnly = false;
    std::string_view list; ///< separated by bars
};

// No single letters, which are axes and directions, and no words used in brackets after headings for other
// reasons: "(rev)", "(inc)", "(pm)", "(turn)", "(NA)".
constexpr std::array<ForeignUnits, 8> foreignUnits{{
    {false, "ppm|ppb|%|‰|percent|prozent|pourcent"},
    {false, "angstrom|ångström|ångstrom|furlong|furlongs|thou|thous|mils|nrad|mgon|cgon"},
    {false, "mv|uv|kv|ma|khz|mhz|ghz|hpa|kpa|mpa|mbar|mmhg|psi|rpm|u/min|tr/min|1/min"},
    {true, "dm|km|å|mil|ft|foot|feet|pied|pieds|yd|yard|yards|lambda|λ|λ/2|λ/4|λ/8"},
    {true, "volt|volts|ampere|amp|amps|ua|hz|newton|mn|kn|n·m|pa|bar|kg|lb|lbs|kw|mw|db|ohm|ω|kω"},
    {true, "digit|digits|count|counts|cts|increments|incréments|inkremente|incrementi|incrementos|pulses|"
           "impulse|impulses|impulsions|steps|pixel|pixels|px|lsb|fringes|franges|% rh|%rh|%rf|vol%"},
    {true,
     "hundredth|hundredths|thousandth|thousandths|zehntel|hundertstel|tausendstel|dixième|dixièmes|centième|"
     "centièmes|millième|millièmes|decimi|centesimi|millesimi|décimas|centésimas|milésimas"},
    {true, "v|ticks|tick|div|divs|inc|incs|increment|tenths|tenth|pm|å|Å|mu|raw|adc|us|ns|day|days|jour|"
           "jours|tag|tage|week|weeks"},
}};

/// By lower-case spelling: true if it counts only in brackets.
const std::unordered_map<std::string_view, bool> &dictionaryOfForeignUnits() {
    static const auto words = [] {
        std::unordered_map<std::string_view, bool> result;
        for (const ForeignUnits &row : foreignUnits) {
            for (std::string_view rest = row.list; !rest.empty();) {
                const std::string_view word = rest.substr(0, rest.find('|'));
                result.emplace(word, row.bracketsOnly);
                rest.remove_prefix(std::min(word.size() + 1, rest.size()));
            }
        }
        return result;
    }();
    return words;
}

/// True if a text is a unit without conversion: "ppm", "mA", "°F". `µ` is written `u` in it. Ambiguous words
/// count only in brackets.
bool isForeignUnit(std::string_view text, bool inBrackets) {
    constexpr std::size_t longest = 14;
    if (text.empty() || text.size() > longest)
        return false;
    const auto found = dictionaryOfForeignUnits().find(lowerCase(text));
    return found != dictionaryOfForeignUnits().end() && (inBrackets || !found->second);
}

struct Spelling {
    std::string_view text;
    const char *word = nullptr;
    bool bracketsOnly = false;
};

// After replacing µ and similar characters by u.
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
    Spelling{"mdeg", "mdeg"},       Spelling{"m°", "mdeg", true},  Spelling{"deg c", "C", true},
    Spelling{"cm", "cm"},           Spelling{"gon", "gon"},        Spelling{"мм", "mm"},
    Spelling{"мкм", "um"},          Spelling{"毫米", "mm"},        Spelling{"微米", "um"},
    Spelling{"ミクロン", "um"},     Spelling{"ミリ", "mm"},        Spelling{"度", "deg", true},
    Spelling{"'", "arcmin", true},  Spelling{"’", "arcmin", true}, Spelling{"°f", "F"},
    Spelling{"degf", "F"},          Spelling{"fahrenheit", "F"},   Spelling{"deg f", "F", true},
    Spelling{"k", "K", true},       Spelling{"kelvin", "K"},       Spelling{"celsius", "C"},
};

/// Full names of units in the languages of headings.
constexpr std::array<std::pair<const char *, std::string_view>, 13> fullNames{{
    {"mm", "millimetres|millimeters|millimètre|millimètres|millimetri|milímetros"},
    {"um", "micrometres|micrometers|micromètres|mikrometer|mikron|micrometri|micrómetros|microns|micras"},
    {"nm", "nanometre|nanometres|nanometer|nanometers|nanomètre|nanomètres"},
    {"cm", "centimetre|centimetres|centimeter|centimeters|zentimeter|centimètre|centimètres"},
    {"uin", "microinch|microinches|micro-inch|micro-inches|u-inch|uinches|micropouce|micropouces|mikrozoll|"
            "micropollici|micropulgadas"},
    {"in", "zoll|pouce|pouces|pollici|pulgadas"},
    {"deg", "degré|gradi|grados"},
    {"mdeg", "millidegree|millidegrees|millideg|millidegré|millidegrés"},
    {"arcmin", "arcminute|arcminutes|arc-min|arcmins|bogenminute|bogenminuten|winkelminute|winkelminuten|"
               "arc min|arc minute|arc minutes|arc-minute|arc-minutes|minute d'arc|minutes d'arc|"
               "minuto de arco|minutos de arco|minuti d'arco"},
    {"arcsec", "arcsecond|arcseconds|bogensekunde|bogensekunden|winkelsekunde|winkelsekunden|"
               "arc sec|arc second|arc seconds|arc-second|arc-seconds|seconde d'arc|secondes d'arc|"
               "segundo de arco|segundos de arco|secondi d'arco"},
    {"rad", "radian|radians"},
    {"mrad", "milliradian|milliradians|millirad"},
    {"gon", "gons|gradian|gradians"},
}};

std::string plain(std::string_view text) {
    if (std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; }))
        return std::string(text);
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

struct KnownUnit {
    const Unit *unit = nullptr;
    bool bracketsOnly = false;
};

/// By lower-case spelling; each word of a text column is looked up.
const std::unordered_map<std::string_view, KnownUnit> &dictionaryOfUnits() {
    static const auto words = [] {
        std::unordered_map<std::string_view, KnownUnit> result;
        for (const Spelling &row : spellings)
            result.emplace(row.text, KnownUnit{unitOf(row.word), row.bracketsOnly});
        for (const auto &[word, list] : fullNames) {
            for (std::string_view rest = list; !rest.empty();) {
                const std::string_view name = rest.substr(0, rest.find('|'));
                result.emplace(name, KnownUnit{unitOf(word)});
                rest.remove_prefix(std::min(name.size() + 1, rest.size()));
            }
        }
        return result;
    }();
    return words;
}

const Unit *spelled(std::string_view text, bool inBrackets) {
    constexpr std::size_t longest = 20;
    if (text.size() > 2 && text.ends_with('.')) // "mm.", "arcsec."
        text.remove_suffix(1);
    if (text == "\"\"") // of a quoted cell
        text.remove_suffix(1);
    if (text.empty() || text.size() > longest)
        return nullptr;
    const auto found = dictionaryOfUnits().find(lowerCase(text));
    return found != dictionaryOfUnits().end() && (inBrackets || !found->second.bracketsOnly)
               ? found->second.unit
               : nullptr;
}

constexpr std::string_view openings = "([{";
constexpr std::string_view closings = ")]}";

/// The first brackets with their content; empty if there are none.
std::string_view bracketed(std::string_view text) {
    const std::size_t open = text.find_first_of(openings);
    if (open == std::string_view::npos)
        return {};
    const std::size_t close = text.find_first_of(closings, open);
    return close == std::string_view::npos ? std::string_view() : text.substr(open, close - open + 1);
}

/// "1/1000 mm", "0,001 mm", "10^-3 mm", "10⁻³ mm": a fraction of the unit after it, unless it is a run number
/// or feed. Empty if there is no such fraction.
SaidUnit partOfUnit(const std::string &text) {
    static const QRegularExpression part(QStringLiteral(
        R"((?<![\d.,])(?:1\s*/\s*(10+)|0[.,](0*)1|10\s*(?:\^|\*\*)?\s*[-−⁻]\s*([1-9¹²³⁴⁵⁶⁷⁸⁹]))\s*[x×*·]?\s*(mm|um|nm|cm|m|in|inch|deg|°|arcsec|″|(?:micro|mikro|milli|nano)?met(?:re|er)s?|microns?|microm[eè]tres?|inches|micro-?inch(?:es)?)(?![A-Za-z]))"));
    const QString line = QString::fromStdString(text);
    const auto found = part.match(line);
    if (!found.hasMatch())
        return {};
    qsizetype decimals = found.captured(1).size() - 1;
    if (found.capturedLength(2) > 0 || found.captured(1).isEmpty())
        decimals = found.captured(2).size() + 1;
    if (!found.captured(3).isEmpty())
        decimals = QStringLiteral("0123456789⁰¹²³⁴⁵⁶⁷⁸⁹").indexOf(found.captured(3)) % 10;
    // "x0.1 um" may also be a step.
    const qsizetype before = found.capturedStart() - 1;
    const bool isTimes = before >= 0 && QStringLiteral("x×*·").contains(line[before]);
    const bool isKnown = found.captured(4) == QLatin1StringView("mm") && !isTimes;
    if (isKnown && (decimals == 3 || decimals == 6))
        return {unitOf(decimals == 3 ? "um" : "nm")};
    return {nullptr,
            (isTimes ? line.mid(before, found.capturedLength() + 1) : found.captured()).toStdString()};
}

/// The words with which a heading modifies its unit: "tenths of µm", "µm/m", "µm x 10", "mm/min", "E-3 mm",
/// "x0.1um". The result is an unknown unit. Empty if there are none.
std::string scaleIn(const std::string &text) {
    constexpr std::size_t shortest = 4; // "um/m"
    if (text.size() < shortest)
        return {};
    constexpr auto flags =
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption;
    static const QRegularExpression scale(
        QStringLiteral(
            R"(\b(?:tenths?|hundredths?|thousandths?|zehntel|hundertstel|tausendstel|(?:dix|cent|mill)i[eè]mes?|)"
            R"((?:dec|centes|milles)im[oi]|d[eé]cimas?|(?:cent|mil)[eé]simas?)\b(?:\s+(?:of|de|di|von)\b)?(?:\s+(?:mm|um|inch)\b)?|)"
            R"(\b1?e\s*[-−]\s*\d+\s*(?:mm|um|m|in|inch|deg|°)\b|(?<![\w\d])[x×]\s*10+\b|)"
            R"([x×*·]\s*\d+(?:[.,]\d+)?\s*(?:(?:mm|um|nm|cm|in|inch|deg|arcsec)\b|[°″])|)"
            R"((?:\b(?:mm|um|nm|cm|m|in|inch|deg|rad|mrad|urad|arcsec)|[°″])\s*[)\]]?\s*[(\[]?)"
            R"((?:[x×*·]\s*\d+(?:[.,]\d+)?|/\s*(?:\d|(?:m|mm|min|s|sec|h|in|inch|ft|rev|tr|k|kg|n|turn|tour|umdr)\b|°c)))"),
        flags);
    return scale.match(QString::fromStdString(text)).captured().toStdString();
}

/// "0.1 µm", "10 mm", "µm/V" in brackets: a length or angle with a factor, or per another unit.
bool isMadeOfUnits(const std::string &text) {
    static const QRegularExpression factor(QStringLiteral(R"(^\s*[x×*·]?\s*(\d+(?:[.,]\d+)?)\s*(\D+)$)"));
    static const QRegularExpression multiple(QStringLiteral(R"(^\s*(\S+?)\s*[x×*·/]\s*\d+(?:[.,]\d+)?\s*$)"));
    static const QRegularExpression quotient(QStringLiteral(R"(^\s*([^\s/]+)\s*/\s*([^\s/\d]{1,6})\s*$)"));
    const auto isSize = [](const QString &word) {
        const std::string bare = word.trimmed().toStdString();
        const Unit *unit = spelled(bare, true);
        return (unit && (unit->kind == UnitKind::length || unit->kind == UnitKind::angle)) ||
               (!unit && isForeignUnit(bare, true));
    };
    // Most words are not candidates.
    if (text.size() > 30 || text.find_first_of("/0123456789") == std::string::npos)
        return false;
    const QString line = QString::fromStdString(text);
    if (const auto found = factor.match(line); found.hasMatch())
        return found.captured(1) != QLatin1StringView("1") && isSize(found.captured(2));
    if (const auto found = multiple.match(line); found.hasMatch())
        return isSize(found.captured(1));
    const auto found = quotient.match(line);
    return found.hasMatch() && isSize(found.captured(1)) && found.captured(2) != QLatin1StringView("out");
}

/// The words of a scaled unit as written: those of the brackets with it, otherwise only the unit, as it also
/// applies to adjacent columns.
std::string scaledWords(std::string_view text, const std::string &scale) {
    for (std::string_view rest = text;;) {
        const std::string_view inside = bracketed(rest);
        if (inside.empty())
            break;
        const std::string_view words = withoutBlanks(inside.substr(1, inside.size() - 2));
        if (partOfUnit(plain(words)).isSaid() || !scaleIn(plain(words)).empty())
            return std::string(words);
        rest = rest.substr(static_cast<std::size_t>(inside.data() - rest.data()) + 1);
    }
    static const QRegularExpression micrometre(QStringLiteral("(?<![a-z])um(?![a-z])"));
    static const QRegularExpression brackets(QStringLiteral(R"([()[\]{}])"));
    return QString::fromStdString(scale)
        .replace(micrometre, QStringLiteral("µm"))
        .remove(brackets)
        .trimmed()
        .toStdString();
}

/// The unit in the brackets of a text, from the left.
SaidUnit unitInBrackets(std::string_view text) {
    for (std::string_view rest = text;;) {
        const std::string_view inside = bracketed(rest);
        if (inside.empty())
            return {};
        const std::string_view words = withoutBlanks(inside.substr(1, inside.size() - 2));
        const std::string bare = plain(words);
        if (const Unit *unit = spelled(bare, true))
            return {unit};
        if (isForeignUnit(bare, true) || isMadeOfUnits(bare))
            return {nullptr, std::string(words)};
        rest = rest.substr(static_cast<std::size_t>(inside.data() - rest.data()) + 1);
    }
}

/// "Zeit t / s", "U_B1 / V", "dev_us": a unit treated as if in brackets.
SaidUnit unitBehindSlash(std::string_view text) {
    const std::size_t slash = text.rfind(" / ");
    const std::size_t line = text.rfind('_');
    const bool isSlash = slash != std::string_view::npos && slash > 0;
    if (!isSlash && line == std::string_view::npos)
        return {};
    const std::string_view last = withoutBlanks(text.substr(isSlash ? slash + 3 : line + 1));
    const std::string bare = plain(last);
    if (bare.size() < 2 && !isSlash) // "x_s"
        return {};
    if (const Unit *unit = spelled(bare, true))
        return {unit};
    return isForeignUnit(bare, true) ? SaidUnit{nullptr, std::string(last)} : SaidUnit();
}

/// The last word that is a unit.
SaidUnit unitAmongWords(std::string_view text) {
    SaidUnit last;
    bool isOfArc = false; // "arc sec"
    constexpr std::string_view separators = " \t:=;,/_()[]{}|";
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        const std::string bare = plain(word);
        if (const Unit *unit = spelled(isOfArc ? "arc " + bare : bare, false))
            last = {unit};
        else if (isForeignUnit(bare, false))
            last = {nullptr, std::string(word)};
        isOfArc = bare == "arc" || bare == "Arc" || bare == "ARC";
        begin = end + 1;
    }
    return last;
}

/// "Abweichung in Hundertstel", "écart en m", "deviation in ticks": the last word, treated as if in brackets.
/// A single letter is read only as a unit of length or time; the others are axes.
SaidUnit unitBehindPreposition(std::string_view text) {
    text = withoutBlanks(text);
    const std::size_t blank = text.rfind(' ');
    if (blank == std::string_view::npos)
        return {};
    const std::string before = lowerCase(withoutBlanks(text.substr(0, blank)));
    if (!before.ends_with(" in") && !before.ends_with(" en"))
        return {};
    const std::string_view last = text.substr(blank + 1);
    const std::string bare = plain(last);
    if (bare.size() == 1 && std::string_view("msh").find(bare[0]) == std::string_view::npos)
        return {};
    if (const Unit *unit = spelled(bare, true))
        return {unit};
    return isForeignUnit(bare, true) ? SaidUnit{nullptr, std::string(last)} : SaidUnit();
}

} // namespace

SaidUnit saidUnit(std::string_view text) {
    text = text.substr(0, 500);
    if (SaidUnit last = unitBehindSlash(text); last.isSaid())
        return last;
    const std::string bare = plain(text);
    if (bare.find_first_of("01") != std::string::npos) {
        if (SaidUnit part = partOfUnit(bare); part.isSaid())
            return part.unit ? part : SaidUnit{nullptr, scaledWords(text, part.foreign)};
    }
    SaidUnit said = unitInBrackets(text);
    if (!said.isSaid())
        said = unitAmongWords(text);
    if (!said.isSaid())
        said = unitBehindPreposition(text);
    if (const std::string scale = said.unit ? scaleIn(bare) : std::string(); !scale.empty())
        return {nullptr, scaledWords(text, scale)};
    return said;
}

const Unit *unitIn(std::string_view text) {
    return saidUnit(text).unit;
}

std::string withoutUnit(std::string_view text) {
    for (std::string_view rest = text;;) {
        const std::string_view inside = bracketed(rest);
        if (inside.empty())
            return std::string(withoutBlanks(text));
        if (saidUnit(inside).isSaid()) {
            const auto at = static_cast<std::size_t>(inside.data() - text.data());
            std::string result(text.substr(0, at));
            result += text.substr(at + inside.size());
            return std::string(withoutBlanks(result));
        }
        rest = rest.substr(static_cast<std::size_t>(inside.data() - rest.data()) + 1);
    }
}

} // namespace palmer
