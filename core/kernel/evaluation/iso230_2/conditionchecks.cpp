// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/commonchecks.h"
#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/iso230_2/correction.h"
#include "kernel/evaluation/iso230_2/sentences.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::iso230_2 {

namespace {

constexpr double roundingOfWriting = 1e-9; ///< for numbers as written
constexpr double hoursBefore = 12;

Number perHour(double value) {
    return {value, Quantity::gradient, -1};
}

Judgement temperatures(bool ofMachine, bool ofInstrument) {
    static constexpr std::array<Text, 3> names{Text{}, REPORT_TEXT("report", "temperature of the machine"),
                                               REPORT_TEXT("report", "temperature of the instrument")};
    return Judgement::lacking(State::unmet, missingOf(ofMachine, ofInstrument), names);
}

bool isAgreedState(const AgreedPoint &point) {
    return point.state == AgreementState::agreed;
}

} // namespace

Judgement instrumentCompensation(const PositioningCase &test) {
    if (isCorrectedTo20(test.common()))
        return Judgement::met();
    switch (test.common().instrumentCompensation) {
    case InstrumentCompensation::notStated:
        return Judgement::undeclared();
    case InstrumentCompensation::off:
        return Judgement::unmet();
    case InstrumentCompensation::on:
    case InstrumentCompensation::none:
        break;
    }
    return Judgement::met();
}

Judgement gradient(const PositioningCase &test) {
    const AgreedPoint *agreed = agreedPoint(test.test, "gradient");
    const PositioningConditions &conditions = test.conditions();
    if (agreed && !isAgreedState(*agreed))
        return Judgement::unmet({REPORT_TEXT("report", "No limit of the gradient was agreed.")});
    static constexpr std::array<Text, 3> names{
        Text{}, REPORT_TEXT("report", "temperature gradient over 12 h"),
        REPORT_TEXT("report", "agreed limit of the temperature gradient")};
    // A gradient over fewer hours says nothing about the twelve required.
    const auto &hours = conditions.gradientHoursBefore;
    const bool stated = conditions.gradientPerHour && hours && *hours >= hoursBefore - roundingOfWriting;
    Judgement missing =
        Judgement::lacking(State::undeclared, missingOf(stated, agreed && agreed->value), names);
    if (!agreed || !agreed->value || !conditions.gradientPerHour)
        return missing;
    if (std::abs(*conditions.gradientPerHour) > *agreed->value + roundingOfWriting)
        return Judgement::unmet({REPORT_TEXT("report", "Gradient %1, agreed limit %2."),
                                 {perHour(*conditions.gradientPerHour), perHour(*agreed->value)}});
    return missing;
}

Judgement dwell(const PositioningCase &test) {
    const auto &dwell = test.conditions().dwell;
    if (!dwell)
        return Judgement::undeclared();
    return *dwell > 0 ? Judgement::met() : Judgement::unmet();
}

Judgement feedAsAgreed(const PositioningCase &test) {
    const AgreedPoint *agreed = agreedPoint(test.test, "feed");
    const auto &feed = test.conditions().feed;
    if (agreed && !isAgreedState(*agreed))
        return Judgement::unmet();
    if (!agreed || !agreed->value || !feed)
        return Judgement::undeclared();
    if (std::abs(*feed - *agreed->value) <= roundingOfWriting * std::abs(*agreed->value))
        return Judgement::met();
    const Quantity quantity = feedQuantity(test.test);
    return Judgement::unmet({REPORT_TEXT("report", "Feed %1, agreed %2."),
                             {Number{*feed, quantity, -1}, Number{*agreed->value, quantity, -1}}});
}

Judgement feedOrRapid(const PositioningCase &test) {
    if (test.conditions().feedMode == FeedMode::rapid)
        return Judgement::met();
    return feedAsAgreed(test);
}

Judgement correction(const PositioningCase &test) {
    return common::correction(
        test.common(), lengthsAt20(test.measurement), [](const OtherTemperature &away) -> Message {
            return {away.of == SensorMeasures::machine
                        ? REPORT_TEXT("report", "Machine at %1, results not corrected to 20 °C.")
                        : REPORT_TEXT("report", "Instrument at %1, results not corrected to 20 °C."),
                    {Number{away.value, Quantity::temperature, 1}}};
        });
}

Sentence correctionImpossible(const PositioningCase &test) {
    return sentenceIf(
        test.linear() && test.common().correctionTo20 == CorrectionTo20::appliedHere &&
            !isCorrectedTo20(test.common()),
        REPORT_TEXT("report", "The correction to 20 °C cannot be applied: it needs the temperatures and the "
                              "coefficients of thermal expansion of machine and instrument (0 for a "
                              "laser whose compensation covers the air only)."));
}

Sentence correctionOfRotary(const PositioningCase &test) {
    return sentenceIf(!test.linear() && test.common().correctionTo20 == CorrectionTo20::appliedHere,
                      REPORT_TEXT("report", "A rotary axis has no correction to 20 °C: none was applied."));
}

Sentence expansionUncertainty(const PositioningCase &test) {
    const auto range = test.measurement.uncertainty.expansionRange.machine;
    constexpr double factor = 0.6;  // U/R of a quantity known only by its range
    constexpr double typical = 2.0; // µm/(m·°C), the typical minimum
    if (!test.linear() || !range || factor * *range >= typical)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The stated uncertainty of the expansion coefficient of the machine, %1, is below the "
                    "typical minimum of %2."),
        {Number{factor * *range, Quantity::expansion, 2}, Number{typical, Quantity::expansion, -1}}};
}

Judgement temperaturesOf2006(const PositioningCase &test) {
    const Conditions &conditions = test.common();
    using enum SensorMeasures;
    const bool ofInstrument =
        common::anyTemperature(conditions, instrument) ||
        (conditions.expansion.instrument == 0.0 && common::anyTemperature(conditions, air));
    return temperatures(common::anyTemperature(conditions, machine), ofInstrument);
}

Judgement temperaturesOfMachineAndInstrument(const PositioningCase &test) {
    return temperatures(common::anyTemperature(test.common(), SensorMeasures::machine),
                        common::anyTemperature(test.common(), SensorMeasures::instrument));
}

Judgement sensorsOf1988(const PositioningCase &test) {
    static constexpr std::array<Text, 3> names{Text{},
                                               REPORT_TEXT("report", "position of the temperature sensors"),
                                               REPORT_TEXT("report", "type of compensation")};
    return Judgement::lacking(State::unmet,
                              missingOf(common::machineSensorsPlaced(test.common()),
                                        test.common().correctionTo20 != CorrectionTo20::notStated),
                              names);
}

Judgement correctionStatements(const PositioningCase &test) {
    static constexpr std::array<Text, 7> names{
        Text{},
        REPORT_TEXT("report", "position of the temperature sensors"),
        REPORT_TEXT("report", "coefficient of thermal expansion of the machine"),
        REPORT_TEXT("report", "position of the temperature sensors, expansion coefficient of the machine"),
        REPORT_TEXT("report", "coefficient of thermal expansion of the instrument"),
        REPORT_TEXT("report", "position of the temperature sensors, expansion coefficient of the instrument"),
        REPORT_TEXT("report", "coefficients of thermal expansion of machine and instrument")};
    const Expansion &alpha = test.common().expansion;
    return Judgement::lacking(
        State::unmet, missingOf(common::machineSensorsPlaced(test.common()), alpha.machine, alpha.instrument),
        names);
}

Judgement namedInstrument(const PositioningCase &test) {
    return std::ranges::any_of(test.surroundings.instruments,
                               [](const Instrument *i) { return !isBlank(i->description); })
               ? Judgement::met()
               : Judgement::unmet();
}

} // namespace palmer::iso230_2
