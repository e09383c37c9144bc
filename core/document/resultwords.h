// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/filewords.h"
#include "kernel/evaluation/evaluatesheet.h"
#include "kernel/evaluation/testevaluation.h"

#include <optional>
#include <string_view>

namespace palmer {

// Words for results, in files for scripts, the register and the settings.

template <>
inline constexpr auto fileWords<Verdict> = wordsInOrder<Verdict>("conforms", "notProven", "doesNotConform");
template <>
inline constexpr auto fileWords<Bound> = wordsInOrder<Bound>("magnitude", "upper", "lower");
template <>
inline constexpr auto fileWords<Grade> = wordsInOrder<Grade>("requirement", "recommendation", "note");
template <>
inline constexpr auto fileWords<Source> = wordsInOrder<Source>("text", "practice", "laboratory", "program");
template <>
inline constexpr auto fileWords<State> = wordsInOrder<State>("unmet", "undeclared");
template <>
inline constexpr auto fileWords<CircleOf> = wordsInOrder<CircleOf>("both", "counterclockwise", "clockwise");
template <>
inline constexpr auto fileWords<LimitState> = wordsInOrder<LimitState>("respected", "notProven",
                                                                       "notEvaluable", "exceeded");
template <>
inline constexpr auto
    fileWords<NotEvaluable> = wordsInOrder<NotEvaluable>("oneRun", "oneDirection", "oneSense",
                                                         "feedbackSignal", "notCalibrated", "notCalibrated",
                                                         "noSuchParameter", "otherEdition", "noValue");
template <>
inline constexpr auto fileWords<SheetState> = wordsInOrder<SheetState>("conforms", "notProven",
                                                                       "doesNotConform", "notMeasured",
                                                                       "noLimit", "notApplicable");
template <>
inline constexpr auto fileWords<SheetGap> = wordsInOrder<SheetGap>("noSuchTest", "noSuchParameter",
                                                                   "noValue");
template <>
inline constexpr auto fileWords<Accordance> = wordsInOrder<Accordance>("notChecked", "no", "notShown",
                                                                       "partly", "yes");

/// Returns the state of a test or parameter relative to its limits, independent of its accordance.
[[nodiscard]] constexpr const char *limitsWord(std::optional<Verdict> verdict) {
    return !verdict ? "noneAgreed"
                    : fileWord(*verdict == Verdict::conforms    ? LimitState::respected
                               : *verdict == Verdict::notProven ? LimitState::notProven
                                                                : LimitState::exceeded);
}

/// Returns the unit of results: mm or deg.
[[nodiscard]] constexpr const char *resultUnit(Quantity quantity) {
    return quantity == Quantity::angle || quantity == Quantity::angularDeviation ? "deg" : "mm";
}

} // namespace palmer
