// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/filewords.h"
#include "kernel/evaluation/testevaluation.h"

#include <optional>
#include <string_view>

namespace palmer {

// Words for results, in files for scripts, the register and the settings.

template <>
inline constexpr auto
    fileWords<Verdict> = std::to_array<FileWord<Verdict>>({{Verdict::conforms, "conforms"},
                                                           {Verdict::notProven, "notProven"},
                                                           {Verdict::doesNotConform, "doesNotConform"}});
template <>
inline constexpr auto fileWords<Grade> = std::to_array<FileWord<Grade>>(
    {{Grade::requirement, "requirement"}, {Grade::recommendation, "recommendation"}, {Grade::note, "note"}});
template <>
inline constexpr auto fileWords<Source> = std::to_array<FileWord<Source>>({{Source::text, "text"},
                                                                           {Source::practice, "practice"},
                                                                           {Source::laboratory, "laboratory"},
                                                                           {Source::program, "program"}});
template <>
inline constexpr auto fileWords<State> = std::to_array<FileWord<State>>({{State::unmet, "unmet"},
                                                                         {State::undeclared, "undeclared"}});
template <>
inline constexpr auto
    fileWords<CircleOf> = std::to_array<FileWord<CircleOf>>({{CircleOf::both, "both"},
                                                             {CircleOf::counterclockwise, "counterclockwise"},
                                                             {CircleOf::clockwise, "clockwise"}});
template <>
inline constexpr auto
    fileWords<LimitState> = std::to_array<FileWord<LimitState>>({{LimitState::respected, "respected"},
                                                                 {LimitState::notProven, "notProven"},
                                                                 {LimitState::notEvaluable, "notEvaluable"},
                                                                 {LimitState::exceeded, "exceeded"}});
template <>
inline constexpr auto fileWords<NotEvaluable> =
    std::to_array<FileWord<NotEvaluable>>({{NotEvaluable::oneRun, "oneRun"},
                                           {NotEvaluable::oneDirection, "oneDirection"},
                                           {NotEvaluable::oneSense, "oneSense"},
                                           {NotEvaluable::feedbackSignal, "feedbackSignal"},
                                           {NotEvaluable::notCalibrated, "notCalibrated"},
                                           {NotEvaluable::calibrationOpen, "notCalibrated"},
                                           {NotEvaluable::noSuchParameter, "noSuchParameter"},
                                           {NotEvaluable::otherEdition, "otherEdition"},
                                           {NotEvaluable::noValue, "noValue"}});
template <>
inline constexpr auto
    fileWords<Accordance> = std::to_array<FileWord<Accordance>>({{Accordance::notChecked, "notChecked"},
                                                                 {Accordance::no, "no"},
                                                                 {Accordance::notShown, "notShown"},
                                                                 {Accordance::partly, "partly"},
                                                                 {Accordance::yes, "yes"}});

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
