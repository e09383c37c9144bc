// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/question.h"

#include "kernel/words/unit.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace palmer {

namespace {

Asked askedAs(std::string_view choice) {
    const ImportKey *key = findImportKey(choice);
    return key ? key->asked : Asked::never;
}

/// False for a word that a test of the kind cannot have: circles have lengths at angles.
bool fits(const ImportWord &word, std::string_view choice, Kind kind) {
    if (word.kind)
        return word.kind == kind;
    const Unit *unit = kind == Kind::circular ? unitOf(word.word) : nullptr;
    if (!unit || (choice != "unit" && choice != "positionUnit"))
        return true;
    return unit->kind == (choice == "unit" ? UnitKind::length : UnitKind::angle);
}

/// The words of a choice that a test of the kind can have; empty if all fit.
std::vector<std::string> fittingAnswers(std::string_view choice, std::optional<Kind> kind) {
    const std::span<const ImportWord> words = findImportKey(choice)->words;
    std::vector<std::string> answers;
    for (const ImportWord &word : words) {
        if (!kind || fits(word, choice, *kind))
            answers.emplace_back(word.word);
    }
    return answers.size() == words.size() ? std::vector<std::string>() : answers;
}

bool isGuessed(const Remark &remark, std::span<const ImportChoice> choices) {
    return std::ranges::any_of(choices, [&](const ImportChoice &choice) {
        return choice.key == remark.choice && choice.origin == Origin::guessed;
    });
}

std::string proposalFor(const Remark &remark, std::span<const ImportChoice> choices) {
    if (askedAs(remark.choice) == Asked::doubt)
        return std::string(keepAnswer);
    if (remark.isOwed)
        return {};
    if (askedAs(remark.choice) == Asked::owed && remark.grade == RemarkGrade::problem)
        return {}; // a placeholder to continue reading is not an answer
    const auto choice = std::ranges::find(choices, remark.choice, &ImportChoice::key);
    return choice == choices.end() ? std::string() : choice->value;
}

} // namespace

bool isAsked(std::string_view choice) {
    return askedAs(choice) != Asked::never;
}

void joinRemarks(Remarks &remarks) {
    constexpr std::size_t mostLines = 1000;
    std::map<std::tuple<RemarkGrade, std::string, std::string>, std::size_t> first;
    Remarks joined;
    for (Remark &remark : remarks) {
        const auto [place, isFirst] =
            first.try_emplace({remark.grade, remark.message.text.source, remark.choice}, joined.size());
        // Without a line the words tell them apart: one sensor, one run.
        const bool isOther = !isFirst && remark.line == 0 && remark.message != joined[place->second].message;
        if (isFirst || isOther) {
            place->second = joined.size();
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

std::vector<std::string> answersOf(const Question &question) {
    std::vector<std::string> answers = question.answers;
    const ImportKey *known = findImportKey(question.id);
    if (known && answers.empty()) {
        for (const ImportWord &word : known->words)
            answers.emplace_back(word.word);
    }
    const bool isDoubtful = !question.proposal.empty() && !question.canBeAssumed();
    if (isDoubtful && question.proposal != keepAnswer && known && answers.empty())
        answers.push_back(question.proposal);
    return answers;
}

std::vector<Question> takeQuestions(Remarks &remarks, const ImportOptions &options,
                                    std::span<const ImportChoice> choices, std::optional<Kind> kind) {
    std::vector<Question> questions;
    Remarks kept;
    for (Remark &remark : remarks) {
        std::string proposal = proposalFor(remark, choices);
        const auto answer = options.find(remark.choice);
        const bool isKept = answer != options.end() && answer->second == keepAnswer;
        if (isKept && remark.grade == RemarkGrade::note && isGuessed(remark, choices))
            continue; // only remarked, and confirmed
        const bool isAnswered = answer != options.end() && (!isKept || !proposal.empty());
        if (!isAsked(remark.choice) || remark.grade == RemarkGrade::note || isAnswered) {
            kept.push_back(std::move(remark));
            continue;
        }
        const bool isDoubtful = remark.grade == RemarkGrade::problem;
        if (remark.answers.empty())
            remark.answers = fittingAnswers(remark.choice, kind);
        questions.push_back({remark.choice, isDoubtful ? QuestionGrade::doubtful : QuestionGrade::assumed,
                             remark.message, std::move(proposal), remark.answers, remark.line, remark.column,
                             std::move(remark.further)});
    }
    remarks = std::move(kept);
    std::ranges::stable_sort(questions, {}, &Question::grade);
    return questions;
}

} // namespace palmer
