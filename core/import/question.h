// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/remark.h"
#include "kernel/measurement/test.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

enum class QuestionGrade {
    doubtful, ///< something contradicts it, or data were not read: each needs its own answer
    assumed,  ///< not stated by the file, the usual is assumed: all can be confirmed together
};

/// The answer that accepts the proposal of any question.
inline constexpr std::string_view keepAnswer = "keep";

/// A question that must be answered before a measurement is accepted.
struct Question {
    std::string id; ///< key of the choice that answers it
    QuestionGrade grade = QuestionGrade::assumed;
    Message sentence;
    std::string proposal; ///< the value used without an answer; empty if there is none
    std::vector<std::string> answers =
        {};               ///< possible answers, if the choice does not define them: sheets, axes
    std::size_t line = 0; ///< as in Remark
    std::size_t column = 0;
    std::vector<std::size_t> further = {}; ///< further lines it applies to

    /// True if it can be confirmed together with others.
    [[nodiscard]] bool canBeAssumed() const { return grade == QuestionGrade::assumed && !proposal.empty(); }

    bool operator==(const Question &) const = default;
};

/// Returns the words that answer a question: its own, those of its choice, or what is proposed for a doubtful
/// one without either. Empty if any value may answer.
[[nodiscard]] std::vector<std::string> answersOf(const Question &question);

/// Extracts the questions from the remarks: those about a choice that changes numbers and was only guessed,
/// and those about data that were not read. Repeated ones are merged, with the further lines. A question of a
/// test of a kind offers only the words that fit it.
[[nodiscard]] std::vector<Question> takeQuestions(Remarks &remarks, const ImportOptions &options,
                                                  std::span<const ImportChoice> choices,
                                                  std::optional<Kind> kind = {});

/// Merges remarks of a kind, with the further lines.
void joinRemarks(Remarks &remarks);

/// True if a wrong guess of that choice would give a wrong number or direction, so that it is a question.
[[nodiscard]] bool isAsked(std::string_view choice);

/// Adds red questions about suspicious numbers, each with its run: deviations above 1 mm or 0.1°, runs whose
/// spread is a hundred times that of the others, deviations equal to the targets, readings that are all 0.
void questionNumbers(const Test &test, Remarks &remarks);

} // namespace palmer
