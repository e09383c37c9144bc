// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/passes.h"

#include "document/place.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace palmer {

namespace {

/// Range of all readings.
struct PassRange {
    double low = INFINITY; ///< of the positions
    double high = -INFINITY;
    double lowValue = INFINITY;
    double highValue = -INFINITY;
    double difference = 0; ///< maximum difference of value and position
    std::size_t readings = 0;

    /// True if the values follow the positions; deviations differ from the farthest one by half of the range.
    [[nodiscard]] bool arePositions() const {
        const double size = std::max(high - low, std::abs(high));
        return readings > 1 && high > low && difference < 0.1 * size;
    }
};

PassRange passRange(const std::vector<Pass> &passes) {
    PassRange range;
    for (const Pass &pass : passes) {
        for (const PassReading &reading : pass.readings) {
            if (reading.isMissing)
                continue;
            ++range.readings;
            range.low = std::min(range.low, reading.position);
            range.high = std::max(range.high, reading.position);
            range.lowValue = std::min(range.lowValue, reading.value);
            range.highValue = std::max(range.highValue, reading.value);
            range.difference = std::max(range.difference, std::abs(reading.value - reading.position));
        }
    }
    return range;
}

/// Settles the choices of the form in turn, as each may depend on those before.
class FormSettler {
public:
    FormSettler(const PassRange &range, const StatedForm &stated, Choices &choices, Remarks &remarks)
        : m_stated(stated)
        , m_choices(choices)
        , m_remarks(remarks)
        , m_low(range.lowValue)
        , m_high(range.highValue)
        , m_farthest(range.readings > 0 ? std::max(std::abs(range.low), std::abs(range.high)) : 0)
        , m_followTargets(range.arePositions()) {}

    PassForm resolve() {
        resolveContent();
        resolveMotion();
        resolveUnits();
        resolveSign();
        return m_form;
    }

private:
    void ask(Message message, std::string_view choice) {
        m_remarks.add(RemarkGrade::assumption, choice, std::move(message));
    }

    void resolveContent() {
        const bool anyValue = m_low <= m_high;
        // Readings in a smaller unit than the targets are not positions.
        const Unit *unit = m_stated.unit.unit;
        const Unit *positionUnit = m_stated.positionUnit.unit;
        const bool isSmall =
            unit && positionUnit && !m_followTargets && unit->toBase(1) < positionUnit->toBase(1);
        // "Medida 1 (µm)" is a measured position to some and a measured deviation to others.
        const bool areSmall = std::max(std::abs(m_low), std::abs(m_high)) < 0.5 * m_farthest;
        const bool contradicted = m_stated.content == "positions" && !m_followTargets && anyValue && areSmall;
        const std::string stated = contradicted ? std::string() : m_stated.content;
        const bool known = !stated.empty() || ((isSmall || areNoPositions()) && !contradicted) || !anyValue;
        const auto settled = m_choices.resolve("content",
                                               !stated.empty()   ? stated
                                               : m_followTargets ? "positions"
                                                                 : "deviations",
                                               known ? Origin::recognised : Origin::guessed);
        m_form.content = settled.value;
        m_positions = m_form.content == "positions";
        if (settled.origin == Origin::guessed)
            ask({m_positions
                     ? REPORT_TEXT("report", "Content: the values run from %1 to %2 as the targets do; they "
                                             "are read as positions, not as deviations.")
                     : REPORT_TEXT("report", "Content: the values run from %1 to %2; they are read as "
                                             "deviations, not as positions."),
                 {Number{m_low, Quantity::number}, Number{m_high, Quantity::number}}},
                "content");
    }

    /// True if all values in the stated units are close to zero compared with the axis, so not positions.
    [[nodiscard]] bool areNoPositions() const {
        constexpr double part = 0.1; // of the farthest target
        const Unit *unit = m_stated.unit.unit;
        const Unit *positionUnit = m_stated.positionUnit.unit;
        return m_high > m_low && unit && positionUnit && unit->kind == positionUnit->kind &&
               unit->toBase(std::max(std::abs(m_low), std::abs(m_high))) <
                   part * positionUnit->toBase(m_farthest);
    }

    /// The kind of the chosen unit, otherwise of the stated one.
    [[nodiscard]] std::optional<UnitKind> kindOf(std::string_view key, const SaidUnit &said) const {
        const Unit *unit = m_choices.isChosen(key) ? unitOf(m_choices.chosen(key)) : said.unit;
        return unit && (unit->kind == UnitKind::length || unit->kind == UnitKind::angle)
                   ? std::optional(unit->kind)
                   : std::nullopt;
    }

    /// Settles the motion: the chosen one, otherwise from the units; if they differ, from the file's.
    void resolveMotion() {
        const auto position = kindOf("positionUnit", m_stated.positionUnit);
        const auto reading = kindOf("unit", m_stated.unit);
        const Unit *said = m_stated.positionUnit.unit ? m_stated.positionUnit.unit : m_stated.unit.unit;
        auto kind = position ? position : reading;
        if (position && reading && position != reading)
            kind = said ? std::optional(said->kind) : position;
        if (m_choices.isChosen("motion")) {
            kind = m_choices.chosen("motion") == "rotary" ? UnitKind::angle : UnitKind::length;
            requireUnitsOf(*kind);
        }
        m_angular = kind == UnitKind::angle;
        m_choices.resolve("motion", m_angular ? "rotary" : "linear",
                          kind ? Origin::recognised : Origin::guessed);
    }

    /// A chosen motion does not override stated units; the user must choose these too.
    void requireUnitsOf(UnitKind kind) const {
        const std::array stated{std::pair("positionUnit", &m_stated.positionUnit),
                                std::pair("unit", &m_stated.unit)};
        for (const auto &[key, said] : stated) {
            if (said->unit && said->unit->kind != kind && !m_choices.isChosen(key))
                refuseContent(REPORT_TEXT("report", "%1 cannot be %2 here: the file has its numbers in %3"),
                              nameOfChoice("motion"), nameOfWord("motion", m_choices.chosen("motion")),
                              said->words());
        }
    }

    [[nodiscard]] const Unit *fitting(const Unit *candidate) const {
        const UnitKind kind = m_angular ? UnitKind::angle : UnitKind::length;
        return candidate && candidate->kind == kind ? candidate : nullptr;
    }

    const Unit *resolveUnit(std::string_view key, const SaidUnit &said, const Unit *guess, Text question) {
        if (m_choices.isChosen(key) && !fitting(unitOf(m_choices.chosen(key))))
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 here: the axis moves the other way"),
                          nameOfChoice(key), nameOfWord(key, m_choices.chosen(key)));
        const bool isUnclear = key == "unit" ? !m_positions && !isClearSize() : areInInches();
        return palmer::resolveUnit(
            key, said, fitting(said.unit), *guess,
            {question, isUnclear ? RemarkGrade::problem : RemarkGrade::assumption, contradiction(said, key)},
            m_choices, m_remarks);
    }

    /// An angle along an axis in millimetres.
    [[nodiscard]] std::optional<Message> contradiction(const SaidUnit &said, std::string_view key) const {
        const Unit *position = m_stated.positionUnit.unit;
        const bool isAngle = said.unit && said.unit->kind == UnitKind::angle;
        if (key != "unit" || !isAngle || !position || position->kind != UnitKind::length)
            return std::nullopt;
        return Message{REPORT_TEXT("report", "Unit: the file says %1 for the readings and %2 "
                                             "for the targets. Angles along a linear axis (pitch, yaw) are "
                                             "no positioning test; where a heading is wrong, say the unit."),
                       {said.words(), std::string(position->sign)}};
    }

    /// True if deviations of that size fit one unit only: 3 is not mm, 0.003 not µm. In inches targets
    /// decide.
    [[nodiscard]] bool isClearSize() const {
        constexpr double smallest = 0.05;
        constexpr double largest = 1;
        const double size = m_low <= m_high ? std::max(std::abs(m_low), std::abs(m_high)) : 0;
        const Unit *along = m_form.positionUnit;
        const bool isBase =
            along && (std::string_view(along->word) == "mm" || std::string_view(along->word) == "deg");
        return isBase && size > 0 && (size < smallest || size >= largest);
    }

    /// True if the readings are in inches, so that positions without unit are hardly in mm.
    [[nodiscard]] bool areInInches() const {
        const Unit *unit = m_stated.unit.unit;
        return unit && (unit == unitOf("in") || unit == unitOf("uin"));
    }

    void resolveUnits() {
        const Unit *base = unitOf(m_angular ? "deg" : "mm");
        m_form.positionUnit = resolveUnit(
            "positionUnit",
            m_stated.positionUnit.isSaid() ? m_stated.positionUnit
            : m_positions                  ? SaidUnit{fitting(m_stated.unit.unit)}
                                           : SaidUnit{},
            areInInches() ? unitOf("in") : base,
            REPORT_TEXT("report", "Unit of the target positions: nothing in the file says it; read as %1."));
        const double largest = m_low <= m_high ? std::max(std::abs(m_low), std::abs(m_high)) : 0;
        constexpr double finestGuess = 0.5; // no deviation is half a millimetre or degree
        const Unit *small = unitOf(m_angular ? "arcsec" : "um");
        const Unit *guess = m_positions ? m_form.positionUnit : largest < finestGuess ? base : small;
        m_form.unit = resolveUnit(
            "unit", m_stated.unit, guess,
            m_positions
                ? REPORT_TEXT("report", "Unit of the positions: nothing in the file says it; read as %1.")
                : REPORT_TEXT("report", "Unit of the deviations: nothing in the file says it; read as %1 "
                                        "after their size."));
    }

    void resolveSign() {
        m_form.sign = "actualMinusTarget";
        if (m_positions)
            return;
        const bool proven = !m_stated.sign.empty();
        const bool said = !proven && !m_stated.said.sign.empty();
        const auto sign = m_choices.resolve("sign",
                                            proven ? m_stated.sign
                                            : said ? m_stated.said.sign
                                                   : std::string_view(m_form.sign),
                                            proven ? Origin::recognised : Origin::guessed);
        m_form.sign = sign.value;
        if (proven && sign.origin == Origin::recognised && sign.value == "targetMinusActual")
            m_remarks.note("sign",
                           REPORT_TEXT("report", "Sign: the positions beside the deviations tell that these "
                                                 "are target − actual; read so."));
        else if (sign.origin == Origin::guessed && said)
            ask({sign.value == "targetMinusActual"
                     ? REPORT_TEXT("report", "Sign: the file says “%1”; read as target − actual.")
                     : REPORT_TEXT("report", "Sign: the file says “%1”; read as actual − target."),
                 {m_stated.said.words}},
                "sign");
        else if (sign.origin == Origin::guessed && !m_stated.said.words.empty())
            m_remarks.problem("sign",
                              REPORT_TEXT("report", "Sign: the file says “%1”, which does not tell what is "
                                                    "subtracted from what; read as actual − target."),
                              m_stated.said.words);
        else if (sign.origin == Origin::guessed && m_stated.isCorrection)
            m_remarks.problem("sign",
                              REPORT_TEXT("report", "Sign: the file speaks of a correction, whose sign is "
                                                    "that of target − actual; read as actual − target."));
        else if (sign.origin == Origin::guessed)
            m_remarks.note(
                "sign", REPORT_TEXT("report", "Sign: nothing in the file says it; read as actual − target."));
    }

    const StatedForm &m_stated;
    Choices &m_choices;
    Remarks &m_remarks;
    PassForm m_form;
    double m_low;
    double m_high;
    double m_farthest; ///< target with the largest magnitude
    bool m_followTargets;
    bool m_positions = false;
    bool m_angular = false;
};

Message unreadable(std::string_view choice, const SaidUnit &said) {
    const Text question =
        choice == "positionUnit"
            ? REPORT_TEXT("report", "Unit of the positions: the file says “%1”, which cannot be read as it "
                                    "stands; say the unit of the numbers.")
        : choice == "timeUnit"
            ? REPORT_TEXT("report", "Unit of the times: the file says “%1”, which cannot be read as it "
                                    "stands; say the unit of the numbers.")
            : REPORT_TEXT("report", "Unit of the readings: the file says “%1”, which cannot be read as it "
                                    "stands; say the unit of the numbers.");
    return {question, {excerpt(said.words())}};
}

} // namespace

bool arePositions(const std::vector<Pass> &passes) {
    return passRange(passes).arePositions();
}

const Unit *resolveUnit(std::string_view choice, const SaidUnit &said, const Unit *found, const Unit &guess,
                        const UnitQuestion &question, Choices &choices, Remarks &remarks) {
    if (!found && !said.isSaid())
        found = unitOf(choices.usual(choice));
    const auto settled = choices.resolve(choice, found ? found->word : guess.word,
                                         found ? Origin::recognised : Origin::guessed);
    const Unit *unit = unitOf(settled.value);
    if (settled.origin == Origin::guessed && said.isSaid())
        remarks.add(RemarkGrade::problem, choice, question.contradiction.value_or(unreadable(choice, said)));
    else if (settled.origin == Origin::guessed)
        remarks.add(question.grade, choice, {question.guessed, {std::string(unit->sign)}});
    return unit;
}

PassForm resolveForm(const std::vector<Pass> &passes, const StatedForm &stated, Choices &choices,
                     Remarks &remarks) {
    return FormSettler(passRange(passes), stated, choices, remarks).resolve();
}

} // namespace palmer
