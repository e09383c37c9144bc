// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/choices.h"

#include "import/formats.h"
#include "import/layouts/columnrole.h"
#include "import/layouts/sections.h"
#include "import/question.h"
#include "kernel/evaluation/edition.h"
#include "kernel/words/shortest.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <vector>

namespace palmer {

namespace {

std::span<const ImportWord> formatWords() {
    static const auto words = [] {
        std::vector<ImportWord> named;
        for (const ImportFormat *format : importFormats()) {
            if (!format->name.empty())
                named.push_back({format->word, format->name});
        }
        return named;
    }();
    return words;
}
constexpr std::array encodingWords{
    ImportWord{"UTF-8", REPORT_TEXT("report", "UTF-8")},
    ImportWord{"UTF-16LE", REPORT_TEXT("report", "UTF-16, little end first")},
    ImportWord{"UTF-16BE", REPORT_TEXT("report", "UTF-16, big end first")},
    ImportWord{"Windows-1252", REPORT_TEXT("report", "Western Europe (Windows-1252)")},
    ImportWord{"GB18030", REPORT_TEXT("report", "Chinese (GB18030, GBK)")},
};
constexpr std::array delimiterWords{
    ImportWord{"tab", REPORT_TEXT("report", "tab")},
    ImportWord{"semicolon", REPORT_TEXT("report", "semicolon ;")},
    ImportWord{"comma", REPORT_TEXT("report", "comma ,")},
    ImportWord{"bar", REPORT_TEXT("report", "vertical bar |")},
    ImportWord{"colon", REPORT_TEXT("report", "colon between blanks")},
    ImportWord{"blanks", REPORT_TEXT("report", "blanks")},
};
constexpr std::array markWords{
    ImportWord{"point", REPORT_TEXT("report", "point .")},
    ImportWord{"comma", REPORT_TEXT("report", "comma ,")},
};
constexpr std::array kindWords{
    ImportWord{"positioning", REPORT_TEXT("report", "positioning test")},
    ImportWord{"circular", REPORT_TEXT("report", "circular test")},
    ImportWord{"drift", REPORT_TEXT("report", "drift test")},
    ImportWord{"temperatures", REPORT_TEXT("report", "temperatures over time")},
};
constexpr std::array layoutWords{
    ImportWord{"targetsDown", REPORT_TEXT("report", "targets down, runs across")},
    ImportWord{"runsDown", REPORT_TEXT("report", "runs down, targets across")},
    ImportWord{"list", REPORT_TEXT("report", "one reading a line")},
    ImportWord{"xy", REPORT_TEXT("report", "x and y")},
    ImportWord{"angleRadius", REPORT_TEXT("report", "angle and radius")},
    ImportWord{"angleDeviation", REPORT_TEXT("report", "angle and radial deviation")},
    ImportWord{"deviations", REPORT_TEXT("report", "radial deviations alone")},
    ImportWord{"series", REPORT_TEXT("report", "values over time")},
};
constexpr std::array directionWords{
    ImportWord{"stated", REPORT_TEXT("report", "as the file says")},
    ImportWord{"alternating", REPORT_TEXT("report", "alternating ↑ ↓")},
    ImportWord{"sideBySide", REPORT_TEXT("report", "all ↑, then all ↓")},
    ImportWord{"positive", REPORT_TEXT("report", "all ↑")},
    ImportWord{"negative", REPORT_TEXT("report", "all ↓")},
};
constexpr std::array contentWords{
    ImportWord{"deviations", REPORT_TEXT("report", "deviations")},
    ImportWord{"positions", REPORT_TEXT("report", "positions")},
};
constexpr std::array signWords{
    ImportWord{"actualMinusTarget", REPORT_TEXT("report", "actual − target (ISO)")},
    ImportWord{"targetMinusActual", REPORT_TEXT("report", "target − actual")},
};
constexpr std::array unitWords{
    ImportWord{"mm", REPORT_TEXT("report", "mm")},     ImportWord{"um", REPORT_TEXT("report", "µm")},
    ImportWord{"nm", REPORT_TEXT("report", "nm")},     ImportWord{"cm", REPORT_TEXT("report", "cm")},
    ImportWord{"m", REPORT_TEXT("report", "m")},       ImportWord{"in", REPORT_TEXT("report", "in")},
    ImportWord{"uin", REPORT_TEXT("report", "µin")},   ImportWord{"deg", REPORT_TEXT("report", "°")},
    ImportWord{"mdeg", REPORT_TEXT("report", "mdeg")}, ImportWord{"arcmin", REPORT_TEXT("report", "′")},
    ImportWord{"arcsec", REPORT_TEXT("report", "″")},  ImportWord{"rad", REPORT_TEXT("report", "rad")},
    ImportWord{"mrad", REPORT_TEXT("report", "mrad")}, ImportWord{"urad", REPORT_TEXT("report", "µrad")},
    ImportWord{"gon", REPORT_TEXT("report", "gon")},
};
constexpr std::array timeWords{
    ImportWord{"s", REPORT_TEXT("report", "s")},
    ImportWord{"min", REPORT_TEXT("report", "min")},
    ImportWord{"h", REPORT_TEXT("report", "h")},
};
constexpr std::array motionWords{
    ImportWord{"linear", REPORT_TEXT("report", "linear")},
    ImportWord{"rotary", REPORT_TEXT("report", "rotary")},
};
constexpr std::array correctionWords{
    ImportWord{"not stated", REPORT_TEXT("report", "not stated")},
    ImportWord{"not applied", REPORT_TEXT("report", "not applied")},
    ImportWord{"applied by the instrument", REPORT_TEXT("report", "applied by the instrument")},
    ImportWord{"applied here", REPORT_TEXT("report", "applied here")},
};
constexpr std::array referenceWords{
    ImportWord{"polar", REPORT_TEXT("report", "of the measured point")},
    ImportWord{"commanded", REPORT_TEXT("report", "of the programmed path")},
};
constexpr std::array calibratedWords{
    ImportWord{"not stated", REPORT_TEXT("report", "not stated")},
    ImportWord{"yes", REPORT_TEXT("report", "yes")},
    ImportWord{"no", REPORT_TEXT("report", "no")},
};
constexpr std::array keepWords{
    ImportWord{"keep", REPORT_TEXT("report", "the numbers are right")},
};
constexpr std::array hiddenWords{
    ImportWord{"read", REPORT_TEXT("report", "read like the others")},
    ImportWord{"leave", REPORT_TEXT("report", "leave out")},
};
constexpr std::array stateWords{
    ImportWord{"asFound", REPORT_TEXT("report", "as found")},
    ImportWord{"asLeft", REPORT_TEXT("report", "as left")},
};
constexpr std::array leaveWords{
    ImportWord{"leave", REPORT_TEXT("report", "leave out")},
};

const std::array keys{
    ImportKey{"format", REPORT_TEXT("report", "Format"), ImportValue::word, formatWords()},
    ImportKey{"encoding", REPORT_TEXT("report", "Encoding"), ImportValue::word, encodingWords},
    ImportKey{"delimiter", REPORT_TEXT("report", "Delimiter"), ImportValue::word, delimiterWords},
    ImportKey{"decimalMark", REPORT_TEXT("report", "Decimal mark"), ImportValue::word, markWords},
    ImportKey{"sheet", REPORT_TEXT("report", "Sheet"), ImportValue::text},
    ImportKey{"hidden", REPORT_TEXT("report", "Hidden rows and columns"), ImportValue::word, hiddenWords},
    ImportKey{"table", REPORT_TEXT("report", "Table"), ImportValue::number},
    ImportKey{"lines", REPORT_TEXT("report", "Lines"), ImportValue::text},
    ImportKey{"kind", REPORT_TEXT("report", "Kind"), ImportValue::word, kindWords},
    ImportKey{"columns", REPORT_TEXT("report", "Columns"), ImportValue::text},
    ImportKey{"series", REPORT_TEXT("report", "Process variable"), ImportValue::text},
    ImportKey{"layout", REPORT_TEXT("report", "Layout"), ImportValue::word, layoutWords},
    ImportKey{"directions", REPORT_TEXT("report", "Directions"), ImportValue::word, directionWords},
    ImportKey{"content", REPORT_TEXT("report", "Content"), ImportValue::word, contentWords},
    ImportKey{"unit", REPORT_TEXT("report", "Unit"), ImportValue::word, unitWords},
    ImportKey{"positionUnit", REPORT_TEXT("report", "Unit of positions"), ImportValue::word, unitWords},
    ImportKey{"timeUnit", REPORT_TEXT("report", "Unit of times"), ImportValue::word, timeWords},
    ImportKey{"sign", REPORT_TEXT("report", "Sign"), ImportValue::word, signWords},
    ImportKey{"axis", REPORT_TEXT("report", "Axis"), ImportValue::text},
    ImportKey{"state", REPORT_TEXT("report", "As found or as left"), ImportValue::word, stateWords},
    ImportKey{"motion", REPORT_TEXT("report", "Motion"), ImportValue::word, motionWords},
    ImportKey{"plane", REPORT_TEXT("report", "Plane"), ImportValue::text},
    ImportKey{"nominalRadius", REPORT_TEXT("report", "Nominal radius (mm)"), ImportValue::number},
    ImportKey{"centreFirst", REPORT_TEXT("report", "Centre, first axis (mm)"), ImportValue::number},
    ImportKey{"centreSecond", REPORT_TEXT("report", "Centre, second axis (mm)"), ImportValue::number},
    ImportKey{"feed", REPORT_TEXT("report", "Feed (mm/min)"), ImportValue::number},
    ImportKey{"startAngle", REPORT_TEXT("report", "Start angle (°)"), ImportValue::number},
    ImportKey{"arc", REPORT_TEXT("report", "Arc (°)"), ImportValue::number},
    ImportKey{"overshoot", REPORT_TEXT("report", "Angular overshoot (°)"), ImportValue::number},
    ImportKey{"angleReference", REPORT_TEXT("report", "Angles"), ImportValue::word, referenceWords},
    ImportKey{"calibrated", REPORT_TEXT("report", "Length calibrated"), ImportValue::word, calibratedWords},
    ImportKey{"correctionTo20", REPORT_TEXT("report", "Correction to 20 °C"), ImportValue::word,
              correctionWords},
    ImportKey{"edition", REPORT_TEXT("report", "Edition"), ImportValue::text},
    ImportKey{"unread", REPORT_TEXT("report", "Data not read"), ImportValue::word, leaveWords},
    ImportKey{"large", REPORT_TEXT("report", "Large deviations"), ImportValue::word, keepWords},
    ImportKey{"spread", REPORT_TEXT("report", "Spread between runs"), ImportValue::word, keepWords},
    ImportKey{"equalsTargets", REPORT_TEXT("report", "Deviations equal to targets"), ImportValue::word,
              keepWords},
    ImportKey{"zeros", REPORT_TEXT("report", "Readings that are all equal"), ImportValue::word, keepWords},
    ImportKey{"unequalRuns", REPORT_TEXT("report", "Unequal numbers of runs"), ImportValue::word, keepWords},
};

std::string listOf(std::span<const ImportWord> words) {
    std::string list;
    for (const ImportWord &word : words)
        list += (list.empty() ? "" : ", ") + std::string(word.word);
    return list;
}

} // namespace

std::span<const ImportKey> importKeys() {
    return keys;
}

const ImportKey *findImportKey(std::string_view key) {
    const auto *const found =
        std::ranges::find_if(keys, [&](const ImportKey &row) { return row.key == key; });
    return found == keys.end() ? nullptr : found;
}

Argument nameOfChoice(std::string_view key) {
    const ImportKey *known = findImportKey(key);
    return known ? Argument(known->name) : Argument(std::string(key));
}

Argument nameOfWord(std::string_view key, std::string_view word) {
    if (const ImportKey *known = findImportKey(key)) {
        const auto found =
            std::ranges::find_if(known->words, [&](const ImportWord &one) { return word == one.word; });
        if (found != known->words.end())
            return found->name;
    }
    return std::string(word);
}

namespace {

void requireKnownValue(const std::string &key, const std::string &value) {
    const ImportKey *known = findImportKey(key);
    if (!known) {
        std::string list;
        for (const ImportKey &row : keys)
            list += (list.empty() ? "" : ", ") + std::string(row.key);
        refuseContent(REPORT_TEXT("report", "unknown choice %1; known: %2"), key, list);
    }
    const auto same = [&](const ImportWord &word) { return word.word == value; };
    if (value == keepAnswer && isAsked(key))
        return;
    if (known->value == ImportValue::word && std::ranges::none_of(known->words, same))
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), known->name, value,
                      listOf(known->words));
    if (known->value == ImportValue::number && !numberIn(value))
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; expected a number"), known->name, value);
    if (std::string unknownRole; key == "columns" && !columnsOf(value, &unknownRole))
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), known->name, unknownRole,
                      roleWords());
    if (key == "edition" && !findEdition(value))
        refuseContent(REPORT_TEXT("report", "unknown edition %1; known: %2"), value, wordsOf(editions()));
}

} // namespace

void requireKnown(const ImportOptions &options) {
    for (const auto &[key, value] : options)
        requireKnownValue(key, value);
}

bool Choices::isChosen(std::string_view key) const {
    const auto found = m_options.find(key);
    return found != m_options.end() && found->second != keepAnswer;
}

std::string_view Choices::chosen(std::string_view key) const {
    return isChosen(key) ? std::string_view(m_options.find(key)->second) : std::string_view();
}

std::string_view Choices::usual(std::string_view key) const {
    const auto found = m_usual.find(key);
    return found == m_usual.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<double> Choices::usualNumber(std::string_view key) const {
    return numberIn(usual(key));
}

std::optional<double> Choices::chosenNumber(std::string_view key) const {
    return isChosen(key) ? numberIn(chosen(key)) : std::nullopt;
}

Choice<std::string> Choices::resolve(std::string_view key, std::string_view found, Origin origin) {
    Choice<std::string> choice = isChosen(key) ? Choice<std::string>{std::string(chosen(key)), Origin::chosen}
                                               : Choice<std::string>{std::string(found), origin};
    remember(key, choice.value, choice.origin);
    return choice;
}

Choice<double> Choices::resolveNumber(std::string_view key, double found, Origin origin) {
    const std::optional<double> number = chosenNumber(key);
    const Choice<double> choice{number.value_or(found), number ? Origin::chosen : origin};
    remember(key, shortest(choice.value), choice.origin);
    return choice;
}

std::string Choices::resolveEdition(Kind kind) {
    std::string chosen = resolve("edition", defaultEdition(kind).word, Origin::recognised).value;
    const Edition *edition = findEdition(chosen);
    if (!edition || edition->kind != kind) {
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("edition"), chosen,
                      wordsOf(editionsOf(kind)));
    }
    return chosen;
}

void Choices::remember(std::string_view key, std::string value, Origin origin) {
    const auto same = [&](const ImportChoice &choice) { return choice.key == key; };
    const auto found = std::ranges::find_if(m_settled, same);
    if (found != m_settled.end())
        *found = {std::string(key), std::move(value), origin};
    else
        m_settled.push_back({std::string(key), std::move(value), origin});
}

} // namespace palmer
