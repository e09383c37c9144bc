// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/foreignunits.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

namespace palmer {

namespace {

struct ForeignUnits {
    bool bracketsOnly = false;
    std::string_view list; ///< separated by bars
};

// No single letters, which are axes and directions, and no words used in brackets after headings for other
// reasons: "(rev)", "(inc)", "(pm)", "(turn)", "(NA)".
constexpr std::array<ForeignUnits, 7> foreignUnits{{
    {false, "ppm|ppb|%|‰|°f|degf|fahrenheit|kelvin|percent|prozent|pourcent"},
    {false, "angstrom|ångström|ångstrom|furlong|furlongs|thou|thous|mils|nrad|mgon|cgon"},
    {false, "mv|uv|kv|ma|khz|mhz|ghz|hpa|kpa|mpa|mbar|mmhg|psi|rpm|u/min|tr/min|1/min"},
    {true, "dm|km|å|mil|ft|foot|feet|pied|pieds|yd|yard|yards|lambda|λ|λ/2|λ/4|λ/8"},
    {true, "deg f|volt|volts|ampere|amp|amps|ua|hz|newton|mn|kn|n·m|pa|bar|kg|lb|lbs|kw|mw|db|ohm|ω|kω"},
    {true, "digit|digits|count|counts|cts|increments|incréments|inkremente|incrementi|incrementos|pulses|"
           "impulse|impulses|impulsions|steps|pixel|pixels|px|lsb|fringes|franges|% rh|%rh|%rf|vol%"},
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

} // namespace

bool isForeignUnit(std::string_view text, bool inBrackets) {
    constexpr std::size_t longest = 14;
    if (text.empty() || text.size() > longest)
        return false;
    std::string low(text);
    for (char &c : low)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    const auto found = dictionaryOfForeignUnits().find(low);
    return found != dictionaryOfForeignUnits().end() && (inBrackets || !found->second);
}

} // namespace palmer
