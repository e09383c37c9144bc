// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/fileversion.h"
#include "kernel/evaluation/edition.h"

#include <array>
#include <optional>
#include <string_view>

namespace palmer {

/// A word of the file format, its value, and the oldest version of the format that has it.
template <class Enumeration>
struct FileWord {
    Enumeration value;
    const char *word = nullptr;
    long long since = firstVersion;
};

/// The text of a word, in a version later than the first: `Since{"annex", 3}`.
struct Since {
    constexpr Since(const char *text, long long version = firstVersion)
        : word(text)
        , since(version) {}

    const char *word = nullptr;
    long long since = firstVersion;
};

/// Returns the rows of an enumeration from its words in the order of its values, which count from 0.
template <class Enumeration, class... Words>
constexpr auto wordsInOrder(Words... words) {
    int next = 0;
    return std::array{
        FileWord<Enumeration>{static_cast<Enumeration>(next++), Since(words).word, Since(words).since}...};
}

/// The words of the file format, one table per enumeration: each word exists once.
template <class Enumeration>
inline constexpr auto fileWords = nullptr;

template <>
inline constexpr auto fileWords<Kind> = wordsInOrder<Kind>("positioning", "circular", "drift");
static_assert(fileWords<Kind>.size() == allKinds.size());
template <>
inline constexpr auto fileWords<Motion> = wordsInOrder<Motion>("linear", "rotary");
template <>
inline constexpr auto fileWords<ChannelQuantity> = wordsInOrder<ChannelQuantity>("deviation",
                                                                                 "angularDeviation");
template <>
inline constexpr auto fileWords<Direction> = wordsInOrder<Direction>("positive", "negative");
template <>
inline constexpr auto fileWords<Cycle> = wordsInOrder<Cycle>("standard", "step");
template <>
inline constexpr auto fileWords<DeviationMethod> = wordsInOrder<DeviationMethod>("calculation", "range");
template <>
inline constexpr auto fileWords<TargetChoiceKind> =
    std::to_array<FileWord<TargetChoiceKind>>({{TargetChoiceKind::free, "free"},
                                               {TargetChoiceKind::polygon, "polygon"},
                                               {TargetChoiceKind::fixed, "fixed"},
                                               {TargetChoiceKind::notStated, "notStated"}});
template <>
inline constexpr auto fileWords<Sense> = wordsInOrder<Sense>("counterclockwise", "clockwise");
template <>
inline constexpr auto fileWords<AngleReference> = wordsInOrder<AngleReference>("polar", "commanded");
template <>
inline constexpr auto fileWords<SignalSource> = wordsInOrder<SignalSource>("external", "feedback");
template <>
inline constexpr auto fileWords<Centring> = wordsInOrder<Centring>("leastSquares", "instrument");
template <>
inline constexpr auto fileWords<ReferenceCircle> = wordsInOrder<ReferenceCircle>("minimumZone",
                                                                                 "leastSquares");
template <>
inline constexpr auto fileWords<WarmUpKind> = wordsInOrder<WarmUpKind>("notStated", "procedure", "dryRun",
                                                                       "setUpOnly");
template <>
inline constexpr auto fileWords<SpecifiedBy> = wordsInOrder<SpecifiedBy>("notStated", "maker", "agreement");
template <>
inline constexpr auto fileWords<InstrumentCompensation> = wordsInOrder<InstrumentCompensation>("notStated",
                                                                                               "on", "off",
                                                                                               "none");
template <>
inline constexpr auto fileWords<Purpose> = wordsInOrder<Purpose>("notStated", "type", "acceptance",
                                                                 "comparison", "periodic", "compensation",
                                                                 "afterRepair", "afterCollision", "other");
template <>
inline constexpr auto fileWords<TestRole> = wordsInOrder<TestRole>("notStated", "asFound", "asLeft");
template <>
inline constexpr auto fileWords<FeedMode> = wordsInOrder<FeedMode>("programmed", "rapid");
template <>
inline constexpr auto fileWords<SensorMeasures> = wordsInOrder<SensorMeasures>("machine", "instrument", "air",
                                                                               "notStated");
template <>
inline constexpr auto fileWords<CorrectionTo20> = wordsInOrder<CorrectionTo20>("not stated", "not applied",
                                                                               "applied by the instrument",
                                                                               "applied here");
template <>
inline constexpr auto fileWords<Rule> = wordsInOrder<Rule>("simple acceptance", "ISO 14253-1",
                                                           "rejection proven");
template <>
inline constexpr auto fileWords<UncertaintyMethod> = wordsInOrder<UncertaintyMethod>("none", "budget",
                                                                                     "budgetActual",
                                                                                     "monteCarlo", "direct");
template <>
inline constexpr auto fileWords<DeviceKind> = wordsInOrder<DeviceKind>("certificate", "range");
template <>
inline constexpr auto fileWords<DriftModel> = wordsInOrder<DriftModel>("independent", "linear");
template <>
inline constexpr auto fileWords<CircleFigures> = wordsInOrder<CircleFigures>("combined", "separate");
template <>
inline constexpr auto fileWords<Rounding> = wordsInOrder<Rounding>("palmer", "twoDigits");
template <>
inline constexpr auto fileWords<Paper> = wordsInOrder<Paper>("A4", "Letter");
template <>
inline constexpr auto fileWords<ReportLanguage> = wordsInOrder<ReportLanguage>("fr", "en");
template <>
inline constexpr auto fileWords<Signer> = wordsInOrder<Signer>("operator", "laboratory", "supplier",
                                                               "customer");
template <>
inline constexpr auto fileWords<ReportExtra> = wordsInOrder<ReportExtra>("readingMarks", "meanRepeatability",
                                                                         "repetitions", "allReadings",
                                                                         Since("diagnosis", 2));
template <>
inline constexpr auto fileWords<ReportPart> = wordsInOrder<ReportPart>("readings", "targetTable",
                                                                       "uncertainty", "findings", "diagnosis",
                                                                       "signatures", "temperatureCurve",
                                                                       Since("annex", 3));
template <>
inline constexpr auto fileWords<AgreementState> = wordsInOrder<AgreementState>("notAgreed", "agreed",
                                                                               "notApplicable");

/// Returns the word of a value.
template <class Enumeration>
[[nodiscard]] constexpr const char *fileWord(Enumeration value) {
    for (const auto &row : fileWords<Enumeration>)
        if (row.value == value)
            return row.word;
    return "";
}

/// Returns the oldest version of the format that has the word of a value.
template <class Enumeration>
[[nodiscard]] constexpr long long sinceVersion(Enumeration value) {
    for (const auto &row : fileWords<Enumeration>)
        if (row.value == value)
            return row.since;
    return firstVersion;
}

/// The words of an enumeration as the placeholder of an option: "positioning|circular|drift".
template <class Enumeration>
inline constexpr auto wordsToChoose = [] {
    constexpr std::size_t size = [] {
        std::size_t sum = 0;
        for (const auto &row : fileWords<Enumeration>)
            sum += std::string_view(row.word).size() + 1;
        return sum;
    }();
    std::array<char, size> text{};
    std::size_t at = 0;
    for (const auto &row : fileWords<Enumeration>) {
        if (at > 0)
            text[at++] = '|';
        for (const char character : std::string_view(row.word))
            text[at++] = character;
    }
    return text; // the last character is the end
}();

/// Returns the value of a word, or null.
template <class Enumeration>
[[nodiscard]] constexpr std::optional<Enumeration> ofFileWord(std::string_view word) {
    for (const auto &row : fileWords<Enumeration>)
        if (row.word == word)
            return row.value;
    return std::nullopt;
}

} // namespace palmer
