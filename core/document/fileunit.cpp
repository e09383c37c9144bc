// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/fileunit.h"

#include "kernel/words/unit.h"

#include <algorithm>
#include <array>
#include <string>

namespace palmer {

namespace {

/// A unit made of others, in the spelling of `plain`; the number times `factor` is in the unit of the file.
struct CompoundUnit {
    std::string_view word;
    std::string_view ofFile;
    double factor = 1;
};
constexpr std::array compoundUnits{
    CompoundUnit{"mm/min", "mm/min"},    CompoundUnit{"m/min", "mm/min", 1000},
    CompoundUnit{"mm/s", "mm/min", 60},  CompoundUnit{"in/min", "mm/min", 25.4},
    CompoundUnit{"deg/min", "deg/min"},  CompoundUnit{"deg/s", "deg/min", 60},
    CompoundUnit{"rpm", "deg/min", 360}, CompoundUnit{"um/m", "um/m"},
    CompoundUnit{"ppm", "um/m"},         CompoundUnit{"mm/m", "um/m", 1000},
    CompoundUnit{"C/h", "C/h"},          CompoundUnit{"K/h", "C/h"},
    CompoundUnit{"um/mC", "um/mC"},      CompoundUnit{"um/mK", "um/mC"},
    CompoundUnit{"um/m/C", "um/mC"},     CompoundUnit{"um/m/K", "um/mC"},
    CompoundUnit{"ppm/C", "um/mC"},      CompoundUnit{"ppm/K", "um/mC"},
    CompoundUnit{"hPa", "hPa"},          CompoundUnit{"mbar", "hPa"},
    CompoundUnit{"Pa", "hPa", 0.01},     CompoundUnit{"kPa", "hPa", 10},
    CompoundUnit{"bar", "hPa", 1000},    CompoundUnit{"%", "%"},
};

/// Returns a typed unit in the spelling of the tables: "µm/(m·°C)" → "um/mC", "°/min" → "deg/min".
std::string plain(std::string_view typed) {
    struct Replacement {
        std::string_view from;
        std::string_view to;
    };
    constexpr std::array replacements{
        Replacement{"µ", "u"}, Replacement{"μ", "u"}, Replacement{"°C", "C"},    Replacement{"°", "deg"},
        Replacement{"·", ""},  Replacement{"⋅", ""},  Replacement{"*", ""},      Replacement{"(", ""},
        Replacement{")", ""},  Replacement{" ", ""},  Replacement{"\u00A0", ""}, Replacement{"\u202F", ""},
    };
    std::string result(typed);
    for (const auto &[from, to] : replacements) {
        for (std::size_t at = result.find(from); at != std::string::npos;
             at = result.find(from, at + to.size()))
            result.replace(at, from.size(), to);
    }
    return result;
}

} // namespace

const char *wordOf(FileUnit unit, Motion motion) {
    const bool linear = motion == Motion::linear;
    switch (unit) {
    case FileUnit::none:
        break;
    case FileUnit::position:
    case FileUnit::deviation:
        return linear ? "mm" : "deg";
    case FileUnit::uncertainty:
        return linear ? "um" : "arcsec";
    case FileUnit::feed:
        return linear ? "mm/min" : "deg/min";
    case FileUnit::length:
    case FileUnit::linearDeviation:
        return "mm";
    case FileUnit::angle:
    case FileUnit::angularDeviation:
        return "deg";
    case FileUnit::perMetre:
        return "um/m";
    case FileUnit::temperature:
    case FileUnit::temperatureRange:
        return "°C";
    case FileUnit::gradient:
        return "°C/h";
    case FileUnit::expansion:
        return "µm/(m·°C)";
    case FileUnit::seconds:
        return "s";
    case FileUnit::minutes:
        return "min";
    case FileUnit::hours:
        return "h";
    case FileUnit::pressure:
        return "hPa";
    case FileUnit::percent:
        return "%";
    }
    return "";
}

std::optional<double> inFileUnit(double number, std::string_view typed, FileUnit unit, Motion motion) {
    const std::string wanted = plain(wordOf(unit, motion));
    const std::string spelled = plain(typed);
    const auto compound = std::ranges::find_if(
        compoundUnits, [&](const CompoundUnit &row) { return row.word == spelled && row.ofFile == wanted; });
    if (compound != compoundUnits.end())
        return number * compound->factor;
    const Unit *from = unitOf(spelled) ? unitOf(spelled) : unitOfSign(spelled);
    const Unit *to = unitOf(wanted);
    if (!from || !to || from->kind != to->kind)
        return std::nullopt;
    if (unit != FileUnit::temperatureRange && to->multiplier == 1 && to->divisor == 1)
        return from->toBase(number); // exact
    return from == to ? number : number * (from->multiplier * to->divisor) / (from->divisor * to->multiplier);
}

Quantity quantityOf(FileUnit unit, Motion motion) {
    const bool linear = motion == Motion::linear;
    switch (unit) {
    case FileUnit::none:
    case FileUnit::minutes:
    case FileUnit::hours:
        break;
    case FileUnit::position:
        return linear ? Quantity::position : Quantity::angle;
    case FileUnit::deviation:
        return linear ? Quantity::deviation : Quantity::angularDeviation;
    case FileUnit::uncertainty:
        return linear ? Quantity::micrometres : Quantity::arcSeconds;
    case FileUnit::feed:
        return linear ? Quantity::feed : Quantity::angularFeed;
    case FileUnit::length:
        return Quantity::position;
    case FileUnit::linearDeviation:
        return Quantity::deviation;
    case FileUnit::angle:
        return Quantity::angle;
    case FileUnit::angularDeviation:
        return Quantity::angularDeviation;
    case FileUnit::perMetre: // the name of the field says "per metre"
        return Quantity::micrometres;
    case FileUnit::temperature:
    case FileUnit::temperatureRange:
        return Quantity::temperature;
    case FileUnit::gradient:
        return Quantity::gradient;
    case FileUnit::expansion:
        return Quantity::expansion;
    case FileUnit::seconds:
        return Quantity::time;
    case FileUnit::pressure:
        return Quantity::pressure;
    case FileUnit::percent:
        return Quantity::percent;
    }
    return Quantity::number;
}

} // namespace palmer
