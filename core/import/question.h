// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/remark.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

enum class QuestionGrade {
    doubtful, ///< something speaks against it, or data were left unread: each wants an answer of its own
    assumed,  ///< the file does not say it and the usual holds: all of them can be taken at once
};

/// The answer to any question that proposes something: what was read is right.
inline constexpr std::string_view keepAnswer = "keep";

/// What has to be answered before a measurement is accepted: an answer is owed, no remark to be read over.
struct Question {
    std::string id; ///< key of the choice that answers it
    QuestionGrade grade = QuestionGrade::assumed;
    Message sentence;
    std::string proposal; ///< the word taken without an answer; empty: nothing is proposed
    std::vector<std::string> answers =
        {};               ///< the words there are, if the choice does not say them: sheets, axes
    std::size_t line = 0; ///< as of a remark
    std::size_t column = 0;
    std::vector<std::size_t> further = {}; ///< lines it holds for, too

    /// Whether it is taken with all the others that are.
    [[nodiscard]] bool canBeAssumed() const { return grade == QuestionGrade::assumed && !proposal.empty(); }

    bool operator==(const Question &) const = default;
};

/// Takes the questions out of the remarks: those about a choice that changes numbers and was only guessed,
/// and those about data that were not read. What is said several times is said once, with the further lines.
[[nodiscard]] std::vector<Question> takeQuestions(std::vector<Remark> &remarks, const ImportOptions &options,
                                                  std::span<const ImportChoice> choices);

/// One remark for those of one kind, with the lines of the further ones.
void joinRemarks(std::vector<Remark> &remarks);

} // namespace palmer
