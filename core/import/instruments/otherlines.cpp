// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/instruments/otherlines.h"

#include "document/place.h"
#include "import/layouts/passes.h"
#include "import/layouts/sections.h"
#include "import/layouts/tablereading.h"
#include "import/notelabels.h"
#include "kernel/words/shortest.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr std::size_t mostStatements = 200;

bool isSize(const SaidUnit &said) {
    return !said.unit || said.unit->kind == UnitKind::length || said.unit->kind == UnitKind::angle;
}

/// True if one of the words of a text is that for a unit; `isFirst`: its first word.
bool namesUnit(std::string_view text, bool isFirst) {
    constexpr std::string_view words =
        "|unit|units|unite|unites|einheit|einheiten|masseinheit|unita|unidad|unidades|";
    const std::string low = folded(text);
    for (std::size_t at = 0; at < low.size();) {
        const std::size_t end = std::min(low.find_first_of(" \t:=()[]", at), low.size());
        if (end > at && words.find('|' + low.substr(at, end - at) + '|') != std::string_view::npos)
            return true;
        if (isFirst && end > at)
            return false;
        at = end + 1;
    }
    return false;
}

std::string_view labelOf(std::string_view text) {
    return text.substr(0, text.find_first_of(":="));
}

/// "Run 1 : Reverse": the reader of statements passes over titles.
bool isTitleLine(std::string_view text, const HeadingWords &words) {
    return !factOf(labelOf(text)) && (words.direction || words.state != TestRole::notStated || senseIn(text));
}

} // namespace

bool OtherLines::takeUnit(std::size_t line, std::string_view text, bool ofPositions) {
    const std::string_view label = labelOf(text);
    if (!namesUnit(label, false))
        return false;
    const Meaning meaning = readHeading(label).meaning;
    const bool isOfPlaces = isOneOf(meaning, {Meaning::place, Meaning::target});
    const bool isOfValues = isOneOf(meaning, {Meaning::deviation, Meaning::reading, Meaning::actual});
    if (meaning != Meaning::unknown && !isOfPlaces && !isOfValues)
        return false; // "Temperature unit"
    const std::string value(withoutBlanks(text.substr(std::min(label.size() + 1, text.size()))));
    if (namesUnit(value, true))
        return false; // "UNIT: unit of the readings (mm if not stated)" explains
    SaidUnit said = saidUnit(value.empty() ? text : std::string_view(value));
    if (!said.isSaid() && !value.empty())
        said = saidUnit('(' + value + ')');
    const bool isWord = value.find_first_of("0123456789") == std::string::npos; // else "Unit no. 4"
    if (!said.isSaid() && isWord && (namesUnit(label, true) || isOfPlaces || isOfValues))
        said.foreign = value;
    if (!said.isSaid() || !isSize(said))
        return false;
    SaidUnit &unit = ofPositions || isOfPlaces ? m_positionUnit : m_unit;
    unit = unitOfBoth(unit, said);
    m_used.push_back({line, std::string(text)});
    return true;
}

void OtherLines::add(std::size_t line, std::string_view text, bool ofPositions) {
    if (takeUnit(line, text, ofPositions))
        return;
    const bool isRead = m_lines.size() < mostStatements;
    const HeadingWords words = isRead ? readHeading(text) : HeadingWords();
    const bool isOfRun = !isOneOf(words.meaning, {Meaning::statistic, Meaning::other});
    const bool isTitle = isRead && isTitleLine(text, words);
    if (m_direction.empty() && isTitle && isOfRun && words.direction)
        m_direction = text;
    (isRead && !isTitle ? m_lines : m_listed).push_back({line, std::string(text)});
}

void OtherLines::list(std::size_t line, std::string_view text) {
    if (!takeUnit(line, text, false))
        m_listed.push_back({line, std::string(text)});
}

FileNotes OtherLines::notes() const {
    TableBuilder builder;
    TableBody body;
    for (const Line &line : m_lines) {
        body.notes.push_back(static_cast<std::uint32_t>(body.notes.size()));
        builder.beginRow(line.number);
        builder.add(line.text);
    }
    FileNotes notes = notesOf(builder.take(), body, {});
    if (m_unit.isSaid())
        notes.unit = m_unit;
    if (m_positionUnit.isSaid())
        notes.positionUnit = m_positionUnit;
    for (const Line &line : m_used)
        notes.used.add(line.number, line.text);
    for (const Line &line : m_listed)
        notes.unused.add(line.number, line.text);
    return notes;
}

void OtherLines::askForKind(std::string_view title, Text question, Remarks &remarks) const {
    std::vector<Line> all = m_lines;
    all.insert(all.end(), m_listed.begin(), m_listed.end());
    all.push_back({0, std::string(title)});
    for (const Line &line : all) {
        if (const std::string word = otherQuantity(line.text); !word.empty()) {
            remarks.problem({"kind", line.number}, question, word);
            return;
        }
    }
}

SaidUnit unitOfBoth(const SaidUnit &first, const SaidUnit &second) {
    if (!first.isSaid() || !second.isSaid() || first == second)
        return first.isSaid() ? first : second;
    return {nullptr, first.words() + ", " + second.words()};
}

const Unit *resolveFixedUnit(std::string_view choice, const SaidUnit &said, const Unit &fixed,
                             Choices &choices, Remarks &remarks) {
    const bool agrees = !said.isSaid() || said.unit == &fixed;
    return resolveUnit(
        choice, said, agrees ? &fixed : nullptr, fixed,
        {.guessed = {},
         .contradiction = messageOf(
             choice == "positionUnit"
                 ? REPORT_TEXT("report", "Unit of the positions: the file says “%1”, but its format has them "
                                         "in %2; say the unit of the numbers.")
                 : REPORT_TEXT("report", "Unit of the readings: the file says “%1”, but its format has them "
                                         "in %2; say the unit of the numbers."),
             excerpt(said.words()), std::string(fixed.sign))},
        choices, remarks);
}

const Unit *resolveStatedUnit(std::string_view choice, const SaidUnit &said, const Unit &usual,
                              Choices &choices, Remarks &remarks) {
    return resolveUnit(choice, said, said.isSaid() ? said.unit : &usual, usual, {}, choices, remarks);
}

std::string resolveSaidSign(const SaidSign &said, std::string_view usual, Origin origin, Choices &choices,
                            Remarks &remarks) {
    const bool differs = !said.words.empty() && said.sign != usual;
    const auto sign = choices.resolve("sign", differs && !said.sign.empty() ? said.sign : usual,
                                      differs ? Origin::guessed : origin);
    if (differs && sign.origin == Origin::guessed)
        remarks.problem("sign",
                        sign.value == "targetMinusActual"
                            ? REPORT_TEXT("report", "Sign: the file says “%1”; read as target − actual.")
                            : REPORT_TEXT("report", "Sign: the file says “%1”; read as actual − target."),
                        excerpt(said.words));
    return sign.value;
}

std::size_t resolveMeasurement(const std::vector<std::string> &measurements, Choices &choices,
                               Remarks &remarks) {
    if (measurements.size() < 2)
        return 0;
    const auto choice = choices.resolve("table", "1", Origin::guessed);
    const double number = numberIn(choice.value).value_or(0);
    std::string list;
    std::vector<std::string> answers;
    for (const std::string &measurement : measurements) {
        answers.push_back(std::to_string(answers.size() + 1));
        list += (list.empty() ? "" : "; ") + answers.back() + ": " + measurement;
    }
    const auto index =
        static_cast<std::size_t>(std::ranges::find(answers, shortest(number)) - answers.begin());
    if (index == answers.size())
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; the file has %3 of them"),
                      nameOfChoice("table"), choice.value, std::to_string(answers.size()));
    remarks
        .problem("table",
                 REPORT_TEXT("report", "Table: the file has several, in the lines %1; number %2 is read."),
                 list, answers[index])
        .answers = answers;
    return index;
}

bool isKnownType(std::string_view type) {
    constexpr std::array<std::string_view, 6> known{"lin", "pos", "ang", "rot", "rta", "drift"};
    return std::ranges::none_of(type, [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; }) ||
           std::ranges::any_of(known, [&](std::string_view word) { return containsWord(type, word); });
}

bool isRotaryType(std::string_view type) {
    return containsWord(type, "rta") || containsWord(type, "rot");
}

} // namespace palmer
