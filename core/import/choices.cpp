// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/choices.h"

#include "document/filewords.h"
#include "import/formats.h"
#include "import/layouts/columnrole.h"
#include "import/layouts/sections.h"
#include "import/question.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"
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
constexpr auto encodingWords =
    std::to_array<ImportWord>({{"UTF-8", REPORT_TEXT("report", "UTF-8")},
                               {"UTF-16LE", REPORT_TEXT("report", "UTF-16, little end first")},
                               {"UTF-16BE", REPORT_TEXT("report", "UTF-16, big end first")},
                               {"Windows-1252", REPORT_TEXT("report", "Western Europe (Windows-1252)")},
                               {"GB18030", REPORT_TEXT("report", "Chinese (GB18030, GBK)")}});
constexpr auto delimiterWords =
    std::to_array<ImportWord>({{"tab", REPORT_TEXT("report", "tab")},
                               {"semicolon", REPORT_TEXT("report", "semicolon ;")},
                               {"comma", REPORT_TEXT("report", "comma ,")},
                               {"bar", REPORT_TEXT("report", "vertical bar |")},
                               {"colon", REPORT_TEXT("report", "colon between blanks")},
                               {"blanks", REPORT_TEXT("report", "blanks")}});
constexpr auto markWords = std::to_array<ImportWord>(
    {{"point", REPORT_TEXT("report", "point .")}, {"comma", REPORT_TEXT("report", "comma ,")}});
/// The kinds of tests, and temperatures that belong to one.
std::span<const ImportWord> kindWords() {
    static const auto words = [] {
        std::vector<ImportWord> named;
        for (const auto &row : fileWords<Kind>)
            named.push_back({row.word, traitsOf(row.value).name});
        named.push_back({"temperatures", REPORT_TEXT("report", "temperatures over time")});
        return named;
    }();
    return words;
}
constexpr auto layoutWords = std::to_array<ImportWord>(
    {{"targetsDown", REPORT_TEXT("report", "targets down, runs across"), Kind::positioning},
     {"runsDown", REPORT_TEXT("report", "runs down, targets across"), Kind::positioning},
     {"list", REPORT_TEXT("report", "one reading a line"), Kind::positioning},
     {"xy", REPORT_TEXT("report", "x and y"), Kind::circular},
     {"angleRadius", REPORT_TEXT("report", "angle and radius"), Kind::circular},
     {"angleDeviation", REPORT_TEXT("report", "angle and radial deviation"), Kind::circular},
     {"deviations", REPORT_TEXT("report", "radial deviations alone"), Kind::circular},
     {"series", REPORT_TEXT("report", "values over time"), Kind::drift}});
constexpr auto directionWords =
    std::to_array<ImportWord>({{"stated", REPORT_TEXT("report", "as the file says")},
                               {"reversed", REPORT_TEXT("report", "the other way round than the file says")},
                               {"alternating", REPORT_TEXT("report", "alternating ↑ ↓")},
                               {"sideBySide", REPORT_TEXT("report", "all ↑, then all ↓")},
                               {"positive", REPORT_TEXT("report", "all ↑")},
                               {"negative", REPORT_TEXT("report", "all ↓")}});
constexpr auto contentWords = std::to_array<ImportWord>(
    {{"deviations", REPORT_TEXT("report", "deviations")}, {"positions", REPORT_TEXT("report", "positions")}});
constexpr auto signWords =
    std::to_array<ImportWord>({{"actualMinusTarget", REPORT_TEXT("report", "actual − target (ISO)")},
                               {"targetMinusActual", REPORT_TEXT("report", "target − actual")}});
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
constexpr auto timeWords = std::to_array<ImportWord>({{"s", REPORT_TEXT("report", "s")},
                                                      {"min", REPORT_TEXT("report", "min")},
                                                      {"h", REPORT_TEXT("report", "h")}});
constexpr auto motionWords = std::to_array<ImportWord>(
    {{"linear", REPORT_TEXT("report", "linear")}, {"rotary", REPORT_TEXT("report", "rotary")}});
constexpr auto correctionWords = std::to_array<ImportWord>(
    {{"not stated", REPORT_TEXT("report", "not stated")},
     {"not applied", REPORT_TEXT("report", "not applied")},
     {"applied by the instrument", REPORT_TEXT("report", "applied by the instrument")},
     {"applied here", REPORT_TEXT("report", "applied here")}});
constexpr auto referenceWords =
    std::to_array<ImportWord>({{"polar", REPORT_TEXT("report", "of the measured point")},
                               {"commanded", REPORT_TEXT("report", "of the programmed path")}});
constexpr auto calibratedWords =
    std::to_array<ImportWord>({{"not stated", REPORT_TEXT("report", "not stated")},
                               {"yes", REPORT_TEXT("report", "yes")},
                               {"no", REPORT_TEXT("report", "no")}});
constexpr auto senseWords = std::to_array<ImportWord>(
    {{"stated", REPORT_TEXT("report", "as the file says, the points in the opposite order")},
     {"angles", REPORT_TEXT("report", "as the angles run")},
     {"mirrored", REPORT_TEXT("report", "the angles count clockwise")}});
constexpr auto keepWords =
    std::to_array<ImportWord>({{"keep", REPORT_TEXT("report", "the numbers are right")}});
constexpr auto hiddenWords = std::to_array<ImportWord>(
    {{"read", REPORT_TEXT("report", "read like the others")}, {"leave", REPORT_TEXT("report", "leave out")}});
constexpr auto stateWords = std::to_array<ImportWord>(
    {{"asFound", REPORT_TEXT("report", "as found")}, {"asLeft", REPORT_TEXT("report", "as left")}});
constexpr auto leaveWords = std::to_array<ImportWord>({{"leave", REPORT_TEXT("report", "leave out")}});

const auto keys = std::to_array<ImportKey>({
    {"format", REPORT_TEXT("report", "Format"), ImportValue::word, formatWords()},
    {"encoding", REPORT_TEXT("report", "Encoding"), ImportValue::word, encodingWords},
    {"delimiter", REPORT_TEXT("report", "Delimiter"), ImportValue::word, delimiterWords},
    {"decimalMark", REPORT_TEXT("report", "Decimal mark"), ImportValue::word, markWords, Asked::guess},
    {"sheet", REPORT_TEXT("report", "Sheet"), ImportValue::text, {}, Asked::guess},
    {"hidden", REPORT_TEXT("report", "Hidden rows and columns"), ImportValue::word, hiddenWords,
     Asked::guess},
    {"table", REPORT_TEXT("report", "Table"), ImportValue::number, {}, Asked::guess},
    {"lines", REPORT_TEXT("report", "Lines"), ImportValue::text},
    {"part", REPORT_TEXT("report", "Lines of one test"), ImportValue::text, {}, Asked::guess},
    {"kind", REPORT_TEXT("report", "Kind"), ImportValue::word, kindWords(), Asked::guess},
    {"columns", REPORT_TEXT("report", "Columns"), ImportValue::text, {}, Asked::guess},
    {"series", REPORT_TEXT("report", "Process variable"), ImportValue::text, {}, Asked::guess},
    {"layout", REPORT_TEXT("report", "Layout"), ImportValue::word, layoutWords, Asked::guess},
    {"directions", REPORT_TEXT("report", "Directions"), ImportValue::word, directionWords, Asked::guess},
    {"content", REPORT_TEXT("report", "Content"), ImportValue::word, contentWords, Asked::guess},
    {"unit", REPORT_TEXT("report", "Unit"), ImportValue::word, unitWords, Asked::owed},
    {"positionUnit", REPORT_TEXT("report", "Unit of positions"), ImportValue::word, unitWords, Asked::owed},
    {"timeUnit", REPORT_TEXT("report", "Unit of times"), ImportValue::word, timeWords, Asked::owed},
    {"sign", REPORT_TEXT("report", "Sign"), ImportValue::word, signWords, Asked::guess},
    {"axis", REPORT_TEXT("report", "Axis"), ImportValue::text, {}, Asked::guess},
    {"state", REPORT_TEXT("report", "As found or as left"), ImportValue::word, stateWords, Asked::guess},
    {"motion", REPORT_TEXT("report", "Motion"), ImportValue::word, motionWords, Asked::guess},
    {"plane", REPORT_TEXT("report", "Plane"), ImportValue::text},
    {"nominalRadius", REPORT_TEXT("report", "Nominal radius (mm)"), ImportValue::number, {}, Asked::owed},
    {"centreFirst", REPORT_TEXT("report", "Centre, first axis (mm)"), ImportValue::number},
    {"centreSecond", REPORT_TEXT("report", "Centre, second axis (mm)"), ImportValue::number},
    {"feed", REPORT_TEXT("report", "Feed (mm/min)"), ImportValue::number},
    {"startAngle", REPORT_TEXT("report", "Start angle (°)"), ImportValue::number, {}, Asked::guess},
    {"arc", REPORT_TEXT("report", "Arc (°)"), ImportValue::number, {}, Asked::guess},
    {"overshoot", REPORT_TEXT("report", "Angular overshoot (°)"), ImportValue::number, {}, Asked::guess},
    {"sense", REPORT_TEXT("report", "Sense"), ImportValue::word, senseWords, Asked::guess},
    {"angleReference", REPORT_TEXT("report", "Angles"), ImportValue::word, referenceWords},
    {"calibrated", REPORT_TEXT("report", "Length calibrated"), ImportValue::word, calibratedWords},
    {"correctionTo20", REPORT_TEXT("report", "Correction to 20 °C"), ImportValue::word, correctionWords,
     Asked::guess},
    {"edition", REPORT_TEXT("report", "Edition"), ImportValue::text},
    {"unread", REPORT_TEXT("report", "Data not read"), ImportValue::word, leaveWords, Asked::guess},
    {"large", REPORT_TEXT("report", "Large deviations"), ImportValue::word, keepWords, Asked::doubt},
    {"spread", REPORT_TEXT("report", "Spread between runs"), ImportValue::word, keepWords, Asked::doubt},
    {"equalsTargets", REPORT_TEXT("report", "Deviations equal to targets"), ImportValue::word, keepWords,
     Asked::doubt},
    {"zeros", REPORT_TEXT("report", "Readings that are all equal"), ImportValue::word, keepWords,
     Asked::doubt},
    {"statement", REPORT_TEXT("report", "Statements on the readings"), ImportValue::word, keepWords,
     Asked::doubt},
    {"temperatures", REPORT_TEXT("report", "Temperatures of a sensor"), ImportValue::word, keepWords,
     Asked::doubt},
    {"unequalRuns", REPORT_TEXT("report", "Unequal numbers of runs"), ImportValue::word, keepWords,
     Asked::doubt},
});

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

std::string Choices::resolveEdition(Kind kind, const Edition *stated) {
    const bool isUsed = stated && stated->kind == kind;
    std::string chosen = resolve("edition", isUsed ? stated->word : defaultEdition(kind).word,
                                 isUsed ? Origin::recognised : Origin::guessed)
                             .value;
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
