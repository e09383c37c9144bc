// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/question.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace palmer {

namespace {

/// Choices for which a wrong guess would give a wrong number or direction.
constexpr std::array<std::string_view, 27> asked{
    "kind",       "layout",        "columns",     "directions", "content", "unit",           "positionUnit",
    "timeUnit",   "sign",          "decimalMark", "axis",       "series",  "nominalRadius",  "sheet",
    "startAngle", "arc",           "motion",      "unread",     "large",   "correctionTo20", "spread",
    "zeros",      "equalsTargets", "unequalRuns", "hidden",     "state",   "table"};

/// Doubts about the numbers, answered by confirming them.
constexpr std::array<std::string_view, 5> doubts{"large", "spread", "equalsTargets", "zeros", "unequalRuns"};

/// Numbers not stated in the file, and stated units that cannot be used: only the user can answer.
constexpr std::array<std::string_view, 4> owed{"nominalRadius", "unit", "positionUnit", "timeUnit"};

template <std::size_t size>
bool isOneOf(const std::array<std::string_view, size> &words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

std::string proposalFor(const Remark &remark, std::span<const ImportChoice> choices) {
    if (isOneOf(doubts, remark.choice))
        return std::string(keepAnswer);
    if (remark.isOwed)
        return {};
    if (isOneOf(owed, remark.choice) && remark.grade == RemarkGrade::problem)
        return {}; // a placeholder to continue reading is not an answer
    const auto choice = std::ranges::find(choices, remark.choice, &ImportChoice::key);
    return choice == choices.end() ? std::string() : choice->value;
}

} // namespace

bool isAsked(std::string_view choice) {
    return isOneOf(asked, choice);
}

void joinRemarks(Remarks &remarks) {
    constexpr std::size_t mostLines = 1000;
    std::map<std::tuple<RemarkGrade, std::string, std::string>, std::size_t> first;
    Remarks joined;
    for (Remark &remark : remarks) {
        const auto [place, isNew] =
            first.try_emplace({remark.grade, remark.message.text.source, remark.choice}, joined.size());
        if (isNew) {
            joined.push_back(std::move(remark));
        } else {
            Remark &known = joined[place->second];
            ++known.times;
            if (known.further.size() < mostLines)
                known.further.push_back(remark.line);
        }
    }
    remarks = std::move(joined);
}

std::vector<Question> takeQuestions(Remarks &remarks, const ImportOptions &options,
                                    std::span<const ImportChoice> choices) {
    std::vector<Question> questions;
    Remarks kept;
    for (Remark &remark : remarks) {
        std::string proposal = proposalFor(remark, choices);
        const auto answer = options.find(remark.choice);
        const bool isAnswered =
            answer != options.end() && (answer->second != keepAnswer || !proposal.empty());
        if (!isOneOf(asked, remark.choice) || remark.grade == RemarkGrade::note || isAnswered) {
            kept.push_back(std::move(remark));
            continue;
        }
        const bool isDoubtful = remark.grade == RemarkGrade::problem;
        questions.push_back({remark.choice, isDoubtful ? QuestionGrade::doubtful : QuestionGrade::assumed,
                             remark.message, std::move(proposal), remark.answers, remark.line, remark.column,
                             std::move(remark.further)});
    }
    remarks = std::move(kept);
    std::ranges::stable_sort(questions, {}, &Question::grade);
    return questions;
}

} // namespace palmer
