// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/evaluation/edition.h"

#include <array>
#include <optional>
#include <string_view>

namespace palmer {

/// A word of the file format and its value.
template <class Enumeration>
struct FileWord {
    Enumeration value;
    const char *word = nullptr;
};

/// The words of the file format, one table per enumeration: each word exists once.
template <class Enumeration>
inline constexpr auto fileWords = nullptr;

template <>
inline constexpr auto fileWords<Kind> = std::to_array<FileWord<Kind>>({{Kind::positioning, "positioning"},
                                                                       {Kind::circular, "circular"},
                                                                       {Kind::drift, "drift"}});
template <>
inline constexpr auto fileWords<Motion> = std::to_array<FileWord<Motion>>({{Motion::linear, "linear"},
                                                                           {Motion::rotary, "rotary"}});
template <>
inline constexpr auto fileWords<Direction> = std::to_array<FileWord<Direction>>(
    {{Direction::positive, "positive"}, {Direction::negative, "negative"}});
template <>
inline constexpr auto fileWords<Cycle> = std::to_array<FileWord<Cycle>>({{Cycle::standard, "standard"},
                                                                         {Cycle::step, "step"}});
template <>
inline constexpr auto fileWords<DeviationMethod> = std::to_array<FileWord<DeviationMethod>>(
    {{DeviationMethod::calculation, "calculation"}, {DeviationMethod::range, "range"}});
template <>
inline constexpr auto fileWords<TargetChoiceKind> =
    std::to_array<FileWord<TargetChoiceKind>>({{TargetChoiceKind::free, "free"},
                                               {TargetChoiceKind::polygon, "polygon"},
                                               {TargetChoiceKind::fixed, "fixed"},
                                               {TargetChoiceKind::notStated, "notStated"}});
template <>
inline constexpr auto fileWords<Sense> = std::to_array<FileWord<Sense>>(
    {{Sense::counterclockwise, "counterclockwise"}, {Sense::clockwise, "clockwise"}});
template <>
inline constexpr auto fileWords<AngleReference> = std::to_array<FileWord<AngleReference>>(
    {{AngleReference::polar, "polar"}, {AngleReference::commanded, "commanded"}});
template <>
inline constexpr auto fileWords<SignalSource> = std::to_array<FileWord<SignalSource>>(
    {{SignalSource::external, "external"}, {SignalSource::feedback, "feedback"}});
template <>
inline constexpr auto fileWords<Centring> = std::to_array<FileWord<Centring>>(
    {{Centring::leastSquares, "leastSquares"}, {Centring::instrument, "instrument"}});
template <>
inline constexpr auto fileWords<ReferenceCircle> = std::to_array<FileWord<ReferenceCircle>>(
    {{ReferenceCircle::minimumZone, "minimumZone"}, {ReferenceCircle::leastSquares, "leastSquares"}});
template <>
inline constexpr auto
    fileWords<WarmUpKind> = std::to_array<FileWord<WarmUpKind>>({{WarmUpKind::notStated, "notStated"},
                                                                 {WarmUpKind::procedure, "procedure"},
                                                                 {WarmUpKind::dryRun, "dryRun"},
                                                                 {WarmUpKind::setUpOnly, "setUpOnly"}});
template <>
inline constexpr auto
    fileWords<SpecifiedBy> = std::to_array<FileWord<SpecifiedBy>>({{SpecifiedBy::notStated, "notStated"},
                                                                   {SpecifiedBy::maker, "maker"},
                                                                   {SpecifiedBy::agreement, "agreement"}});
template <>
inline constexpr auto fileWords<InstrumentCompensation> =
    std::to_array<FileWord<InstrumentCompensation>>({{InstrumentCompensation::notStated, "notStated"},
                                                     {InstrumentCompensation::on, "on"},
                                                     {InstrumentCompensation::off, "off"},
                                                     {InstrumentCompensation::none, "none"}});
template <>
inline constexpr auto
    fileWords<Purpose> = std::to_array<FileWord<Purpose>>({{Purpose::notStated, "notStated"},
                                                           {Purpose::type, "type"},
                                                           {Purpose::acceptance, "acceptance"},
                                                           {Purpose::comparison, "comparison"},
                                                           {Purpose::periodic, "periodic"},
                                                           {Purpose::compensation, "compensation"},
                                                           {Purpose::afterRepair, "afterRepair"},
                                                           {Purpose::afterCollision, "afterCollision"},
                                                           {Purpose::other, "other"}});
template <>
inline constexpr auto fileWords<TestRole> = std::to_array<FileWord<TestRole>>(
    {{TestRole::notStated, "notStated"}, {TestRole::asFound, "asFound"}, {TestRole::asLeft, "asLeft"}});
template <>
inline constexpr auto fileWords<FeedMode> =
    std::to_array<FileWord<FeedMode>>({{FeedMode::programmed, "programmed"}, {FeedMode::rapid, "rapid"}});
template <>
inline constexpr auto fileWords<SensorMeasures> =
    std::to_array<FileWord<SensorMeasures>>({{SensorMeasures::machine, "machine"},
                                             {SensorMeasures::instrument, "instrument"},
                                             {SensorMeasures::air, "air"},
                                             {SensorMeasures::notStated, "notStated"}});
template <>
inline constexpr auto fileWords<CorrectionTo20> = std::to_array<FileWord<CorrectionTo20>>(
    {{CorrectionTo20::notStated, "not stated"},
     {CorrectionTo20::notApplied, "not applied"},
     {CorrectionTo20::appliedByInstrument, "applied by the instrument"},
     {CorrectionTo20::appliedHere, "applied here"}});
template <>
inline constexpr auto
    fileWords<Rule> = std::to_array<FileWord<Rule>>({{Rule::simpleAcceptance, "simple acceptance"},
                                                     {Rule::iso14253_1, "ISO 14253-1"},
                                                     {Rule::rejectionProven, "rejection proven"}});
template <>
inline constexpr auto fileWords<UncertaintyMethod> =
    std::to_array<FileWord<UncertaintyMethod>>({{UncertaintyMethod::none, "none"},
                                                {UncertaintyMethod::budget, "budget"},
                                                {UncertaintyMethod::budgetActual, "budgetActual"},
                                                {UncertaintyMethod::monteCarlo, "monteCarlo"},
                                                {UncertaintyMethod::direct, "direct"}});
template <>
inline constexpr auto fileWords<DeviceKind> = std::to_array<FileWord<DeviceKind>>(
    {{DeviceKind::certificate, "certificate"}, {DeviceKind::range, "range"}});
template <>
inline constexpr auto fileWords<DriftModel> = std::to_array<FileWord<DriftModel>>(
    {{DriftModel::independent, "independent"}, {DriftModel::linear, "linear"}});
template <>
inline constexpr auto fileWords<CircleFigures> = std::to_array<FileWord<CircleFigures>>(
    {{CircleFigures::combined, "combined"}, {CircleFigures::separate, "separate"}});
template <>
inline constexpr auto fileWords<Paper> = std::to_array<FileWord<Paper>>({{Paper::a4, "A4"},
                                                                         {Paper::letter, "Letter"}});
template <>
inline constexpr auto fileWords<ReportLanguage> =
    std::to_array<FileWord<ReportLanguage>>({{ReportLanguage::fr, "fr"}, {ReportLanguage::en, "en"}});
template <>
inline constexpr auto
    fileWords<Signer> = std::to_array<FileWord<Signer>>({{Signer::operatorSigns, "operator"},
                                                         {Signer::laboratory, "laboratory"},
                                                         {Signer::supplier, "supplier"},
                                                         {Signer::customer, "customer"}});
template <>
inline constexpr auto fileWords<ReportExtra> =
    std::to_array<FileWord<ReportExtra>>({{ReportExtra::readingMarks, "readingMarks"},
                                          {ReportExtra::meanRepeatability, "meanRepeatability"},
                                          {ReportExtra::repetitions, "repetitions"},
                                          {ReportExtra::allReadings, "allReadings"},
                                          {ReportExtra::diagnosis, "diagnosis"}});
template <>
inline constexpr auto fileWords<ReportPart> =
    std::to_array<FileWord<ReportPart>>({{ReportPart::readings, "readings"},
                                         {ReportPart::targetTable, "targetTable"},
                                         {ReportPart::uncertainty, "uncertainty"},
                                         {ReportPart::findings, "findings"},
                                         {ReportPart::diagnosis, "diagnosis"},
                                         {ReportPart::signatures, "signatures"},
                                         {ReportPart::temperatureCurve, "temperatureCurve"}});
template <>
inline constexpr auto fileWords<AgreementState> =
    std::to_array<FileWord<AgreementState>>({{AgreementState::notAgreed, "notAgreed"},
                                             {AgreementState::agreed, "agreed"},
                                             {AgreementState::notApplicable, "notApplicable"}});

/// Returns the word of a value.
template <class Enumeration>
[[nodiscard]] constexpr const char *fileWord(Enumeration value) {
    for (const auto &row : fileWords<Enumeration>)
        if (row.value == value)
            return row.word;
    return "";
}

/// Returns the value of a word, or null.
template <class Enumeration>
[[nodiscard]] constexpr std::optional<Enumeration> ofFileWord(std::string_view word) {
    for (const auto &row : fileWords<Enumeration>)
        if (row.word == word)
            return row.value;
    return std::nullopt;
}

} // namespace palmer
